// Composites compared with 256-bit arithmetic: the intervals of a line inside of them, crossing by
// crossing. The bodies lie on a coarse grid, so that most of their faces are in the planes of
// others.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/oracle/exact.h"
#include "tests/tracer/scene_kit.h"
#include "tracer/compile/compile.h"
#include "tracer/intersect/composite_crossings.h"
#include "tracer/shading/surface.h"

namespace lancer::oracle {
namespace {

struct Span {
    Exact in, out;
};
struct Line {
    ExactVec origin, dir;
};

const Exact endless = 1e30;

/// The part of the line between two parallel planes at heights `low` and `high`.
Span slab(const Exact& start, const Exact& rate, const Exact& low, const Exact& high) {
    if (rate == 0) return start >= low && start < high ? Span{-endless, endless} : Span{1, 0};
    const Exact a = (low - start) / rate;
    const Exact b = (high - start) / rate;
    return a < b ? Span{a, b} : Span{b, a};
}
Span both(const Span& a, const Span& b) {
    return {a.in > b.in ? a.in : b.in, a.out < b.out ? a.out : b.out};
}
/// Where a t^2 + 2 b t + c < 0, a > 0.
Span below_zero(const Exact& a, const Exact& b, const Exact& c) {
    const Exact square = b * b - a * c;
    if (!(square > 0)) return {1, 0};
    const Exact root = sqrt(square);
    return {(-b - root) / a, (-b + root) / a};
}

struct SpanOf {
    const Line& line;
    Span operator()(const Sphere& s) const {
        const ExactVec o = line.origin - exact(s.center);
        return below_zero(dot(line.dir, line.dir), dot(o, line.dir),
                          dot(o, o) - Exact(s.radius) * s.radius);
    }
    Span operator()(const Box& b) const {
        return both(both(slab(line.origin.x, line.dir.x, b.min.x, b.max.x),
                         slab(line.origin.y, line.dir.y, b.min.y, b.max.y)),
                    slab(line.origin.z, line.dir.z, b.min.z, b.max.z));
    }
    /// Along y.
    Span operator()(const Cylinder& c) const {
        const Exact x = line.origin.x - c.base.x;
        const Exact z = line.origin.z - c.base.z;
        const Exact a = line.dir.x * line.dir.x + line.dir.z * line.dir.z;
        const Exact rest = x * x + z * z - Exact(c.radius) * c.radius;
        Span side{-endless, endless};
        if (a != 0)
            side = below_zero(a, x * line.dir.x + z * line.dir.z, rest);
        else if (rest > 0)
            side = {1, 0};
        return both(side, slab(line.origin.y, line.dir.y, c.base.y, c.top.y));
    }
    /// Across x, y or z.
    Span operator()(const Plane& p) const {
        const Exact rate = dot(exact(p.normal), line.dir);
        const Exact start = dot(exact(p.normal), line.origin) - p.offset;
        if (rate == 0) {
            const bool up = p.normal.x + p.normal.y + p.normal.z > 0;
            return start < 0 || (start == 0 && !up) ? Span{-endless, endless} : Span{1, 0};
        }
        return rate > 0 ? Span{-endless, -start / rate} : Span{-start / rate, endless};
    }
    Span operator()(const auto&) const { return {1, 0}; }
};

class Judge {
  public:
    Judge(const Composite& composite, const Line& line) : composite_(composite) {
        for (const Composite::Leaf& leaf : composite.leaves) {
            spans_.push_back(std::visit(SpanOf{line}, leaf.object.shape));
            for (const Exact& t : {spans_.back().in, spans_.back().out})
                if (spans_.back().in < spans_.back().out && abs(t) < endless) places_.push_back(t);
        }
        std::sort(places_.begin(), places_.end());
        places_.erase(std::unique(places_.begin(), places_.end(),
                                  [](const Exact& a, const Exact& b) { return b - a < 1e-60; }),
                      places_.end());
    }

    bool holds(const Exact& t) const { return node_holds(0, t); }

    /// The parameters beyond `from` at which the line enters or leaves.
    std::vector<Exact> changes(const Exact& from) const {
        std::vector<Exact> all;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (places_[i] <= from) continue;
            const Exact before = i == 0 ? places_[i] - 1 : (places_[i - 1] + places_[i]) / 2;
            const Exact after =
                i + 1 == places_.size() ? places_[i] + 1 : (places_[i] + places_[i + 1]) / 2;
            if (holds(before) != holds(after)) all.push_back(places_[i]);
        }
        return all;
    }
    /// Whether two crossings beyond `from` are so close that no double can separate them.
    bool is_unfair(const Exact& from) const {
        for (std::size_t i = 1; i < places_.size(); ++i)
            if (places_[i] > from && places_[i] - places_[i - 1] < 1e-11) return true;
        return false;
    }

