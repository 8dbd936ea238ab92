// Scene → POV-Ray. docs/export.md describes the output, feature by feature.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer::reference {

/// The camera and the size of the picture.
struct ExportView {
    std::uint32_t camera = 0;  ///< index into Scene::cameras
    int width = 640;
    int height = 480;
};

/// 3 x 3 points of a picture instead of the whole, to examine one pixel in POV-Ray.
struct CloseUp {
    double x = 0;                     ///< of the middle point, in pixels from the left
    double y = 0;                     ///< and from the top
    double pitch = 0;                 ///< pixels
    static constexpr int points = 3;  ///< on each side
};

struct ExportOptions {
    /// Names the scene in the header comment; the names of assets begin with it. A plain file name.
    std::string name = "scene";
    /// Multiplies every light, the ambient light, emission and the background, because a PNG clips
    /// values above 1. The other picture of a comparison is multiplied as well.
    double exposure = 1;
    /// Keeps the scene's lengths wherever POV-Ray can handle them. The file is easier to read and
    /// to edit, but POV-Ray's constants (no hits nearer than 1e-4, no shadows nearer than 1e-3)
    /// show in more pixels.
    bool keep_lengths = false;
    /// If set, lengths are multiplied by ten to this power, even if POV-Ray cannot handle the
    /// result: to find out where its constants begin to show.
    std::optional<int> decades{};
    /// POV-Ray has no rule for coincident faces. With this option, objects grow or move by a few
    /// thousandths of POV-Ray's unit, so that POV-Ray follows Lancer's contact rule. The whole
    /// scene is larger, so that the change is invisible.
    bool resolve_coincidences = false;
    /// Only this place of the view's picture is rendered.
    std::optional<CloseUp> close_up{};
};

/// A file that must be beside the `.pov`.
struct Asset {
    std::string name;  ///< without folders
    std::string bytes;
};

/// A rule by which POV-Ray differs in this scene, and the objects concerned.
struct KnownDifference {
    enum class Rule {
        absorption_inside,    ///< no absorption of what the inner side of a surface shows
        absorption_nested,    ///< no absorption on a path that ends at another body
        absorption_smooth,    ///< absorption depends on what bends light, not on the place
        sheet_in_medium,      ///< a transparent sheet inside a body refracts light
        fresnel_nested,       ///< no Fresnel reflection on leaving a body inside another
        contribution,         ///< adc_bailout also tests the grey value of what passes
        depth_limit,          ///< max_trace_level: at most 256, and at 1 nothing passes through
        small_features,       ///< hits nearer than 1e-4, shadows nearer than 1e-3 are dropped
        far_away,             ///< nothing is seen beyond 1e7
        coincident_surfaces,  ///< coincident faces: one of them is found, by no rule
        light_from_behind,    ///< a shadow ray on the far side starts with the viewer's media
        patch_facets,         ///< flat triangles under mixed normals
        index_single,         ///< indices of refraction in single precision
    };
    Rule rule;
    std::string explanation;  ///< one sentence: POV-Ray's rule, and ours
    std::vector<std::uint32_t>
        objects;  ///< indices into Scene::objects where it can show; may be empty
};

/// Coincident faces of two objects.
struct Coincidence {
    /// How moving one of the two slightly gives the result of Lancer's contact rule.
    enum class Resolution {
        hidden,      ///< opaque on opaque: no ray reaches them
        sunk,        ///< a clear body on an opaque surface: it is sunk into it
        merged,      ///< glued bodies of the same glass become one
        overlapped,  ///< clear bodies of two materials, face to face: entered before left
        in_front,    ///< the opaque face in front; of two opaque ones, the first declared
        none,        ///< clear in clear, a clear sheet on clear glass, two sheets: no resolution
    };
    std::uint32_t first = 0;  ///< index into Scene::objects
    std::uint32_t second = 0;
    Resolution resolution = Resolution::none;
};

/// "glued, one body" and so on.
std::string resolution_name(Coincidence::Resolution resolution);

/// "absorption-inside" and so on: the name used in reports and in docs/export.md.
std::string rule_name(KnownDifference::Rule rule);

/// A feature that POV-Ray can only approximate.
struct Approximation {
    std::string explanation;  ///< what, and how accurately
    SourceSpan where;
};

struct ExportResult {
    std::string text;           ///< the `.pov`; empty when something was refused
    std::vector<Asset> assets;  ///< images, by the names that `text` uses
    double factor = 1;    ///< lengths in `text` = lengths in the scene times this power of ten
    int decades = 0;      ///< its exponent
    double exposure = 1;  ///< as in the options
    std::vector<KnownDifference> known_differences;
    std::vector<Approximation> approximations;
    std::vector<Coincidence> coincidences;
    /// With resolve_coincidences: the scene that `text` describes.
    std::shared_ptr<const Scene> resolved;
    double unit = 1;  ///< POV-Ray's unit of length in units of the scene: 1 / factor
    /// For each element of Scene::patches: POV-Ray draws every patch as 2^h x 2^h x 2 triangles.
    std::vector<int> patch_halvings;
    /// Errors with places: features that POV-Ray does not have. Nothing is dropped silently.
    std::vector<Diagnostic> refusals;
};

/// Writes the scene for POV-Ray 3.7. The scene must be free of errors and `view` must name one of
/// its cameras. Reads and writes no files.
ExportResult export_pov(const Scene& scene, const ExportView& view,
                        const ExportOptions& options = {});

}  // namespace lancer::reference
