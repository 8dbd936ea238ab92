// Triangles side by side give the same results as each of them alone.
#include "tracer/shapes/triangle_leaf.h"
#include "tracer/rays/shear.h"

#include <gtest/gtest.h>

#include <random>

namespace lancer {
namespace {

template <class Real>
class TriangleLeafOf : public testing::Test {};
using NumberTypes = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(TriangleLeafOf, NumberTypes);

TYPED_TEST(TriangleLeafOf, MeetsWhatEachTriangleMeets) {
    using Real = TypeParam;
    std::mt19937_64 engine(5);
    const auto draw = [&](double low, double high) {
        return static_cast<Real>(std::uniform_real_distribution<double>(low, high)(engine));
    };
    const auto place = [&](double size) {
        const Real x = draw(-size, size);
        const Real y = draw(-size, size);
        return Vec3<Real>(x, y, draw(-size, size));
    };
    int met = 0;
    int passed = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec3<Real> start = place(k % 2 == 0 ? 1 : 1000);
        const Vec3<Real> low =
            k % 3 == 0 ? Vec3<Real>(0) : start * (unit_roundoff<Real> * draw(-1, 1));
        TriangleLeaf<Real> leaf;
        std::array<TriangleSheet<Real>, 4> triangle;
        for (std::size_t i = 0; i < 4; ++i) {
            triangle[i] = {place(1), place(1), place(1)};
            leaf.set(i, 0, triangle[i]);
        }
        // In half of the cases through a corner, or nearly.
        const Vec3<Real> target = k % 4 < 2 ? triangle[1].b : place(1);
        const Ray<Real> ray = make_ray(start, low, normalize(target - start), Real(0));
        Shear<Real> shear = shear_of(ray);
        shear.noise = edge_noise(ray, Real(1));
        const unsigned together = may_meet(leaf, ray, shear);
        for (std::size_t i = 0; i < 4; ++i) {
            const bool alone = may_meet(triangle[i], ray, shear);
            EXPECT_EQ((together >> i & 1) != 0, alone) << "case " << k << ", triangle " << i;
            ++(alone ? met : passed);
        }
    }
    EXPECT_GT(met, 5000);
    EXPECT_GT(passed, 5000);
}

TYPED_TEST(TriangleLeafOf, GivesItsTrianglesBack) {
    using Real = TypeParam;
    TriangleLeaf<Real> leaf;
    const TriangleSheet<Real> t{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    leaf.set(2, 17, t);
    EXPECT_EQ(leaf.face[2], 17u);
    EXPECT_EQ(leaf.triangle(2).a, t.a);
    EXPECT_EQ(leaf.triangle(2).b, t.b);
    EXPECT_EQ(leaf.triangle(2).c, t.c);
}

TYPED_TEST(TriangleLeafOf, ComparesSideBySide) {
    using Real = TypeParam;
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Four<Real> a(std::array<Real, 4>{1, 2, 3, nan});
    const Four<Real> b(std::array<Real, 4>{2, 2, 1, 0});
    EXPECT_EQ(less(a, b), 0b0001u);
    EXPECT_EQ(at_most(a, b), 0b0011u);
    EXPECT_EQ(at_most(b, a), 0b0110u);
}

/// In single precision through the wider type: the exact difference rounded once.
TEST(Difference, OfSingleNumbersIsRoundedOnce) {
    std::mt19937_64 engine(9);
    std::uniform_real_distribution<float> draw(-1, 1);
    for (int k = 0; k < 100000; ++k) {
        const float hi = draw(engine);
        const float lo = hi * 0x1p-25F * draw(engine);
        const float point = hi * (1 + 0x1p-12F * draw(engine));
        const float got = difference(Vec3<float>(hi), Vec3<float>(lo), Vec3<float>(point)).x;
        const long double exact = static_cast<long double>(hi) + lo - point;
        EXPECT_LE(std::abs(got - exact), std::abs(exact) * 0x1.00001p-24L) << k;
    }
}

}  // namespace
}  // namespace lancer
