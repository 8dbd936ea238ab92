// docs/adding-a-shape.md and docs/adding-a-light.md list every place that a new shape or light must
// be added to: one that is in the variant alone does not compile there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/house/source_text.h"

namespace {

namespace fs = std::filesystem;

struct Place {
    std::string file;
    std::string name;
};

std::vector<Place> places_of(const std::string& page_path) {
    const std::string page = read_text(root / page_path);
    const std::size_t begin = page.find("<!-- lists -->");
    const std::string table = page.substr(begin, page.find("<!-- lists end -->") - begin);
    const std::regex row(R"re(\n\| `([^`]+)` \| `([^`]+)` \|)re");
    std::vector<Place> places;
    for (auto match = std::sregex_iterator(table.begin(), table.end(), row);
         match != std::sregex_iterator(); ++match)
        places.push_back({(*match)[1].str(), (*match)[2].str()});
    return places;
}

/// A folder of headers that take precedence over the project's.
class ChangedHeaders {
  public:
    explicit ChangedHeaders(const std::string& name)
        : path_(fs::temp_directory_path() / ("lancer-" + name + "-" + std::to_string(::getpid()))) {
    }
    ~ChangedHeaders() { fs::remove_all(path_); }

    /// Adds an unknown struct to a variant.
    void widen_variant(const std::string& header, const std::string& variant) {
        std::string text = read_text(root / header);
        const std::size_t at = text.find("using " + variant);
        text.insert(text.find('>', at), ", Newcomer");
        text.insert(text.rfind("\n\n", at), "\n\nstruct Newcomer {};");
        write(header, text);
    }
    /// Adds a name to an enumeration. `before` is the first text of its definition.
    void widen_enumeration(const std::string& header, const std::string& before) {
        std::string text = read_text(root / header);
        const std::size_t at = text.find(before);
        ASSERT_NE(at, std::string::npos) << header;
        text.insert(text.find('{', at) + 1, " newcomer, ");
        write(header, text);
    }

    /// The compiler's errors for a source.
    std::string errors_of(const std::string& source) const {
        const fs::path log = path_ / "log";
        const std::string level =
            source.find("_avx2") == std::string::npos ? "" : "-mavx2 -mfma -mbmi -mbmi2 ";
        const std::string command =
            "cd '" + root.string() +
            "' && " LANCER_COMPILER " -std=gnu++20 -fsyntax-only -Wswitch -Werror=switch " + level +
            "-I'" + path_.string() + "' -I. '" + source + "' > '" + log.string() + "' 2>&1";
        const int status = std::system(command.c_str());
        return status == 0 ? std::string() : read_text(log);
    }

  private:
    void write(const std::string& header, const std::string& text) const {
        fs::create_directories((path_ / header).parent_path());
        std::ofstream(path_ / header) << text;
    }

    fs::path path_;
};

/// A header is compiled through a file that includes it.
std::string source_of(const std::string& file) {
    if (file.ends_with(".cpp")) return file;
    if (file == "model/light_facts.h") return "cli/scene_summary.cpp";
    if (file.starts_with("model/")) return "cli/scene_digest.cpp";
    if (file == "tracer/compile/shape_compiler.h" || file == "tracer/compile/texture_binder.h")
        return "tracer/compile/geometry_double.cpp";
    return file.starts_with("tracer/wide/") ? "tracer/wide/level_avx2.cpp"
                                            : "tracer/render_double.cpp";
}

/// \param added  the places that the page names first; these are not checked
void expect_all_fail(const ChangedHeaders& headers, const std::vector<Place>& places,
                     const std::set<std::string>& added) {
    std::map<std::string, std::string> all_errors;  // by source
    for (const Place& place : places) {
        if (added.contains(place.name)) continue;
        const std::string source = source_of(place.file);
        const auto [known, is_new] = all_errors.try_emplace(source);
        if (is_new) known->second = headers.errors_of(source);
        const std::string& errors = known->second;
        EXPECT_THAT(errors,
                    testing::AnyOf(testing::HasSubstr("Newcomer"), testing::HasSubstr("newcomer")))
            << place.file << " compiles without what is new, or says nothing of it";
        EXPECT_NE(errors.find(place.name), std::string::npos)
            << place.file << ": the error does not lead to " << place.name << '\n'
            << errors.substr(0, 2000);
    }
}

TEST(AddingAShape, EveryListOnThePageFailsToCompileWithoutIt) {
    const std::vector<Place> places = places_of("docs/adding-a-shape.md");
    ASSERT_GT(places.size(), 8u);
    ChangedHeaders headers("shape");
    headers.widen_variant("model/shapes.h", "Shape");
    expect_all_fail(headers, places, {"Shape"});
}

TEST(AddingAShape, TakesAtMostEightFilesThatAreThere) {
    std::set<std::string> files;
    for (const Place& place : places_of("docs/adding-a-shape.md")) files.insert(place.file);
    EXPECT_THAT(files, testing::SizeIs(testing::AllOf(testing::Gt(1u), testing::Le(8u))));
}

TEST(AddingALight, EveryListOnThePageFailsToCompileWithoutIt) {
    const std::vector<Place> places = places_of("docs/adding-a-light.md");
    ASSERT_GT(places.size(), 10u);
    ChangedHeaders headers("light");
    headers.widen_variant("model/light.h", "LightKind");
    headers.widen_enumeration("tracer/scene/world.h", "enum class Kind { point");
    headers.widen_enumeration("tracer/wide/scene.h",
                              "enum class Kind : std::uint8_t {\n        point");
    expect_all_fail(headers, places, {"LightKind", "LightSource", "Light"});
}

}  // namespace
