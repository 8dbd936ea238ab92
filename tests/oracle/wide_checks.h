// Results of wide kernels compared with the crossings of the scalar code.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/oracle/tally.h"
#include "tests/oracle/wide_kernels.h"

namespace lancer::oracle {

struct Share {
    std::size_t unsure = 0, hits = 0, answers = 0;

    /// Kernels that are never sure would pass, but be useless.
    void expect(double most_unsure) const {
        EXPECT_GT(hits, answers / 20);
        EXPECT_LE(static_cast<double>(unsure), most_unsure * static_cast<double>(answers));
    }
};

/// The crossings that count ahead of the start, by the rules of IntersectionFilter.
inline void check_nearest(std::vector<Crossing<double>> found, const WideAnswer& answer,
                          const Draw& draw, Share& share) {
    ++share.answers;
    share.hits += answer.hit;
    share.unsure += answer.unsure;
    if (answer.unsure) return;
    for (const Crossing<double>& c : found)
        EXPECT_TRUE(c.t > c.error || c.t < -c.error) << "case " << draw.number() << ": too near";
    std::erase_if(found, [](const auto& c) { return c.t < 0; });
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    ASSERT_EQ(answer.hit, !found.empty()) << "case " << draw.number();
    if (found.empty()) return;
    EXPECT_EQ(answer.t, found[0].t) << "case " << draw.number();
    EXPECT_EQ(answer.error, found[0].error) << "case " << draw.number();
    EXPECT_EQ(answer.entering, found[0].entering) << "case " << draw.number();
    EXPECT_EQ(answer.face, found[0].face) << "case " << draw.number();
    if (found.size() == 1) return;
    EXPECT_GT(found[1].t, found[0].t + 8 * found[0].error) << "case " << draw.number();
}

template <class Shape>
std::vector<Crossing<double>> crossings_to(const Shape& shape, const Ray<double>& ray,
                                           double limit) {
    std::vector<Crossing<double>> found;
    const auto last = [&] { return limit; };
    const auto note = [&](const Crossing<double>& c) {
        if (!(c.t > limit)) found.push_back(c);
    };
    crossings(shape, ray, IntersectionHints{}, RayInterval<double, decltype(last)>{0, last}, note);
    return found;
}

/// Whether anything counts before a light at this distance: query_occlusion().
template <class Shape>
void check_shadow(const Shape& shape, const Ray<double>& ray, double distance,
                  const WideAnswer& answer, const Draw& draw, Share& share) {
    ++share.answers;
    share.hits += answer.hit;
    share.unsure += answer.unsure;
    if (answer.unsure) return;
    const auto found = crossings_to(shape, ray, distance);
    const bool hidden = std::any_of(found.begin(), found.end(), [&](const auto& c) {
        return c.t > c.error && c.t < distance - c.error;
    });
    EXPECT_EQ(answer.hit, hidden) << "case " << draw.number();
}

}  // namespace lancer::oracle
