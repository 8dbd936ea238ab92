// The cost and the error of settings: the truth, its cache, errors measured with it, and the
// recommended settings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "judge/tradeoff/combine.h"
#include "judge/tradeoff/frontier.h"
#include "judge/tradeoff/measured_error.h"
#include "judge/tradeoff/run_setting.h"
#include "judge/tradeoff/steady_cost.h"
#include "judge/tradeoff/trade_plan.h"
#include "judge/tradeoff/tradeoff.h"
#include "judge/tradeoff/tradeoff_text.h"
#include "judge/tradeoff/truth_cache.h"
#include "reference/compare/compare.h"

namespace lancer::judge {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A ball over a plane, and a second ball that mirrors or not.
Scene balls(bool with_mirror) {
    Scene scene;
    scene.background = {0.2, 0.3, 0.5};
    scene.settings.threads = 2;
    Camera camera;
    camera.position = {0, 2, 6};
    camera.look_at = {0, 0.8, 0};
    scene.cameras.push_back(camera);
    Light light;
    light.kind = PointLight{{4, 6, 3}, {}};
    scene.lights.push_back(light);
    Material mirror;
    mirror.reflection = with_mirror ? Color{0.8, 0.8, 0.8} : Color{0, 0, 0};
    scene.materials.push_back(mirror);
    const auto add = [&](const Shape& shape, std::uint32_t material) {
        Object object;
        object.shape = shape;
        object.material = material;
        scene.objects.push_back(object);
    };
    add(Plane{}, 0);
    add(Sphere{{-1, 1, 0}, 1}, 0);
    add(Sphere{{1.2, 0.8, 0.5}, 0.8}, 1);
    return scene;
}

View small_view() {
    View view;
    view.width = 32;
    view.height = 24;
    return view;
}

TruePicture truth_of(const Scene& scene, const View& view, std::uint32_t points,
                     std::uint64_t seed) {
    const Settings settings = turned(scene, view).uncut;
    TruePicture truth(view, {settings.max_depth, settings.min_contribution}, seed);
    truth.refine(*compile(scene, settings), points, {});
    return truth;
}

TEST(Frontier, IsWhatNothingBeats) {
    const std::vector<TradePoint> points{{1, 0.5}, {2, 0.3}, {3, 0.4}, {4, 0.1},
                                         {4, 0.1}, {5, 0.2}, {1, 0.7}, {9, 0.05}};
    EXPECT_THAT(frontier(points), ElementsAre(0, 1, 3, 7));
    const auto beaten = dominators(points);
    EXPECT_EQ(beaten[0], std::nullopt);
    EXPECT_EQ(beaten[2], 1U);
    EXPECT_EQ(beaten[4], 3U) << "of equal ones the first stays";
    EXPECT_EQ(beaten[5], 3U);
    EXPECT_EQ(beaten[6], 0U);
    EXPECT_THAT(frontier({}), IsEmpty());
}

TEST(Frontier, HasNoneThatTheClockAloneWouldPutThere) {
    // One is as fast as the next, which has half its error; another is hardly better than the one
    // before.
    const std::vector<TradePoint> points{{1.00, 0.5}, {1.01, 0.25}, {2, 0.249}, {3, 0.1}};
    EXPECT_THAT(frontier(points), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(clear_frontier(points), ElementsAre(1, 3));
    EXPECT_EQ(dominators(points)[0], 1U);
    EXPECT_EQ(dominators(points)[2], 1U);
    // A noisy clock cannot distinguish more, but a chain of small steps is not one small step.
    const std::vector<TradePoint> chain{{1, 0.9}, {1.1, 0.8}, {1.19, 0.7}, {1.3, 0.6}, {1.4, 0.5}};
    EXPECT_THAT(clear_frontier(chain), ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(clear_frontier(chain, 0.2), ElementsAre(2, 4));
}

/// Settings with this many samples and levels, in double or single precision. The noise of their
/// runs has this limit, some rounds are slower as a whole, and every tenth run meets a busy moment.
std::vector<TimedSetting> timed(double noise, unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    std::vector<TimedSetting> all;
    for (const bool single : {false, true})
        for (const std::uint64_t samples : {1U, 4U, 9U, 16U, 36U, 64U})
            for (const std::uint64_t depth : {1U, 2U, 4U, 8U}) {
                TimedSetting s;
                s.way = single ? "single" : "double";
                s.max_depth = static_cast<int>(depth);
                s.rays = {1000 * samples, 700 * samples * (depth + 1), 400 * samples * depth, 0};
                all.push_back(s);
            }
    for (int round = 0; round < 5; ++round) {
        const double slower = between(1, 1 + 2 * noise);
        for (TimedSetting& s : all) {
            const double rays = 1e-3 + 1e-6 * double(s.rays.primary) +
                                2e-7 * double(s.rays.shadow) + 1e-6 * double(s.rays.reflected);
            const double busy = between(0, 1) < 0.1 * (noise > 0) ? 1.5 : 1;
            s.seconds.push_back(rays * (s.way == "single" ? 0.7 : 1) * slower * busy *
                                between(1 - noise, 1 + noise));
        }
    }
    return all;
}

TEST(SteadyCost, IsTheTimeWhereNothingDisturbsIt) {
    std::vector<TimedSetting> settings = timed(0, 1);
    for (double& s : settings[9].seconds) s *= 1.3;  // more expensive than its rays indicate
    const SteadyCosts costs = steady_costs(settings);
    for (std::size_t i = 0; i < settings.size(); ++i)
        EXPECT_NEAR(costs.seconds[i] / median_of(settings[i].seconds), 1, 0.03) << i;
}

TEST(SteadyCost, KeepsItsOrderOnABusyMachine) {
    const std::vector<double> quiet = steady_costs(timed(0, 1)).seconds;
    const auto out_of_order = [&](const std::vector<double>& costs) {
        int wrong = 0;
        for (std::size_t i = 0; i < costs.size(); ++i)
            for (std::size_t k = 0; k < costs.size(); ++k)
                wrong += quiet[i] > 1.05 * quiet[k] && costs[i] < costs[k];
        return wrong;
    };
    int by_time = 0;
    int by_cost = 0;
    for (unsigned seed = 2; seed < 12; ++seed) {
        const std::vector<TimedSetting> busy = timed(0.3, seed);
        std::vector<double> medians;
        for (const TimedSetting& s : busy) medians.push_back(median_of(s.seconds));
        by_time += out_of_order(medians);
        by_cost += out_of_order(steady_costs(busy).seconds);
    }
    EXPECT_LT(4 * by_cost, by_time);
}

/// A setting that runs less often must not look cheaper or more expensive for that reason.
TEST(SteadyCost, OfFewRunsIsThatOfManyInTheMean) {
    std::mt19937 random(5);
    for (const std::size_t runs : {3U, 4U, 5U, 7U, 9U, 15U}) {
        double sum = 0;
        constexpr int tries = 4000;
        for (int k = 0; k < tries; ++k) {
            std::vector<double> seconds(runs);
            for (double& s : seconds) s = static_cast<double>(random()) / 4294967296.0;
            sum += quantile_of(seconds, 0.25);
        }
        EXPECT_NEAR(sum / tries, 0.25, 0.02) << runs;
    }
    EXPECT_EQ(quantile_of({7}, 0.25), 7);
    EXPECT_EQ(median_of({4, 1, 3, 2}), 2.5);
}

TEST(TradePlan, ComparesRunsByTurns) {
    std::string order;
    const auto run = [&](char name, double seconds) {
        return [&order, name, seconds] {
            order += name;
            return seconds;
        };
    };
    const double share = share_of_time(3, run('b', 2), run('t', 1), [] { return true; });
    EXPECT_EQ(order, "bttbbt");
    EXPECT_EQ(share, 0.5);
    EXPECT_EQ(share_of_time(3, run('b', 2), run('t', 1), [] { return false; }), 1);
}

TEST(SteadyCost, OfOneSettingIsItsTimeInAQuietMoment) {
    const std::vector<TimedSetting> one{{"double", 8, {100, 50, 0, 0}, {0.2, 0.3, 0.25}}};
    EXPECT_NEAR(steady_costs(one).seconds[0], 0.2, 1e-6);
}

TEST(TradeOffTruth, KnowsHowWrongItIs) {
    const Scene scene = balls(true);
    const TruePicture coarse = truth_of(scene, small_view(), 8, 0);
    const TruePicture fine = truth_of(scene, small_view(), 512, 99);
    const double error = std::sqrt(mean_square_between(coarse.image(), fine.image()));
    EXPECT_LT(10 * fine.error(), coarse.error());
    EXPECT_GT(error, 0.8 * coarse.error());
    EXPECT_LT(error, 1.25 * coarse.error());
}

TEST(TradeOffTruth, DependsOnItsPointsAlone) {
    const Scene scene = balls(true);
    const TruePicture at_once = truth_of(scene, small_view(), 12, 5);
    const Settings settings = turned(scene, small_view()).uncut;
    TruePicture bit_by_bit(small_view(), {settings.max_depth, settings.min_contribution}, 5);
    const auto renderer = compile(scene, settings);
    for (const std::uint32_t points : {3U, 4U, 12U}) bit_by_bit.refine(*renderer, points, {});
    EXPECT_EQ(at_once.bytes(), bit_by_bit.bytes());
    EXPECT_NE(at_once.bytes(), truth_of(scene, small_view(), 12, 6).bytes());
    View part = small_view();
    part.crop = Crop{5, 4, 3, 2};
    const TruePicture cropped = truth_of(scene, part, 12, 5);
    EXPECT_EQ(cropped.mean(4), at_once.mean(5 * 32 + 6));
}

TEST(TradeOffError, IsThatOfCompareAndInItsInterval) {
    const Scene scene = balls(true);
    const View view = small_view();
    TradeSetting setting = exact_setting(turned(scene, view), 2);
    const SettingRun run = run_setting(scene, view, setting, {});
    const TruePicture fine = truth_of(scene, view, 512, 7);
    const reference::Comparison right = reference::compare_images(run.image, fine.image(), {});
    const MeasuredError error = error_of(run.image, fine);
    EXPECT_NEAR(error.rmse, right.rmse, 0.01 * right.rmse);
    EXPECT_EQ(error.p999, right.p999);
    EXPECT_EQ(error.flip, right.flip);
    // A truth as coarse as the picture: a plain comparison would give 1.4 times the error.
    int held = 0;
    double sum = 0;
    for (std::uint64_t seed = 20; seed < 40; ++seed) {
        const MeasuredError rough = error_of(run.image, truth_of(scene, view, 2, seed));
        held += rough.low <= right.rmse && right.rmse <= rough.high ? 1 : 0;
        sum += rough.mean_square / 20;
    }
    EXPECT_GE(held, 17);
    EXPECT_NEAR(sum, right.rmse * right.rmse, 0.1 * right.rmse * right.rmse);
}

TEST(TradeOffError, NoneIsNone) {
    Scene scene = balls(false);
    scene.objects.clear();
    const View view = small_view();
    const SettingRun run = run_setting(scene, view, exact_setting(turned(scene, view), 1), {});
    const MeasuredError error = error_of(run.image, truth_of(scene, view, 4, 1));
    EXPECT_EQ(error.high, 0);
    EXPECT_TRUE(error.is_told());
    EXPECT_EQ(error_text(error), "none");
}

class TruthFile : public testing::Test {
  protected:
    // Each test's own: they may run at the same time.
    TruthFile() : folder_(testing::TempDir() + "lancer_truth_test" + std::to_string(getpid())) {}
    ~TruthFile() override { remove_all(); }
    void remove_all() const { std::filesystem::remove_all(folder_); }
    TruthCache cache() const { return {folder_, "content"}; }
    std::string path() const { return folder_ + "/truth/" + key_; }
    bool reads(const TruePicture& like) const {
        TruePicture read(small_view(), {64, 1e-5}, 0);
        const bool is_whole = read_truth(cache(), key_, read);
        EXPECT_EQ(is_whole, read.points() > 0);
        return is_whole && read.bytes() == like.bytes();
    }

    std::string folder_;
    std::string key_ = truth_key("content", small_view(), {64, 1e-5}, 0);
};

TEST_F(TruthFile, ComesBackUnlessItIsDamaged) {
    const TruePicture truth = truth_of(balls(true), small_view(), 4, 0);
    EXPECT_FALSE(reads(truth));
    write_truth(cache(), key_, truth);
    EXPECT_TRUE(reads(truth));
    std::ifstream in(path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const auto with = [&](const std::string& other) {
        std::ofstream(path(), std::ios::binary) << other;
        return reads(truth);
    };
    std::string flipped = bytes;
    flipped[bytes.size() / 2] ^= 1;
    EXPECT_FALSE(with(flipped));
    EXPECT_FALSE(with(bytes.substr(0, bytes.size() - 1)));
    EXPECT_FALSE(with(bytes.substr(0, 40)));
    EXPECT_FALSE(with(""));
    EXPECT_TRUE(with(bytes));
}

TEST_F(TruthFile, IsKeptByAllThatDecidesIt) {
    View other = small_view();
    other.width = 33;
    View part = small_view();
    part.crop = Crop{0, 0, 3, 3};
    View whole = small_view();
    whole.crop = Crop{0, 0, 32, 24};
    EXPECT_EQ(truth_key("content", whole, {64, 1e-5}, 0), key_) << "the same pixels";
    for (const std::string& key :
         {truth_key("Content", small_view(), {64, 1e-5}, 0),
          truth_key("content", other, {64, 1e-5}, 0), truth_key("content", part, {64, 1e-5}, 0),
          truth_key("content", small_view(), {63, 1e-5}, 0),
          truth_key("content", small_view(), {64, 2e-5}, 0),
          truth_key("content", small_view(), {64, 1e-5}, 1)})
        EXPECT_NE(key, key_);
}

std::vector<std::string> knobs_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const TradeSetting& s : single_settings(turned(scene, small_view()), 8))
        names.emplace_back(name_of(s.knob));
    return names;
}

TEST(TradeOffSettings, AreThoseThatTheSceneHasAUseFor) {
    EXPECT_THAT(knobs_of(balls(true)), Contains("max-depth"));
    EXPECT_THAT(knobs_of(balls(true)), Contains("shadows"));
    for (const char* unused : {"max-depth", "min-contribution", "tolerance", "textures", "smooth"})
        EXPECT_THAT(knobs_of(balls(false)), Not(Contains(unused)));
    Scene with_patch = balls(false);
    Patch patch;
    patch.control.assign(16, {0, 0, 0});
    with_patch.patches.push_back(patch);
    with_patch.objects.front().shape = PatchRef{};
    EXPECT_THAT(knobs_of(with_patch), Contains("tolerance"));
}

TEST(TradeOffSettings, AreCombinedWhereThatPromisesSomething) {
    const Scene scene = balls(true);
    const TurnedScene t = turned(scene, small_view());
    KnobEffect base{base_setting(t, 8), 900, 1e-4, 0};
    std::vector<KnobEffect> singles{base, {exact_setting(t, 8), 6400, 1e-6, 0}};
    for (const TradeSetting& s : single_settings(t, 8)) {
        if (s.knob == Knob::max_depth && s.settings.max_depth == 2)
            singles.push_back({s, 450, 1.1e-4, 1e-5});  // half the rays, a little error
        if (s.knob == Knob::max_depth && s.settings.max_depth == 3)
            // saves no rays, whatever the clock measures
            singles.push_back({s, 890, 1e-4, 1e-9, 0.5});
        if (s.knob == Knob::shadows) singles.push_back({s, 450, 0.04, 0.04});          // too wrong
        if (s.knob == Knob::precision) singles.push_back({s, 900, 1e-4, 1e-8, 0.97});  // no faster
    }
    const std::vector<TradeSetting> found = promising(t, base, singles, 16);
    std::vector<std::string> labels;
    for (const TradeSetting& s : found) labels.push_back(s.label);
    EXPECT_THAT(labels, ElementsAre("sobol 8 x 8, depth 2"));
    EXPECT_EQ(found[0].options,
              "--sampling sobol --samples 8 --max-depth 2 --min-contribution 1e-7");
}

TEST(TradeOffAdvice, IsTheFastestThatIsSurelyBelow) {
    std::vector<Measurement> settings(3);
    settings[0].seconds = {9, 8, 10};
    settings[0].error = {0, 0, 0.0015, 0.0014, 0.0016, 0, 0};
    settings[1].setting.options = "--samples 3";
    settings[1].seconds = {1, 3, 1.25};
    settings[1].error = {0, 0, 0.003, 0.0029, 0.0031, 0, 0};
    settings[2].seconds = {1};
    settings[2].error = {0, 0, 0.0039, 0.0035, 0.0043, 0, 0};  // above 1/255, perhaps
    const std::vector<Advice> advice = advice_from(settings, 0);
    ASSERT_EQ(advice.size(), 3U);
    EXPECT_EQ(advice[0].use, 2U);
    EXPECT_EQ(sentence(advice[1], settings),
              "for an error below 1/255: --samples 3, 7.2 times as fast as exact (RMSE 0.003)");
    EXPECT_EQ(sentence(advice[2], settings),
              "for an error below 1/1000: none of these settings; the best reaches 0.0016");
}

TEST(TradeOff, EndsInTimeAndSaysWhatWasLeftOut) {
    const Scene scene = balls(true);
    const View view = small_view();
    TradeOffOptions options;
    options.budget = 1e-6;
    EXPECT_THROW(trade_off(scene, view, options), BudgetTooShort);
    options.budget = 0.5;
    const TradeOffReport report = trade_off(scene, view, options);
    EXPECT_LT(report.seconds, 3);  // a busy machine's last step included
    EXPECT_THAT(report.left_out, Not(IsEmpty()));
    EXPECT_GE(report.settings.size(), 1U);
    EXPECT_THAT(tradeoff_text(report), HasSubstr("left out: "));
}

}  // namespace
}  // namespace lancer::judge
