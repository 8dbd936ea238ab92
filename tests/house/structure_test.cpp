// The rules of docs/architecture.md that a compiler does not check.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/house/source_text.h"

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> libraries{"base",     "model",     "parser", "tracer",
                                         "accuracy", "reference", "judge"};

struct SourceFile {
    std::string path;    ///< from the project's root
    std::string folder;  ///< the first part of the path
    std::vector<std::string> lines;
};

std::vector<std::string> read_lines(const fs::path& path) {
    std::vector<std::string> lines;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<SourceFile> sources_of(const std::vector<std::string>& folders) {
    std::vector<SourceFile> found;
    for (const std::string& folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".cpp" && ending != ".h") continue;
            found.push_back({fs::relative(entry.path(), root).generic_string(), folder,
                             read_lines(entry.path())});
        }
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.path < b.path; });
    return found;
}

/// The name that a line includes, with `"` or `<` before it, or nothing.
std::string included_by(const std::string& line) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*(["<][^">]+)[">])re");
    std::smatch match;
    return std::regex_search(line, match, pattern) ? match[1].str() : std::string();
}

/// The line without string literals and without a // comment, so that words in them do not count.
std::string code_of(const std::string& line) {
    static const std::regex text(R"re("([^"\\]|\\.)*")re");
    const std::string bare = std::regex_replace(line, text, "\"\"");
    return bare.substr(0, bare.find("//"));
}

std::string place(const SourceFile& file, std::size_t line) {
    return file.path + ":" + std::to_string(line + 1) + ": " + file.lines[line];
}

TEST(Structure, FoldersIncludeOnlyWhatTheArrowsAllow) {
    const std::map<std::string, std::vector<std::string>> allowed{
        {"base", {"base"}},
        {"model", {"model", "base"}},
        {"parser", {"parser", "model", "base"}},
        {"tracer", {"tracer", "model", "base"}},
        {"accuracy", {"accuracy", "model", "base", "tracer/render.h"}},
        {"reference", {"reference", "model", "base"}},
        {"judge", {"judge", "accuracy", "reference", "model", "base", "tracer/render.h"}},
        {"cli", {"cli", "base", "model", "parser", "tracer", "accuracy", "reference", "judge"}},
    };
    std::vector<std::string> broken;
    std::size_t seen = 0;
    for (const SourceFile& file : sources_of(
             {"base", "model", "parser", "tracer", "accuracy", "reference", "judge", "cli"})) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string name = included_by(file.lines[i]);
            if (name.empty() || name.front() != '"') continue;
            ++seen;
            // A whole folder, or one header of it.
            const std::string header = name.substr(1);
            const std::string folder = header.substr(0, header.find('/'));
            const auto& may = allowed.at(file.folder);
            if (std::none_of(may.begin(), may.end(),
                             [&](const auto& m) { return m == folder || m == header; }))
                broken.push_back(place(file, i));
        }
    }
    EXPECT_GT(seen, 20u);
    EXPECT_THAT(broken, testing::IsEmpty());
}

/// The rooms of the tracer, in the order of docs/architecture.md.
const std::vector<std::string> rooms{
    "tracer/numerics", "tracer/rays",      "tracer/bvh",   "tracer/splines", "tracer/tessellation",
    "tracer/textures", "tracer/shapes",    "tracer/scene", "tracer/compile", "tracer/intersect",
    "tracer/shading",  "tracer/recursion", "tracer/wide",  "tracer/povray",  "tracer"};

TEST(Structure, RoomsOfTheTracerIncludeOnlyThoseBelow) {
    const auto floor_of = [](const std::string& path) {
        const std::string room = path.substr(0, path.rfind('/'));
        return std::find(rooms.begin(), rooms.end(), room) - rooms.begin();
    };
    std::vector<std::string> broken;
    for (const SourceFile& file : sources_of({"tracer"})) {
        const auto floor = floor_of(file.path);
        if (floor == static_cast<std::ptrdiff_t>(rooms.size()))
            broken.push_back(file.path + ": its folder has no place in the order");
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string name = included_by(file.lines[i]);
            if (name.starts_with("\"tracer/") && floor_of(name.substr(1)) > floor)
                broken.push_back(place(file, i));
        }
    }
    EXPECT_THAT(broken, testing::IsEmpty());
}

/// The project's files that a file includes, and those that they include.
std::set<std::string> all_included_by(const std::string& path) {
    std::set<std::string> all;
    std::vector<std::string> waiting{path};
    while (!waiting.empty()) {
        const fs::path file = root / waiting.back();
        waiting.pop_back();
        for (const std::string& line : read_lines(file)) {
            const std::string name = included_by(line);
            if (name.empty() || name.front() != '"') continue;
            if (all.insert(name.substr(1)).second) waiting.push_back(name.substr(1));
        }
    }
    return all;
}

// They are compiled for long, and a change of materials, lights or textures spares them.
TEST(Structure, SearchesSeeTheGeometryAlone) {
    for (const std::string source :
         {"tracer/intersect/searches_single.cpp", "tracer/intersect/searches_double.cpp",
          "tracer/intersect/searches_extended.cpp", "tracer/compile/geometry_single.cpp",
          "tracer/compile/geometry_double.cpp", "tracer/compile/geometry_extended.cpp",
          "tracer/povray/first_hit.cpp", "tracer/wide/scalar_crossings.cpp"}) {
        const std::set<std::string> included = all_included_by(source);
        EXPECT_TRUE(included.contains("tracer/scene/geometry.h")) << source;
        EXPECT_FALSE(included.contains("tracer/scene/world.h")) << source;
    }
}

