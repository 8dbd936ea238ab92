#include "tracer/bvh/traverse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tracer/bvh/build.h"

namespace lancer {
namespace {

template <class Real>
struct Sampler {
    std::mt19937_64 engine;
    Real operator()(double low, double high) {
        return static_cast<Real>(std::uniform_real_distribution<double>(low, high)(engine));
    }
    Vec3<Real> vector(double low, double high) {
        const Real x = (*this)(low, high);
        const Real y = (*this)(low, high);
        return {x, y, (*this)(low, high)};
    }
};

template <class Real>
class BvhOf : public testing::Test {};
using NumberTypes = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(BvhOf, NumberTypes);

template <class Real>
bool visits(const Bvh<Real>& bvh, const Ray<Real>& ray, std::uint32_t item) {
    bool seen = false;
    traverse(
        bvh, ray, Real(0), [] { return std::numeric_limits<Real>::infinity(); },
        [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t i = first; i < first + count; ++i) seen |= bvh.order[i] == item;
            return seen;
        });
    return seen;
}

/// Boxes of all sizes around `center`, flat ones among them.
template <class Real>
std::vector<Bounds<Real>> random_boxes(Sampler<Real>& random, const Vec3<Real>& center,
                                       std::size_t count) {
    std::vector<Bounds<Real>> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3<Real> at = center + random.vector(-1, 1);
        Vec3<Real> reach = random.vector(0, 1) * std::pow(Real(10), random(-9, -0.5));
        if (i % 3 == 0) reach[static_cast<int>(i / 3 % 3)] = 0;
        boxes.push_back(around(at, reach));
    }
    return boxes;
}

TYPED_TEST(BvhOf, EveryItemIsInExactlyOneLeaf) {
    using Real = TypeParam;
    Sampler<Real> random{std::mt19937_64(1)};
    for (const std::size_t count : {1u, 2u, 5u, 100u, 3000u}) {
        const Bvh<Real> bvh = build_bvh(random_boxes(random, Vec3<Real>(0), count), 2, 1);
        std::vector<int> seen(count, 0);
        for (const BvhNode<Real>& node : bvh.nodes) {
            for (std::size_t c = 0; c < node.child.size(); ++c) {
                for (std::uint32_t i = 0; i < node.count[c]; ++i)
                    ++seen[bvh.order[node.child[c] + i]];
            }
        }
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count));
    }
}

TYPED_TEST(BvhOf, ARayTowardsAPointOfABoxVisitsItHoweverFarTheWorldIsMoved) {
    using Real = TypeParam;
    for (const Real far : {Real(0), Real(1), Real(1e6), Real(1e12)}) {
        Sampler<Real> random{std::mt19937_64(7)};
        const Vec3<Real> center(far, -far, far / 3);
        const std::vector<Bounds<Real>> boxes = random_boxes(random, center, 500);
        const Bvh<Real> bvh = build_bvh(boxes, 2, 1);
        int missed = 0;
        for (std::uint32_t item = 0; item < boxes.size(); ++item) {
            for (int k = 0; k < 8; ++k) {
                const Bounds<Real>& b = boxes[item];
                // A corner or a point of the box; from outside, along an axis or at a slant.
                Vec3<Real> target = b.min + random.vector(0, 1) * (b.max - b.min);
                for (int i = 0; i < 3; ++i) target[i] = std::clamp(target[i], b.min[i], b.max[i]);
                if (k % 2 == 0) target = Vec3<Real>(b.min.x, b.max.y, b.min.z);
                Vec3<Real> away = random.vector(-1, 1);
                if (k == 3) away = Vec3<Real>(0, 0, 2);
                if (k == 4) away = Vec3<Real>(0, -2, 0);
                const Vec3<Real> origin = target + away;
                const Vec3<Real> way = target - origin;
                if (length(way) == 0) continue;
                missed +=
                    !visits(bvh, make_ray(origin, Vec3<Real>(0), normalize(way), Real(0)), item);
            }
        }
        EXPECT_EQ(missed, 0) << "moved by " << far;
    }
}

TYPED_TEST(BvhOf, ARayThatIsNoneVisitsItemsAlone) {
    using Real = TypeParam;
    const Real infinity = std::numeric_limits<Real>::infinity();
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    Sampler<Real> random{std::mt19937_64(11)};
    const Bvh<Real> bvh = build_bvh(random_boxes(random, Vec3<Real>(0), 77), 2, 1);
    const Vec3<Real> zero(0);
    for (const Ray<Real>& ray : {make_ray(zero, zero, Vec3<Real>(infinity), Real(0)),
                                 make_ray(zero, zero, Vec3<Real>(nan), Real(0)),
                                 make_ray(Vec3<Real>(nan), zero, Vec3<Real>(1), Real(0)),
                                 make_ray(Vec3<Real>(infinity), zero, Vec3<Real>(1), Real(0))}) {
        std::size_t visited = 0;
        traverse(
            bvh, ray, Real(0), [&] { return infinity; },
            [&](std::uint32_t first, std::uint32_t count) {
                EXPECT_LE(first + count, bvh.order.size());
                visited += count;
                return visited > bvh.order.size();
            });
        EXPECT_LE(visited, bvh.order.size());
    }
}

/// So many boxes that several threads split the upper nodes together and build the lower ones in
/// turns.
TEST(Bvh, IsTheSameForAnyNumberOfThreads) {
    Sampler<double> random{std::mt19937_64(3)};
    std::vector<Bounds<double>> boxes = random_boxes(random, Vec3d(0), 200000);
    // Many boxes in one place, which no plane can separate.
    boxes.resize(boxes.size() + 70000, around(Vec3d(0.5), Vec3d(1e-3)));
    const Bvh<double> one = build_bvh(boxes, 4, 1);
    for (const int threads : {2, 3, 8}) {
        const Bvh<double> many = build_bvh(boxes, 4, threads);
        EXPECT_EQ(one.order, many.order);
        ASSERT_EQ(one.nodes.size(), many.nodes.size());
        std::size_t others = 0;
        for (std::size_t i = 0; i < one.nodes.size(); ++i) {
            const BvhNode<double>& a = one.nodes[i];
            const BvhNode<double>& b = many.nodes[i];
            others += a.min != b.min || a.max != b.max || a.child != b.child || a.count != b.count;
        }
        EXPECT_EQ(others, 0u) << threads << " threads";
    }
}

TEST(Bvh, BoxesInOnePlaceDoNotOutgrowTheStack) {
    std::vector<Bounds<double>> boxes(5000, around(Vec3d(1, 2, 3), Vec3d(0.5)));
    for (int i = 0; i < 2000;
         ++i)  // each a thousandth of the one before: the heuristic peels one at a time
        boxes.push_back(
            around(Vec3d(std::ldexp(1.0, -i / 2), 0, 0), Vec3d(std::ldexp(1.0, -i / 2 - 3))));
    const Bvh<double> bvh = build_bvh(boxes, 1, 1);
    EXPECT_TRUE(visits(bvh, make_ray(Vec3d(1, 2, 9), Vec3d(0), Vec3d(0, 0, -1), 0.0), 4999));
}

}  // namespace
}  // namespace lancer
