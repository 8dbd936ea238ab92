// Scene → POV-Ray. What is written, feature by feature, stands in docs/export.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer::reference {

/// Which picture of a scene is meant.
struct ExportView {
    std::uint32_t camera = 0;  ///< index into Scene::cameras
    int width = 640;
    int height = 480;
};

/// 3 x 3 points of a picture instead of the whole, for asking POV-Ray about one pixel.
struct CloseUp {
    double x = 0;                     ///< of the middle one, in pixels from the left
    double y = 0;                     ///< and from the top
    double pitch = 0;                 ///< pixels
    static constexpr int points = 3;  ///< on each side
};

struct ExportOptions {
    /// Names the scene in the header comment and begins the names of the assets. A plain file name.
    std::string name = "scene";
    /// Multiplies every light, the ambient light, emission and the background: a picture whose
    /// values pass 1 would be clipped in a PNG. The other side of a comparison is multiplied by it
    /// as well.
    double exposure = 1;
    /// Lengths stay those of the scene wherever POV-Ray can stand them: easier to read and to work
    /// on, but its constants (no hits nearer than 1e-4, no shadows nearer than 1e-3) show in more
    /// pixels.
    bool keep_lengths = false;
    /// Lengths are multiplied by ten to this power instead, whatever POV-Ray makes of them: for
    /// finding out where its constants begin to show.
    std::optional<int> decades{};
    /// Where faces coincide, which POV-Ray resolves by no rule, objects grow or move by a few
    /// thousandths of POV-Ray's unit, so that POV-Ray must do as Lancer's contact rule says; and
    /// the whole is larger, so that nobody sees it. For asking POV-Ray what it makes of that.
    bool resolve_coincidences = false;
    /// The camera looks at this place of the view's picture alone.
    std::optional<CloseUp> close_up{};
};

/// A file that must stand beside the `.pov`.
struct Asset {
    std::string name;  ///< without folders
    std::string bytes;
};

/// Something POV-Ray does otherwise by rule, in this scene, at these objects.
struct KnownDifference {
    enum class Rule {
        absorption_inside,    ///< no absorption on what the inner side of a surface shows
        absorption_nested,    ///< no absorption on a stretch that ends on another body
        absorption_smooth,    ///< absorption by what bends light, not by the place
        sheet_in_medium,      ///< a transparent sheet inside a body bends light
        fresnel_nested,       ///< no Fresnel reflection on leaving a body inside another
        contribution,         ///< adc_bailout asks for the grey value of what passes as well
        depth_limit,          ///< max_trace_level: at most 256, and at 1 nothing passes through
        small_features,       ///< hits nearer than 1e-4, shadows nearer than 1e-3 are dropped
        far_away,             ///< nothing is seen beyond 1e7
        coincident_surfaces,  ///< faces in one place: one of them is found, by no rule
        light_from_behind,    ///< a shadow ray on the far side starts with the viewer's media
        patch_facets,         ///< flat triangles under mixed normals
        index_single,         ///< indices of refraction in single precision
    };
    Rule rule;
    std::string explanation;  ///< one sentence: POV-Ray's rule, and ours
    std::vector<std::uint32_t>
        objects;  ///< indices into Scene::objects where it can show; may be empty
};

/// Faces of two objects in one place.
struct Coincidence {
    /// How it is resolved by moving one of the two a little, as Lancer's contact rule resolves it.
    enum class Resolution {
        hidden,      ///< opaque on opaque: no ray gets there
        sunk,        ///< a clear body on an opaque surface: sunk into it
        merged,      ///< one glass, glued: one body
        overlapped,  ///< clear bodies of two materials, face to face: entered before left
        in_front,    ///< one face in front of another: the opaque one, of two the first declared
        none,        ///< clear in clear, a clear sheet on clear glass, two sheets: no such way
    };
    std::uint32_t first = 0;  ///< index into Scene::objects
    std::uint32_t second = 0;
    Resolution resolution = Resolution::none;
};

/// "glued, one body" and so on.
std::string resolution_name(Coincidence::Resolution resolution);

/// "absorption-inside" and so on: the name used in reports and in docs/export.md.
std::string rule_name(KnownDifference::Rule rule);

/// Something that POV-Ray can only come near to.
struct Approximation {
    std::string explanation;  ///< what, and how near
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
    /// With resolve_coincidences: the scene that `text` says, but for bodies that are merged there.
    std::shared_ptr<const Scene> resolved;
    double unit = 1;  ///< POV-Ray's unit of length in the scene's: 1 / factor
    /// Of the patches, in the order of Scene::patches: POV-Ray draws each as 2^h x 2^h x 2
    /// triangles.
    std::vector<int> patch_halvings;
    /// Errors, each at its place: what POV-Ray has no word for. Nothing is left out silently.
    std::vector<Diagnostic> refusals;
};

/// Writes the scene as POV-Ray 3.7 would have to say it. The scene must be free of errors and
/// `view` must name a camera of it. Reads no file and writes none.
ExportResult export_pov(const Scene& scene, const ExportView& view,
                        const ExportOptions& options = {});

}  // namespace lancer::reference