TEST(Structure, ArchitectureNamesEveryRoomOfTheTracer) {
    const std::vector<std::string> page = read_lines(root / "docs/architecture.md");
    std::vector<std::string> missing;
    auto line = page.begin();
    for (const std::string& room : rooms) {
        const std::string name = room == "tracer" ? "`tracer/` itself" : room.substr(7) + "/`";
        line = std::find_if(line, page.end(), [&](const std::string& text) {
            return text.starts_with("| `") && text.find(name) < 20;
        });
        if (line == page.end()) {
            missing.push_back(room);
            break;
        }
    }
    EXPECT_THAT(missing, testing::IsEmpty()) << "in this order";
}

TEST(Structure, LibraryHeadersStopInTheirFolder) {
    // A prefix of headers, and the only places that may name it. fmt is allowed everywhere.
    const std::vector<std::pair<std::string, std::vector<std::string>>> homes{
        {"<glm/", {"model/math.h"}},
        {"<sleef", {"model/elementary.cpp", "tracer/wide/"}},
        {"<tao/", {"parser/"}},
        {"<OpenImageIO/", {"model/io/module/"}},
        {"<png", {"model/io/"}},
        {"<zlib", {"model/io/"}},
        {"<tiff", {"model/io/module/"}},
        {"<jpeglib", {"model/io/module/"}},
        {"<jerror", {"model/io/module/"}},
        {"<seccomp", {"model/io/module/"}},
        {"<tiny_obj_loader", {"model/io/"}},
        {"<CLI/", {"cli/"}},
        {"<boost/container/", {"tracer/"}},
        {"<boost/math/", {"judge/", "reference/"}},
        {"<nlohmann/", {"judge/", "reference/", "cli/"}},
        {"<fmt/", {""}},
    };
    // The system's headers by their names; names of the standard library have no dot.
    static const std::regex system(
        R"re(<((sys|linux|asm)/.*|(unistd|fcntl|signal|pthread|dlfcn|spawn|sched|poll|malloc)\.h|)re"
        R"re(\w*intrin\.h|cpuid\.h))re");
    std::vector<std::string> broken;
    for (const SourceFile& file : sources_of(
             {"base", "model", "parser", "tracer", "accuracy", "reference", "judge", "cli"})) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string name = included_by(file.lines[i]);
            if (!name.starts_with('<') || name.find_first_of("./") == std::string::npos) continue;
            if (std::regex_match(name, system)) continue;
            const auto known = std::find_if(homes.begin(), homes.end(), [&](const auto& home) {
                return name.starts_with(home.first);
            });
            const auto is_home = [&](const std::string& home) {
                return file.path.starts_with(home);
            };
            if (known == homes.end() ||
                std::none_of(known->second.begin(), known->second.end(), is_home))
                broken.push_back(place(file, i));
        }
    }
    EXPECT_THAT(broken, testing::IsEmpty());
}

TEST(Structure, LibrariesNeitherPrintNorExit) {
    const std::regex forbidden(
        R"re(\bstd::(cout|cerr|clog|exit|abort|terminate|quick_exit)\b|#\s*include\s*<iostream>|)re"
        R"re(\b(fmt::print|printf|fprintf|puts|fputs|perror|_exit|exit|abort)\s*\(|\bstd(out|err)\b)re");
    std::vector<std::string> broken;
    for (const SourceFile& file : sources_of(libraries)) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            if (std::regex_search(code_of(file.lines[i]), forbidden))
                broken.push_back(place(file, i));
        }
    }
    EXPECT_THAT(broken, testing::IsEmpty());
}

TEST(Structure, NoFileIsTooLong) {
    std::vector<std::string> broken;
    for (const SourceFile& file : sources_of({"base", "model", "parser", "tracer", "accuracy",
                                              "reference", "judge", "cli", "tests"})) {
        if (file.lines.size() > 400)
            broken.push_back(file.path + ": " + std::to_string(file.lines.size()) + " lines");
    }
    EXPECT_THAT(broken, testing::IsEmpty());
}

TEST(Structure, EveryHeaderIsGuardedAndSaysWhatItIsFor) {
    std::vector<std::string> broken;
    for (const SourceFile& file : sources_of(
             {"base", "model", "parser", "tracer", "accuracy", "reference", "judge", "cli"})) {
        if (!file.path.ends_with(".h")) continue;
        const bool says = !file.lines.empty() && file.lines.front().starts_with("//");
        const bool once =
            std::find(file.lines.begin(), file.lines.end(), "#pragma once") != file.lines.end();
        if (!says || !once) broken.push_back(file.path);
    }
    EXPECT_THAT(broken, testing::IsEmpty());
}

TEST(Structure, EverySourceIsListedInItsFoldersBuildFile) {
    std::vector<std::string> broken;
    for (const SourceFile& file : sources_of({"base", "model", "parser", "tracer", "accuracy",
                                              "reference", "judge", "cli", "tests"})) {
        if (!file.path.ends_with(".cpp")) continue;
        // The nearest build file at or above the source's folder.
        fs::path folder = (root / file.path).parent_path();
        while (!fs::exists(folder / "CMakeLists.txt")) folder = folder.parent_path();
        const std::string name = fs::relative(root / file.path, folder).generic_string();
        bool listed = false;
        for (const std::string& line : read_lines(folder / "CMakeLists.txt"))
            listed = listed || line.find(name) != std::string::npos;
        if (!listed) broken.push_back(file.path);
    }
    EXPECT_THAT(broken, testing::IsEmpty());
}

}  // namespace
