#include "judge/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "judge/report/folders.h"
#include "judge/report/histogram.h"
#include "judge/report/html.h"
#include "judge/report/junit.h"
#include "judge/report/shell_text.h"
#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/image_file.h"
#include "model/io/png_file.h"
#include "model/io/temporary_file.h"
#include "model/srgb.h"

namespace lancer::judge {
namespace {

using testing::HasSubstr;
using testing::Not;

Image noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(0, 1);
    Image image(width, height);
    for (double& v : image.data) v = value(random);
    return image;
}

Report report_of(std::vector<ReportEntry> entries) {
    Report report;
    report.title = "T";
    report.left_name = "L";
    report.right_name = "R";
    report.entries = std::move(entries);
    return report;
}

ReportEntry entry_of(const std::string& name, Verdict verdict, double urgency = 0) {
    ReportEntry entry;
    entry.name = name;
    entry.verdict = verdict;
    entry.urgency = urgency;
    return entry;
}

TEST(Html, EscapesWhatWouldEndAnElementOrAnAttribute) {
    EXPECT_EQ(escaped("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
}

TEST(Html, Base64IsThatOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Html, ShowsNumbersWithoutPaddedExponents) {
    EXPECT_EQ(shown(2e-5), "2e-5");
    EXPECT_EQ(shown(7.6293e-6, 2), "7.6e-6");
    EXPECT_EQ(shown(1e-12), "1e-12");
    EXPECT_EQ(shown(0.25), "0.25");
}

TEST(Report, PutsWhatNeedsLookingAtFirst) {
    const std::string html = to_html(
        report_of({entry_of("good", Verdict::agrees), entry_of("slight", Verdict::differs, 1),
                   entry_of("refused", Verdict::refused), entry_of("grave", Verdict::differs, 9),
                   entry_of("broken", Verdict::failed)}));
    std::size_t last = 0;
    for (const char* name : {"broken", "grave", "slight", "refused", "good"}) {
        const std::size_t place = html.find(std::string("<h2>") + name);
        ASSERT_NE(place, std::string::npos) << name;
        EXPECT_GT(place, last) << name;
        last = place;
    }
}

TEST(Report, NeedsNoNetwork) {
    ReportEntry entry = entry_of("pair", Verdict::differs);
    entry.left = entry.right = entry.heat = preview_of(noise(16, 12, 1));
    entry.differences = {0, 0.5};
    const std::string html = to_html(report_of({entry}));
    EXPECT_THAT(html, HasSubstr("data:image/png;base64,"));
    for (const char* loads : {"http:", "https:", "@import", "url(", "<link", "src=\"/", "fetch("}) {
        EXPECT_THAT(html, Not(HasSubstr(loads)));
    }
}

TEST(Report, EscapesNamesAndReasons) {
    ReportEntry entry = entry_of("<script>alert(1)</script>", Verdict::failed);
    entry.reasons = {"a < b & \"c\""};
    const std::string html = to_html(report_of({entry}));
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
}

TEST(Report, HoldsFiftyScenesInTenMegabytes) {
    // Noise compresses worst.
    std::vector<ReportEntry> entries;
    const Preview worst = preview_of(noise(320, 240, 3));
    const Preview simple = preview_of(Image(320, 240));
    for (int i = 0; i < 50; ++i) {
        ReportEntry entry = entry_of("scene", Verdict::agrees);
        entry.left = simple;
        entry.right = entry.heat = worst;
        entry.differences.assign(320 * 240, 1e-5);
        entries.push_back(entry);
    }
    const io::TemporaryFolder folder;
    write_report(report_of(entries), folder.path().string());
    const auto size = std::filesystem::file_size(folder.path() / "index.html");
    EXPECT_LT(size, 10'000'000u);
    EXPECT_GT(size, 3'000'000u);
}

TEST(Report, KeepsSmallPreviewsWhenLargeOnesMustShrink) {
    ReportEntry entry = entry_of("scene", Verdict::agrees);
    entry.left = preview_of(Image(64, 64));
    entry.right = preview_of(noise(320, 240, 3));
    Report report = report_of({entry});
    fit(report, 100'000);
    EXPECT_EQ(report.entries[0].left.png, entry.left.png);
    EXPECT_LT(report.entries[0].right.png.size(), 75'000u);
}

TEST(Report, MarksAMissedThreshold) {
    ReportEntry entry = entry_of("pair", Verdict::differs);
    entry.measures = {
        {"Met", "1", "2", true}, {"Missed", "3", "2", false}, {"Free", "4", "", true}};
    const std::string html = to_html(report_of({entry}));
    EXPECT_THAT(html, HasSubstr("<tr class=\"bad\"><td>Missed"));
    EXPECT_THAT(html, HasSubstr("<tr><td>Met"));
}

TEST(Report, CannotBeWrittenWhereAFileIs) {
    const io::TemporaryFolder folder;
    const std::string path = (folder.path() / "file").string();
    std::ofstream(path) << "x";
    EXPECT_THROW(write_report(report_of({}), path), FileError);
    EXPECT_NO_THROW(write_report(report_of({}), (folder.path() / "new" / "er").string()));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "new" / "er" / "index.html"));
}

TEST(Preview, IsHalvedUntilItFits) {
    const Preview large = preview_of(noise(200, 100, 1), 1'000'000);
    const Preview small = preview_of(noise(200, 100, 1), 20'000);
    EXPECT_GT(large.png.size(), 20'000u);
    EXPECT_LE(small.png.size(), 20'000u);
    EXPECT_EQ(small.width, 200) << "the page shows it at the size of the original";
}

TEST(Histogram, CountsEveryPixelOnce) {
    const std::string svg = histogram_svg({0, 0, 1e-9, 3e-5, 3.1e-5, 1, 7}, {1e-4});
    EXPECT_THAT(svg, HasSubstr("equal or closer than 1e-7: 3 pixels"));
    EXPECT_THAT(svg, HasSubstr(": 2 pixels"));
    EXPECT_THAT(svg, HasSubstr("threshold 0.0001"));
}

class Folders : public testing::Test {
  protected:
    void write(const std::string& name, const Image& image) {
        const auto path = folder_.path() / name;
        std::filesystem::create_directories(path.parent_path());
        io::write_image(path.string(), image, {});
    }
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
    FolderComparison compare() const {
        reference::CompareOptions options;
        options.flip = false;
        return compare_folders(path("a"), path("b"), options);
    }
    static Verdict verdict_of(const FolderComparison& result, const std::string& name) {
        for (const ReportEntry& entry : result.report.entries) {
            if (entry.name == name) return entry.verdict;
        }
        ADD_FAILURE() << "no entry " << name;
        return Verdict::failed;
    }

    io::TemporaryFolder folder_;
};

TEST_F(Folders, ArePairedByNameBelowToo) {
    for (const char* side : {"a/", "b/"}) {
        write(side + std::string("same.png"), noise(8, 8, 1));
        write(side + std::string("below/same.png"), noise(8, 8, 2));
    }
    const FolderComparison result = compare();
    EXPECT_TRUE(result.pass);
    EXPECT_EQ(result.report.entries.size(), 2u);
    EXPECT_EQ(verdict_of(result, "below/same.png"), Verdict::agrees);
}

TEST_F(Folders, FailForWhatDiffersIsMissingOrIsNoPicture) {
    write("a/different.png", noise(8, 8, 1));
    write("b/different.png", noise(8, 8, 2));
    write("a/lonely.png", noise(8, 8, 1));
    io::write_file(path("a/broken.png"), "no picture");
    write("b/broken.png", noise(8, 8, 1));
    io::write_file(path("a/notes.txt"), "not looked at");
    const FolderComparison result = compare();
    EXPECT_FALSE(result.pass);
    EXPECT_EQ(result.unreadable, 1u);
    EXPECT_EQ(result.report.entries.size(), 3u);
    EXPECT_EQ(verdict_of(result, "different.png"), Verdict::differs);
    EXPECT_EQ(verdict_of(result, "lonely.png"), Verdict::failed);
    EXPECT_EQ(verdict_of(result, "broken.png"), Verdict::failed);
}

TEST_F(Folders, WithoutPicturesAreNotEqualButAMistake) {
    std::filesystem::create_directories(folder_.path() / "a");
    std::filesystem::create_directories(folder_.path() / "b");
    EXPECT_THROW(compare(), FileError);
    EXPECT_THROW(compare_folders(path("a"), path("nowhere"), {}), FileError);
}

TEST(Report, CirclesTheLargestDifferences) {
    ReportEntry entry = entry_of("pair", Verdict::differs);
    entry.left = entry.right = entry.heat = preview_of(Image(320, 240));
    for (int i = 0; i < 100; ++i)
        entry.markers.push_back({i, 7, "silhouette", "edge", 0.001 * i, {}, {}});
    entry.markers.push_back({200, 9, "unexplained", "nobody knows", 1e-3, {}, {}});
    sort_markers(entry.markers);
    EXPECT_EQ(entry.markers[0].x, 200);
    EXPECT_EQ(entry.markers[1].x, 99);
    const std::string html = to_html(report_of({entry}));
    EXPECT_THAT(html, HasSubstr("class=\"k-unexplained\" data-pixel=\"200,9\""));
    EXPECT_THAT(html, HasSubstr("class=\"k-silhouette\" data-pixel=\"99,7\""));
    EXPECT_THAT(html, Not(HasSubstr("class=\"k-silhouette\" data-pixel=\"3,7\"")));
    EXPECT_THAT(html, HasSubstr("The 60 largest are circled."));
    EXPECT_THAT(html, HasSubstr("89 more."));
}

TEST(Report, PutsThePicturesOfOnePairBeforeAllText) {
    ReportEntry entry = entry_of("pair", Verdict::differs);
    entry.left = entry.right = entry.heat = preview_of(Image(32, 24));
    entry.reasons = {"because"};
    Report report = report_of({entry});
    report.about = {{"Rules", "many words"}};
    const std::string html = to_html(report);
    EXPECT_LT(html.find("class=\"badge differs\""), html.find("<img"));
    EXPECT_LT(html.find("<figure class=\"heat\""), html.find("<li>because"));
    EXPECT_LT(html.find("<li>because"), html.find("many words"));
}

TEST(Report, WritesFilesBesideThePageAndLinksThem) {
    ReportEntry entry = entry_of("pair", Verdict::agrees);
    entry.files = {{"a b.pov", "scene", "sphere { }"}};
    const io::TemporaryFolder folder;
    write_report(report_of({entry}), folder.path().string());
    EXPECT_EQ(io::read_file((folder.path() / "a b.pov").string(), 100), "sphere { }");
    EXPECT_THAT(io::read_file((folder.path() / "index.html").string(), 1 << 20),
                HasSubstr("href=\"a%20b.pov\""));
}

TEST(Report, LeavesOutValuesThatWouldFillThePage) {
    ReportEntry entry = entry_of("pair", Verdict::agrees);
    entry.left_values = entry.right_values = exact_values(noise(64, 48, 1));
    const std::size_t bytes = entry.left_values.bytes() + entry.right_values.bytes();
    Report report = report_of({entry, entry});
    fit(report, 8 * bytes);
    EXPECT_FALSE(report.entries[0].left_values.high.empty());
    fit(report, 3 * bytes);
    EXPECT_NE(report.entries[0].left_values.high.empty(),
              report.entries[1].left_values.high.empty())
        << "half of the page is enough for one";
}

TEST(ExactValues, AreTheHighAndLowBytesOfSixteenBits) {
    Image image(3, 1);
    image.data = {0, 1, 0.5, 1.0 / 65535, 258.0 / 65535, 2, -1, 0.25, 0.75};
    const ExactValues values = exact_values(image);
    const Image high = io::decode_png(values.high, "h", io::ColorSpace::automatic);
    const Image low = io::decode_png(values.low, "l", io::ColorSpace::automatic);
    const auto byte = [](double linear) { return std::lround(srgb_encode(linear) * 255); };
    const double clipped[] = {0, 1, 0.5, 1.0 / 65535, 258.0 / 65535, 1, 0, 0.25, 0.75};
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_EQ(256 * byte(high.data[i]) + byte(low.data[i]), std::lround(clipped[i] * 65535))
            << i;
}

TEST(JUnit, CountsAndEscapes) {
    using Outcome = JUnitCase::Outcome;
    const std::string xml = junit_xml(
        "lancer", {{"a<b", 1.5, Outcome::passed, {}},
                   {"c", 0.25, Outcome::failed, {"3 pixels > 1", std::string("a \x01 byte")}},
                   {"d", 0, Outcome::error, {"no POV-Ray"}},
                   {"e", 0, Outcome::skipped, {"refused"}}});
    EXPECT_THAT(xml, HasSubstr("tests=\"4\" failures=\"1\" errors=\"1\" skipped=\"1\" "
                               "time=\"1.750\""));
    EXPECT_THAT(xml, HasSubstr("name=\"a&lt;b\" time=\"1.500\"/>"));
    EXPECT_THAT(xml, HasSubstr("<failure message=\"3 pixels &gt; 1\">3 pixels &gt; 1\na ? byte"));
    EXPECT_THAT(xml, HasSubstr("<error message=\"no POV-Ray\">"));
    EXPECT_THAT(xml, HasSubstr("<skipped message=\"refused\">"));
}

TEST(FolderResults, GiveTheMeasuresOfAllPairs) {
    const io::TemporaryFolder a;
    const io::TemporaryFolder b;
    for (const auto& folder : {a.path(), b.path()})
        io::write_image((folder / "same.png").string(), noise(8, 6, 1), {});
    io::write_image((a.path() / "other.png").string(), noise(8, 6, 2), {});
    io::write_image((b.path() / "other.png").string(), noise(8, 6, 3), {});
    io::write_image((a.path() / "lonely.png").string(), noise(8, 6, 2), {});
    const reference::CompareOptions options;
    const FolderComparison found = compare_folders(a.path().string(), b.path().string(), options);
    const auto json = nlohmann::json::parse(to_json(found, options));
    EXPECT_EQ(json["verdict"], "fail");
    ASSERT_EQ(json["pairs"].size(), 3u);
    EXPECT_EQ(json["pairs"][0]["verdict"], "failed");
    EXPECT_FALSE(json["pairs"][0].contains("measures"));
    EXPECT_EQ(json["pairs"][1]["verdict"], "differs");
    EXPECT_GT(json["pairs"][1]["measures"]["max"], 0);
    EXPECT_EQ(json["pairs"][2]["verdict"], "agrees");
    const auto cases = junit_cases(found);
    EXPECT_EQ(cases[0].outcome, JUnitCase::Outcome::error);
    EXPECT_EQ(cases[1].outcome, JUnitCase::Outcome::failed);
    EXPECT_EQ(cases[2].outcome, JUnitCase::Outcome::passed);
}

TEST(Shell, QuotesWhatAShellTakesApart) {
    EXPECT_EQ(shell_quoted("scenes/a-1.lancer"), "scenes/a-1.lancer");
    EXPECT_EQ(shell_quoted("a b"), "'a b'");
    EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_quoted("$HOME"), "'$HOME'");
    EXPECT_EQ(shell_quoted(""), "''");
}

}  // namespace
}  // namespace lancer::judge