  private:
    bool node_holds(std::uint32_t node, const Exact& t) const {
        const Composite::Kind kind = composite_.nodes[node].kind;
        bool any = false;
        bool all = true;
        bool first = false;
        bool others = false;
        const auto add = [&](const Composite::Place& place, bool holds) {
            any = any || holds;
            all = all && holds;
            if (place.first)
                first = holds;
            else
                others = others || holds;
        };
        for (std::uint32_t i = node + 1; i < composite_.nodes.size(); ++i)
            if (composite_.nodes[i].place.parent == node)
                add(composite_.nodes[i].place, node_holds(i, t));
        for (std::size_t i = 0; i < composite_.leaves.size(); ++i)
            if (composite_.leaves[i].place.parent == node)
                add(composite_.leaves[i].place, spans_[i].in < t && t < spans_[i].out);
        if (kind == Composite::Kind::unite) return any;
        if (kind == Composite::Kind::intersect) return all;
        return first && !others;
    }

    const Composite& composite_;
    std::vector<Span> spans_;
    std::vector<Exact> places_;
};

class Lottery {
  public:
    explicit Lottery(unsigned seed) : random_(seed) {}

    int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    double grid() { return pick(9) / 4.0 - 1; }
    double any() { return static_cast<double>(random_()) / 2147483648.0 - 1; }

    Composite tree() {
        Composite made;
        add_node(made, none, false, 0);
        return made;
    }
    /// A tree of wide slabs, whose faces lie at 0 and 1, or off by some units in the last place.
    Composite slabs() {
        slabs_ = true;
        return tree();
    }
    Vec3d direction() {
        if (pick(4) == 0) {
            Vec3d along(0);
            along[pick(3)] = pick(2) == 0 ? 1 : -1;
            return along;
        }
        return normalize(Vec3d(any(), any(), any()));
    }

  private:
    void add_node(Composite& made, std::uint32_t parent, bool first, int depth) {
        const auto index = static_cast<std::uint32_t>(made.nodes.size());
        made.nodes.push_back({static_cast<Composite::Kind>(pick(3)), {parent, first}, 0, 0});
        made.nodes[index].begin = static_cast<std::uint32_t>(made.leaves.size());
        const int children = 2 + pick(3);
        for (int i = 0; i < children; ++i) {
            if (depth < 3 && pick(3) == 0) {
                add_node(made, index, i == 0, depth + 1);
            } else {
                Composite::Leaf leaf;
                leaf.object.shape = shape();
                leaf.place = {index, i == 0};
                made.leaves.push_back(leaf);
            }
        }
        made.nodes[index].end = static_cast<std::uint32_t>(made.leaves.size());
    }

    /// Near 0 or 1, higher than `than`.
    double height(double than) {
        const double unit = 0x1p-53;
        const double made = pick(2) + (pick(7) - 3) * unit;
        return made > than ? made : than + (1 + pick(3)) * 2 * unit;
    }
    Shape slab_shape() {
        const double low = height(-1);
        const double high = height(low);
        const double wide = 100;
        if (pick(4) == 0) return Plane{{0, pick(2) == 0 ? 1.0 : -1.0, 0}, 0};
        if (pick(2) == 0) return Cylinder{{0, low, 0}, {0, high, 0}, wide};
        return Box{{-wide, low, -wide}, {wide, high, wide}};
    }
    Shape shape() {
        if (slabs_) return slab_shape();
        const Vec3d at(grid(), grid(), grid());
        const double size = (1 + pick(4)) / 4.0;
        switch (pick(5)) {
            case 0:
                return Sphere{at, size};
            case 1:
                return Cylinder{at, at + Vec3d(0, (1 + pick(4)) / 4.0, 0), size};
            case 2: {
                Vec3d normal(0);
                normal[pick(3)] = pick(2) == 0 ? 1 : -1;
                return Plane{normal, grid()};
            }
            default:
                return Box{at, at + Vec3d(size, (1 + pick(4)) / 4.0, (1 + pick(4)) / 4.0)};
        }
    }

    std::mt19937 random_;
    bool slabs_ = false;
};

Scene scene_of(const Composite& composite) {
    Scene scene;
    scene.transforms = {{}};
    scene.materials = {Material{}};
    scene.composites.push_back(composite);
    kit::show(scene, CompositeRef{0});
    kit::show(scene, Sphere{{0, 0, 0}, 4});  // gives every world the same scale
    return scene;
}

/// The crossings that the tracer reported.
struct Told {
    std::vector<Crossing<double>> crossings;
    std::vector<Hit<double>> hits;
};

/// A composite as the tracer and the judge have it.
class Body {
  public:
    explicit Body(Composite made)
        : composite(std::move(made)),
          scene(scene_of(composite)),
          world(compile_world<double>(scene, scene.settings)) {
        for (index = 0; index < world->primitives.size(); ++index)
            if ((tree = world->primitives[index].composite()) != nullptr) return;
    }

    /// The scene's unit of length in the world's.
    double unit() const { return std::ldexp(1.0, world->scale_exponent); }

