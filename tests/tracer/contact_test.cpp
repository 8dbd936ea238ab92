#include "tracer/intersect/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace lancer {
namespace {

using Found = std::set<std::uint32_t>;

/// The primitives of a contact whose hits come in this order.
Found contact_of(const std::vector<Hit<double>>& hits) {
    Contact<double> contact;
    NearestContact<double> nearest(contact);
    for (const Hit<double>& hit : hits) nearest.add(hit);
    nearest.settle();
    Found found;
    for (const Hit<double>& hit : contact) found.insert(hit.surface.primitive);
    return found;
}

Hit<double> hit(std::uint32_t primitive, double t, double error) {
    return {t, error, {primitive, 0, true}};
}

/// The contact is the same for all orders.
void expect_one_contact(std::vector<Hit<double>> hits, const Found& expected) {
    const auto by_primitive = [](const Hit<double>& a, const Hit<double>& b) {
        return a.surface.primitive < b.surface.primitive;
    };
    std::sort(hits.begin(), hits.end(), by_primitive);
    do {
        EXPECT_EQ(contact_of(hits), expected);
    } while (std::next_permutation(hits.begin(), hits.end(), by_primitive));
}

TEST(Contact, HoldsWhatCannotBeToldApartFromTheNearest) {
    expect_one_contact({hit(0, 1, 0.01), hit(1, 1.015, 0.01)}, {0, 1});
    expect_one_contact({hit(0, 1, 0.01), hit(1, 1.025, 0.01)}, {0});
    // A bound counts up to seven times that of the nearest hit.
    expect_one_contact({hit(0, 1, 0.01), hit(1, 1.075, 1)}, {0, 1});
    expect_one_contact({hit(0, 1, 0.01), hit(1, 1.085, 1)}, {0});
}

TEST(Contact, EndsAtEightBoundsOfAnyHit) {
    // The second lies at most 1.008; the third cannot be told apart from the first alone.
    expect_one_contact({hit(0, 0.99, 0.02), hit(1, 1, 0.001), hit(2, 1.05, 0.05)}, {0, 1});
}

TEST(Contact, IsTheSameInEveryOrder) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 1);
    std::uniform_real_distribution<double> digits(-3, 0);
    int several = 0;
    for (int run = 0; run < 2000; ++run) {
        std::vector<Hit<double>> hits;
        for (std::uint32_t i = 0; i < 5; ++i)
            hits.push_back(hit(i, place(random), std::pow(10, digits(random))));
        const Found first = contact_of(hits);
        several += first.size() > 1;
        expect_one_contact(hits, first);
    }
    EXPECT_GT(several, 500);
}

}  // namespace
}  // namespace lancer
