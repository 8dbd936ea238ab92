// No function compiled for a level can replace the same function of another object.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::string output_of(const std::string& command) {
    std::string output;
    FILE* program = popen(command.c_str(), "r");
    for (int c = 0; program != nullptr && (c = fgetc(program)) != EOF;)
        output += static_cast<char>(c);
    EXPECT_EQ(program == nullptr ? -1 : pclose(program), 0) << command;
    return output;
}

/// A linker may take a weak function from any object that defines it. So the objects of a level may
/// define weak functions only in the namespace of the level, and beside it only their entry
/// function.
TEST(Levels, ObjectsDefineNothingOutsideOfTheirNamespace) {
    const std::string objects = LANCER_LEVEL_OBJECTS;
    std::istringstream list(objects);
    int seen = 0;
    for (std::string object; std::getline(list, object, ' ');) {
        const std::string level = object.find("avx512") != std::string::npos ? "avx512" : "avx2";
        // lancer::wide::avx512 as a mangled name; not all symbols can be demangled.
        const std::string space = "6lancer4wide" + std::to_string(level.size()) + level;
        const std::string entry =
            "_ZN6lancer4wide" + std::to_string(11 + level.size()) + "trace_rays_" + level;
        std::istringstream symbols(output_of("nm --defined-only '" + object + "'"));
        std::vector<std::string> foreign;
        int weak = 0;
        for (std::string line; std::getline(symbols, line);) {
            const std::size_t kind = line.find(' ') + 1;
            const std::string name = line.substr(kind + 2);
            if (std::string("WuTDB").find(line[kind]) == std::string::npos) continue;
            ++weak;
            if (name.starts_with(entry)) continue;
            if (name.find(space) == std::string::npos) foreign.push_back(line);
        }
        EXPECT_GT(weak, 5) << object;
        EXPECT_THAT(foreign, testing::IsEmpty()) << object;
        ++seen;
    }
    if (seen == 0) GTEST_SKIP() << "no levels for this processor's family";
    EXPECT_EQ(seen, 2);
}

}  // namespace
