// docs/adding-a-shape.md lists every place that a new shape must be added to: a shape that is in
// the variant alone does not compile there.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
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

    /// What the compiler says of the file.
    std::string errors_of(const std::string& file) const {
        // A header is compiled by the file that uses it.
        const std::string source =
            file.ends_with(".cpp") ? file : std::string("tracer/render_double.cpp");
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

TEST(AddingAShape, EveryListOnThePageFailsToCompileWithoutIt) {
    const std::vector<Place> places = places_of_the_page();
    ASSERT_GT(places.size(), 8u);
    const FolderWithOneShapeMore folder;
    for (const Place& place : places) {
        if (place.name == "Shape") continue;  // where it was added
        const std::string errors = folder.errors_of(place.file);
        EXPECT_NE(errors.find("Newcomer"), std::string::npos)
            << place.file << " compiles without the new shape, or says nothing of it\n"
            << errors.substr(0, 2000);
        EXPECT_NE(errors.find(place.name), std::string::npos)
            << place.file << ": the error does not lead to " << place.name << '\n'
            << errors.substr(0, 2000);
    }
}

}  // namespace
