// The page and the plots of trade-offs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "judge/report/report.h"
#include "judge/tradeoff/page.h"
#include "judge/tradeoff/scatter.h"

namespace lancer::judge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
        ++n;
    return n;
}

std::string noise_png(int size) {
    Image image(size, size);
    std::uint32_t state = 1;
    for (double& value : image.data) value = (state = state * 1664525 + 1013904223) / 4294967296.0;
    return preview_of(image, 1'000'000).png;
}

/// Three settings, the second of them beaten by the first.
TradeOffReport small_report() {
    TradeOffReport report;
    report.scene = "a<b> & c.lancer";
    report.view.width = 40;
    report.view.height = 30;
    report.threads = 2;
    for (const auto& [seconds, rmse] : {std::pair{1.0, 0.01}, {2.0, 0.02}, {4.0, 0.001}}) {
        Measurement m;
        m.setting.label = "sobol";
        m.setting.options = "--samples 3";
        m.seconds = {seconds};
        m.error.rmse = rmse;
        m.error.low = 0.9 * rmse;
        m.error.high = 1.1 * rmse;
        m.png = noise_png(128);
        m.error_png = m.png;
        report.settings.push_back(m);
    }
    report.settings[1].beaten_by = 0;
    report.exact = 2;
    report.advice = advice_from(report.settings, 2);
    return report;
}

TEST(TradeOffPage, ShowsEverySettingAndNothingFromElsewhere) {
    const std::string page = tradeoff_page({small_report()});
    EXPECT_EQ(count(page, "class=\"point "), 3U);
    EXPECT_EQ(count(page, " id=\"s0-"), 3U);
    EXPECT_EQ(count(page, "<tr class=\"beaten\""), 1U);
    EXPECT_EQ(count(page, "data:image/png;base64,"), 6U);
    EXPECT_THAT(page, HasSubstr("<h2>a&lt;b&gt; &amp; c.lancer</h2>"));
    EXPECT_THAT(page, Not(HasSubstr("a<b>")));
    EXPECT_THAT(page, Not(HasSubstr("http:")));
    EXPECT_THAT(page, Not(HasSubstr("https:")));
    EXPECT_THAT(page, HasSubstr(tradeoff_mark));
    EXPECT_THAT(page, HasSubstr("<td>beaten by 1</td>"));
}

TEST(TradeOffPage, LeavesOutPicturesThatDoNotFit) {
    const TradeOffReport report = small_report();
    const std::size_t all = 6 * report.settings[0].png.size() / 3 * 4;
    const auto pictures = [&](std::size_t most) {
        return count(tradeoff_page({report}, most), "data:image/png;base64,");
    };
    EXPECT_EQ(pictures(2 * all), 6U);
    EXPECT_EQ(pictures(all * 9 / 10), 5U) << "without the beaten one's map";
    EXPECT_EQ(pictures(all * 7 / 10), 4U) << "and without its picture";
    EXPECT_EQ(pictures(all / 2), 2U) << "no maps";
    EXPECT_LT(tradeoff_page({report}, all / 10).size(), tradeoff_page({report}, all / 2).size());
}

TEST(TradeOffPlot, StandsAlone) {
    const std::string svg = scatter_document(small_report());
    EXPECT_THAT(svg, testing::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_THAT(svg, HasSubstr(tradeoff_mark));
    EXPECT_THAT(svg, HasSubstr("a&lt;b&gt; &amp; c.lancer"));
    EXPECT_THAT(svg, Not(HasSubstr("var(")));
    EXPECT_EQ(count(svg, "<g class=\"point"), 3U);
    EXPECT_EQ(count(svg, "beaten\" transform"), 1U);
    // Four times as long lies twice as far to the right as twice as long, a tenth of the error
    // below.
    const std::size_t line = svg.find("class=\"best\" d=\"M") + 17;
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    ASSERT_EQ(std::sscanf(svg.c_str() + line, "%lf,%lfL%lf,%lf", &x0, &y0, &x1, &y1), 4);
    EXPECT_LT(x0, x1);
    EXPECT_LT(y0, y1);
}

TEST(TradeOffPlot, HasRoomForNoErrorAtAll) {
    TradeOffReport report = small_report();
    for (Measurement& m : report.settings) m.error = {};
    for (const std::string& svg : {scatter_document(report), scatter_for_page(report, "s0-")}) {
        EXPECT_THAT(svg, Not(HasSubstr("nan")));
        EXPECT_THAT(svg, Not(HasSubstr("inf")));
    }
}

TEST(TradeOffPlot, HasANameOfItsOwn) {
    EXPECT_THAT(plot_names({"x/a.lancer"}), ElementsAre("plot.svg"));
    EXPECT_THAT(plot_names({"x/a.lancer", "y/a.lancer", "B c.lancer"}),
                ElementsAre("plot-a.svg", "plot-a-2.svg", "plot-b-c.svg"));
}

}  // namespace
}  // namespace lancer::judge
