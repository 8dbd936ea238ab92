// The scalar code as wide code calls it: with plain numbers, through virtual functions.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lancer::wide {

/// One ray, as Ray<double>.
struct LaneRay {
    double origin[3], origin_lo[3], dir[3];
    double dir_squared, inv_squared, origin_error, filter_error;
    double inv_dir[3];
    bool whole;
};

/// Lists of bodies that are longer are scalar code's.
inline constexpr int most_bodies = 4;

/// What a ray starts on, if anything, what it leaves for good, and what it is inside of.
struct LaneStart {
    std::uint32_t item, face;
    bool entering;
    std::uint32_t left;
    std::uint32_t bodies[most_bodies];  ///< in the order entered, then `nothing`
};

struct LaneHit {
    double t, error, u, v;
    std::uint32_t item, face;
    bool entering;
};

/// Surface<double>, as far as it does not follow from the hit.
struct LaneSurface {
    double position[3], position_lo[3], geometric[3], normal[3], color[3];
    double error, opacity;
    bool outermost;
};

struct LaneLight {
    double direction[3], color[3];
    double distance;
};

/// Gets crossings that count.
struct HitSink {
    void* self;
    double (*limit)(void* self);
    void (*add)(void* self, const LaneHit& hit);
};

/// Gets light.
struct LightSink {
    void* self;
    void (*add)(void* self, const double* light);
};

/// The exact methods: what wide code asks where it is unsure, one ray at a time. Rays carry their
/// own counts.
class ExactMethods {
  public:
    /// The light that a ray brings; in worlds without glassy items, as `shade`.
    virtual void trace(const LaneRay& ray, const LaneStart& start, double weight, int depth,
                       double* color) = 0;
    /// The same where there are glassy items, term by term.
    ///
    /// \param through  what the surfaces before let pass of it
    virtual void follow(const LaneRay& ray, const LaneStart& start, double weight, int depth,
                        const double* through, const LightSink& sink) = 0;
    /// The light that a ray brings where it is known what it meets first.
    virtual void shade(const LaneRay& ray, const LaneHit& hit, double weight, int depth,
                       double* color) = 0;
    /// What a ray brings that hits nothing.
    virtual void behind(const double* direction, double* color) = 0;
    virtual void surface(const LaneRay& ray, const LaneHit& hit, LaneSurface& surface) = 0;
    virtual void light(std::size_t index, const double* position, const double* position_lo,
                       LaneLight& light) = 0;
    /// The crossings with one item up to the sink's limit that count.
    virtual void crossings(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                           const HitSink& sink) = 0;
    /// Whether the item lies on the way to a light.
    virtual bool blocks(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                        double distance) = 0;
    /// The share of a light that reaches the start of a ray, by colour.
    virtual void light_share(const LaneRay& ray, const LaneStart& start, double distance,
                             double* share) = 0;

  protected:
    ~ExactMethods() = default;
};

}  // namespace lancer::wide
