#include "judge/explain/edges.h"

#include <optional>
#include <utility>

namespace lancer::judge {

namespace {

/// The distance from a pixel's centre over which its slope is measured, in pixels.
constexpr double step = 0.01;
/// A step this many times larger than the slopes on both sides predict is an edge.
constexpr double sharpness = 4;

/// Finds edges between neighbours. A probe is a ray with its whole tree, so none is repeated, and
/// none is taken that cannot matter any more.
class EdgeFinder {
  public:
    EdgeFinder(const Image& image, const ProbeFunction& probe, double contrast)
        : image_(image), probe_(probe), contrast_(contrast), centres_(pixels()), edges_(pixels()) {}

    Mask run() {
        for (int y = 0; y < image_.height; ++y) {
            for (int x = 0; x < image_.width; ++x) {
                if (x + 1 < image_.width) look(x, y, 1, 0);
                if (y + 1 < image_.height) look(x, y, 0, 1);
            }
        }
        return std::move(edges_);
    }

  private:
    std::size_t pixels() const {
        return static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height);
    }
    void look(int x, int y, int dx, int dy) {
        std::uint8_t& here = edges_[index_of(image_, x, y)];
        std::uint8_t& there = edges_[index_of(image_, x + dx, y + dy)];
        if ((here != 0 && there != 0) || !is_edge(x, y, dx, dy)) return;
        here = there = 1;
    }

    bool is_edge(int x, int y, int dx, int dy) {
        const double contrast = distance(color_at(image_, x, y), color_at(image_, x + dx, y + dy));
        if (!(contrast >= contrast_)) return false;
        const Probe& a = centre(x, y);
        const Probe& b = centre(x + dx, y + dy);
        if (a.object != b.object || a.lit != b.lit) return true;
        return contrast > sharpness * slope(x, y, dx, dy) &&
               contrast > sharpness * slope(x + dx, y + dy, -dx, -dy);
    }

    const Probe& centre(int x, int y) {
        std::optional<Probe>& sample = centres_[index_of(image_, x, y)];
        if (!sample) sample = probe_(x + 0.5, y + 0.5);
        return *sample;
    }
    double slope(int x, int y, int dx, int dy) {
        const Color beside = probe_(x + 0.5 + dx * step, y + 0.5 + dy * step).color;
        return distance(beside, centre(x, y).color) / step;
    }

    const Image& image_;
    const ProbeFunction& probe_;
    double contrast_;
    std::vector<std::optional<Probe>> centres_;
    Mask edges_;
};

}  // namespace

Mask find_edges(const Image& image, const ProbeFunction& probe, double contrast) {
    return EdgeFinder(image, probe, contrast).run();
}

}  // namespace lancer::judge
