// The same bytes for any number of threads and on any processor.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

/// Calls every transcendental function that a picture depends on: highlights, fades, absorption,
/// rotations, mappings, the script's own mathematics.
std::string scene_with_everything() {
    return small_scene() + R"(
material glass { transmission 0.9 ior 1.5 fresnel true reflection 1 absorption [0.3, 0.1, 0.2] }
texture tiles { checker [[1, 1, 1], [0.1, 0.1, 0.3]] scale 0.3 rotate_y 31 }
light spot { position [-3, 5, 4] look_at [0, 0, 0] radius 10 falloff 35 tightness 3
             fade_distance 6 fade_power 1.7 color [0.6, 0.5, 0.4] }
sphere { center [-1, 0.7, 1] radius 0.7 material glass }
for i in 0..12 {
  cylinder { base [0, 0, 0] top [0, 1 + 0.3 * sin(i), 0] radius 0.05 + 0.05 * rand(i)
             rotate [[1, 1, 0.3], i * 17] translate [2 * cos(i), 0, exp(sin(i)) - 1]
             material { color tiles blinn 0.4 roughness 0.03 metallic 0.5 } }
}
)";
}

class SameBytes : public testing::Test {
  protected:
    SameBytes() { place_.write("a.lancer", scene_with_everything()); }
    std::string picture(const std::string& threads, const std::vector<std::string>& variables = {},
                        const std::vector<std::string>& options = {"--samples", "2"}) {
        std::vector<std::string> arguments{"render",    "a.lancer", "-o",     "a.exr",
                                           "--threads", threads,    "--size", "160x120"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Finished finished = place_.run(arguments, "", variables);
        EXPECT_LE(finished.code, 1) << finished.err;
        return place_.read("a.exr");
    }
    Workplace place_;
};

TEST_F(SameBytes, ForAnyNumberOfThreads) {
    const std::string one = picture("1");
    EXPECT_TRUE(one == picture("2"));
    EXPECT_TRUE(one == picture("7"));
}

TEST_F(SameBytes, ForAnyNumberOfThreadsWhenAnErrorIsAskedFor) {
    const std::vector<std::string> options{"--max-error", "0.02", "--aov"};
    const std::string one = picture("1", {}, options);
    EXPECT_TRUE(one == picture("3", {}, options));
}

/// glibc chooses its sin, exp and pow by these settings; version 2.36 knows both spellings.
const std::string old_processor =
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-FMA4_Usable,-FMA4";

/// The results of the C library's functions, bit by bit.
std::string c_library_digest(const std::string& variable) {
    const std::string command = "env " + variable + " '" LANCER_C_LIBRARY_DIGEST "'";
    std::string digest;
    FILE* program = popen(command.c_str(), "r");
    for (int c = 0; program != nullptr && (c = fgetc(program)) != EOF;)
        digest += static_cast<char>(c);
    EXPECT_EQ(program == nullptr ? -1 : pclose(program), 0);
    return digest;
}

TEST_F(SameBytes, OnProcessorsWithAndWithoutFusedOperations) {
    if (!__builtin_cpu_supports("fma") || !__builtin_cpu_supports("avx2"))
        GTEST_SKIP() << "this processor has nothing to switch off";
    ASSERT_NE(c_library_digest(""), c_library_digest(old_processor))
        << "the switch took no effect, so that this test would prove nothing";
    EXPECT_TRUE(picture("2") == picture("2", {old_processor}));
}

}  // namespace
}  // namespace lancer::cli
