#include "judge/validate/expect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "model/diagnostic.h"
#include "model/io/temporary_file.h"

namespace lancer::judge {
namespace {

std::string error_of(std::string_view text) {
    try {
        parse_expectations(text, "s.expect");
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Expectations, OfAnEmptyFileAreTheDefaults) {
    const Expectations e = parse_expectations("# nothing\n\n   \r\n", "s.expect");
    EXPECT_EQ(e.thresholds.interior, 1e-4);
    EXPECT_EQ(e.thresholds.unexplained, 0u);
    EXPECT_EQ(e.thresholds.tight_share, 0.999);
    EXPECT_FALSE(e.refused);
    EXPECT_TRUE(e.reasons.empty());
}

TEST(Expectations, KeepValuesWithTheirReasons) {
    const Expectations e = parse_expectations(
        "# the rim\nunexplained  40\t# absorption: 40 pixels\ntight 5e-5 # meshes in single "
        "precision\n"
        "refused yes   # no word for it",
        "s.expect");
    EXPECT_EQ(e.thresholds.unexplained, 40u);
    EXPECT_EQ(e.thresholds.tight, 5e-5);
    EXPECT_TRUE(e.refused);
    EXPECT_EQ(e.refusal_reason, "no word for it");
    EXPECT_THAT(e.reasons, testing::ElementsAre("unexplained 40: absorption: 40 pixels",
                                                "tight 5e-5: meshes in single precision",
                                                "refused yes: no word for it"));
}

TEST(Expectations, RefuseWhatTheyDoNotUnderstandWithTheLine) {
    EXPECT_EQ(error_of("\nunexplained 4"),
              "s.expect:2: unexplained needs a reason, written as: unexplained 4  # why");
    EXPECT_EQ(error_of("unexplained 4 #  "),
              "s.expect:1: unexplained needs a reason, written as: unexplained 4  # why");
    EXPECT_THAT(error_of("unexplaned 4 # x"),
                testing::HasSubstr("s.expect:1: unknown key 'unexplaned'"));
    EXPECT_EQ(error_of("unexplained # x"), "s.expect:1: unexplained has no value");
    EXPECT_EQ(error_of("unexplained 4.5 # x"), "s.expect:1: '4.5' is not a valid number");
    EXPECT_EQ(error_of("unexplained -1 # x"), "s.expect:1: '-1' is not a valid number");
    EXPECT_EQ(error_of("interior nan # x"), "s.expect:1: interior must be between 1e-06 and 1");
    EXPECT_EQ(error_of("tight 2 # x"), "s.expect:1: tight must be between 1e-06 and 1");
    EXPECT_EQ(error_of("unexplained 1 # x\nunexplained 2 # y"),
              "s.expect:2: unexplained is given twice");
    EXPECT_EQ(error_of("refused no # x"), "s.expect:1: refused takes only the value yes");
}

TEST(Expectations, AreReadFromTheFileBesideTheScene) {
    const io::TemporaryFolder folder;
    std::ofstream(folder.path() / "a.expect") << "unexplained 3 # why\n";
    EXPECT_EQ(read_expectations((folder.path() / "a.lancer").string()).thresholds.unexplained, 3u);
    EXPECT_EQ(read_expectations((folder.path() / "b.lancer").string()).thresholds.unexplained, 0u);
}

}  // namespace
}  // namespace lancer::judge