    Judge judge(const Ray<double>& ray) const {
        const Exact in_scene = std::ldexp(1.0, -world->scale_exponent);
        return {composite, Line{in_scene * (exact(ray.origin) + exact(ray.origin_lo)),
                                in_scene * exact(ray.dir)}};
    }
    Told crossings(const Ray<double>& ray, const Start<double>* start) const {
        Told told;
        const CompositeStart<double> known{start, index, {}};
        const CompositeWalk<double> walk(*tree, ray, known);
        walk.tell(whole_line<double>(), [&](const Crossing<double>& c, double u, double v) {
            told.hits.push_back({c.t, c.error, {index, c.face, c.entering}, u, v});
            if ((c.face & hidden_face) == 0) told.crossings.push_back(c);
            return false;
        });
        return told;
    }

    const Composite composite;
    const Scene scene;
    const std::unique_ptr<const World<double>> world;
    const CompositeTree<double>* tree = nullptr;  ///< null when nothing is left of the body
    std::uint32_t index = 0;
};

class CompositeOracle : public testing::Test {
  protected:
    int judged = 0;
    int unfair = 0;

    /// Whether the crossings reported beyond `from` are the true ones.
    ///
    /// \param slack  in addition to the bounds: a start counts as on its face, but lies next to it
    bool is_right(const Judge& judge, const Told& told, double from, bool inside, double slack) {
        const std::vector<Exact> expected = judge.changes(from);
        std::size_t next = 0;
        for (const Crossing<double>& c : told.crossings) {
            if (c.t <= from) continue;
            if (next == expected.size() || c.entering == inside) return false;
            if (!(abs(expected[next] - c.t) <= c.error + slack)) return false;
            inside = c.entering;
            ++next;
        }
        return next == expected.size();
    }
};

TEST_F(CompositeOracle, LinesAreInsideWhereTheyAre) {
    int wrong = 0;
    int turned_wrong = 0;
    int turned = 0;
    int left = 0;
    int came_back = 0;
    for (unsigned seed = 1; seed <= 500; ++seed) {
        Lottery lottery(seed);
        const Body body(lottery.tree());
        if (body.tree == nullptr) continue;
        for (int i = 0; i < 40; ++i) {
            const Vec3d origin(lottery.grid() * 3, lottery.grid() * 3, lottery.grid() * 3);
            const Ray<double> ray =
                make_ray(origin * body.unit(), Vec3d(0), lottery.direction(), 0.0);
            const Judge judge = body.judge(ray);
            if (judge.is_unfair(-endless)) {
                ++unfair;
                continue;
            }
            ++judged;
            const Told told = body.crossings(ray, nullptr);
            const bool right = is_right(judge, told, -1e29, judge.holds(-1e29), 0);
            if (!right) ++wrong;
            // From each contact ahead a ray goes on in some direction.
            for (std::size_t k = 0; right && k < told.hits.size(); ++k) {
                if (told.hits[k].t < 0) continue;
                const Surface<double> s = make_surface(*body.world, ray, told.hits[k]);
                const Ray<double> next =
                    make_ray(s.position, s.position_lo, lottery.direction(), s.error);
                const Judge after = body.judge(next);
                const double beyond = 1e-9;
                const double steep = std::abs(lancer::dot(s.geometric, next.dir));
                if (after.is_unfair(beyond) || steep < 1e-3) continue;
                Start<double> start;
                for (const Hit<double>& hit : told.hits)
                    if (hit.t == told.hits[k].t) start.surfaces.push_back(hit.surface);
                ++turned;
                const Told rest = body.crossings(next, &start);
                if (!is_right(after, rest, beyond, after.holds(beyond), 4 * s.error / steep))
                    ++turned_wrong;
                if (left_for_good(s, next.dir) == none) continue;
                ++left;
                if (!rest.hits.empty()) ++came_back;
            }
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << judged;
    EXPECT_EQ(turned_wrong, 0) << "of " << turned;
    EXPECT_GT(judged, 8000);
    EXPECT_GT(turned, 2000);
    EXPECT_EQ(came_back, 0) << "of " << left;
    EXPECT_GT(left, 150);
    EXPECT_LT(unfair, judged / 20);
}

/// Much thinner than the rounding of distances.
TEST_F(CompositeOracle, ParallelFacesAreInOrder) {
    int wrong = 0;
    int thin = 0;
    for (unsigned seed = 1; seed <= 500; ++seed) {
        Lottery lottery(seed);
        const Body body(lottery.slabs());
        if (body.tree == nullptr) continue;
        for (int i = 0; i < 10; ++i) {
            const Vec3d from(lottery.any(), 4 + lottery.any(), lottery.any());
            const Vec3d dir = normalize(Vec3d(lottery.any(), -1.5, lottery.any()));
            const double side = lottery.pick(2) == 0 ? 1 : -1;
            const Ray<double> ray = make_ray(side * body.unit() * from, Vec3d(0), side * dir, 0.0);
            const Judge judge = body.judge(ray);
            ++judged;
            if (judge.is_unfair(-endless)) ++thin;
            const Told told = body.crossings(ray, nullptr);
            if (!is_right(judge, told, -1e29, judge.holds(-1e29), 0)) ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << judged;
    EXPECT_GT(thin, 2000);
}

}  // namespace
}  // namespace lancer::oracle
