// docs/adding-a-shape.md lists every place that a new shape must be added to: a shape that is in
// the variant alone does not compile there.
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

namespace {

namespace fs = std::filesystem;

const fs::path root = LANCER_SOURCE_DIR;

std::string read_text(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Place {
    std::string file;
    std::string name;
};

std::vector<Place> places_of_the_page() {
    const std::string page = read_text(root / "docs/adding-a-shape.md");
    const std::size_t begin = page.find("<!-- lists -->");
    const std::string table = page.substr(begin, page.find("<!-- lists end -->") - begin);
    const std::regex row(R"re(\n\| `([^`]+)` \| `([^`]+)` \|)re");
    std::vector<Place> places;
    for (auto match = std::sregex_iterator(table.begin(), table.end(), row);
         match != std::sregex_iterator(); ++match)
        places.push_back({(*match)[1].str(), (*match)[2].str()});
    return places;
}

/// A folder whose model/shapes.h has one shape more, which nobody knows.
class FolderWithOneShapeMore {
  public:
    FolderWithOneShapeMore()
        : path_(fs::temp_directory_path() / ("lancer-shape-" + std::to_string(::getpid()))) {
        std::string shapes = read_text(root / "model/shapes.h");
        const std::size_t variant = shapes.find("using Shape");
        shapes.insert(shapes.find('>', variant), ", Newcomer");
        shapes.insert(shapes.rfind("\n\n", variant), "\n\nstruct Newcomer {};");
        fs::create_directories(path_ / "model");
        std::ofstream(path_ / "model/shapes.h") << shapes;
    }
    ~FolderWithOneShapeMore() { fs::remove_all(path_); }

    /// What the compiler says of a source.
    std::string errors_of(const std::string& source) const {
        const fs::path log = path_ / "log";
        const std::string command =
            "cd '" + root.string() + "' && " LANCER_COMPILER " -std=gnu++20 -fsyntax-only -I'" +
            path_.string() + "' -I. '" + source + "' > '" + log.string() + "' 2>&1";
        const int status = std::system(command.c_str());
        return status == 0 ? std::string() : read_text(log);
    }

  private:
    fs::path path_;
};

/// A header is compiled by a file that uses it.
std::string source_of(const std::string& file) {
    if (file.ends_with(".cpp")) return file;
    return file.starts_with("model/") ? "cli/scene_digest.cpp" : "tracer/render_double.cpp";
}

TEST(AddingAShape, EveryListOnThePageFailsToCompileWithoutIt) {
    const std::vector<Place> places = places_of_the_page();
    ASSERT_GT(places.size(), 8u);
    const FolderWithOneShapeMore folder;
    std::map<std::string, std::string> all_errors;  // by source
    for (const Place& place : places) {
        if (place.name == "Shape") continue;  // where it was added
        const std::string source = source_of(place.file);
        const auto [known, is_new] = all_errors.try_emplace(source);
        if (is_new) known->second = folder.errors_of(source);
        const std::string& errors = known->second;
        EXPECT_NE(errors.find("Newcomer"), std::string::npos)
            << place.file << " compiles without the new shape, or says nothing of it\n"
            << errors.substr(0, 2000);
        EXPECT_NE(errors.find(place.name), std::string::npos)
            << place.file << ": the error does not lead to " << place.name << '\n'
            << errors.substr(0, 2000);
    }
}

TEST(AddingAShape, TakesAtMostEightFilesThatAreThere) {
    std::set<std::string> files;
    for (const Place& place : places_of_the_page()) files.insert(place.file);
    EXPECT_THAT(files, testing::SizeIs(testing::AllOf(testing::Gt(1u), testing::Le(8u))));
}

}  // namespace
