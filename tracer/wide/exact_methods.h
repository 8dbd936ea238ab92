// The interface through which wide code calls scalar code: plain numbers and virtual functions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tracer/wide/scene.h"

namespace lancer::wide {

/// One ray: Ray<double>.
struct LaneRay {
    double origin[3], origin_lo[3], dir[3];
    double dir_squared, inv_squared, origin_error, filter_error;
    double inv_dir[3];
    bool whole;
};

/// The longest list of bodies in wide code. Scalar code traces rays with longer ones.
inline constexpr int most_bodies = 4;

/// The item that a ray starts on, the item that it leaves for good (both may be `nothing`), and the
/// bodies that it is inside of.
struct LaneStart {
    std::uint32_t item, face;
    bool entering;
    std::uint32_t left;
    std::uint32_t bodies[most_bodies];   ///< in the order entered; unused places hold `nothing`
    std::uint32_t optical[most_bodies];  ///< Media::optical, like `bodies`
};

struct LaneHit {
    double t, error, u, v;
    std::uint32_t item, face;
    bool entering;
};

/// Those members of Surface<double> that do not follow from the hit alone.
struct LaneSurface {
    double position[3], position_lo[3], geometric[3], normal[3], color[3];
    double error, opacity;
    bool outermost;
};

struct LaneLight {
    double direction[3], color[3];
    double distance;
};

/// Receives crossings that count.
struct HitSink {
    void* self;
    double (*limit)(void* self);
    void (*add)(void* self, const LaneHit& hit);
};

/// A ray as it sees the pieces of a patch: PieceStart<double> and Shear<double>.
struct PieceLine {
    double at[3], noise;
    double sx, sy, sz;
    int x, y, z;
};

/// Part of a piece's square, and the coefficients there of the plane's map.
struct PlanePart {
    double net[16][2];
    double u, v, du, dv;
};

/// Receives terms of light.
struct LightSink {
    void* self;
    void (*add)(void* self, const double* light);
};

/// The exact methods, which wide code calls for one ray at a time where it is unsure. They count
/// their own rays.
class ExactMethods {
  public:
    /// The light that a ray brings; in worlds without glassy items, as `shade`.
    virtual void trace(const LaneRay& ray, const LaneStart& start, double weight, int depth,
                       double* color) = 0;
    /// The same for worlds with glassy items, term by term.
    ///
    /// \param through  what the surfaces before let pass of it
    virtual void follow(const LaneRay& ray, const LaneStart& start, double weight, int depth,
                        const double* through, const LightSink& sink) = 0;
    /// The light that a ray brings where it is known what it meets first.
    virtual void shade(const LaneRay& ray, const LaneHit& hit, double weight, int depth,
                       double* color) = 0;
    /// The colour of a ray that hits nothing.
    virtual void behind(const double* direction, double* color) = 0;
    virtual void surface(const LaneRay& ray, const LaneHit& hit, LaneSurface& surface) = 0;
    virtual void light(std::size_t index, const double* position, const double* position_lo,
                       LaneLight& light) = 0;
    /// The crossings with one item that count, up to the sink's limit.
    virtual void crossings(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                           const HitSink& sink) = 0;
    /// The pieces of a patch, which are cut when they are first asked for.
    virtual void patch(std::uint32_t item, PatchShape& shape) = 0;
    /// All crossings of a line with a piece, without an item; its limit is not asked.
    ///
    /// \param part  of the piece that is left to look at; null: all
    virtual void piece_crossings(const PatchPiece& piece, const PieceLine& line,
                                 const PlanePart* part, const HitSink& sink) = 0;
    /// Whether the item blocks the way to a light.
    virtual bool blocks(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                        double distance) = 0;
    /// The share of a light that reaches the start of a ray, per channel.
    virtual void light_share(const LaneRay& ray, const LaneStart& start, double distance,
                             double* share) = 0;

  protected:
    ~ExactMethods() = default;
};

}  // namespace lancer::wide
