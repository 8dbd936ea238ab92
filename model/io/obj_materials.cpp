#include "model/io/obj_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "model/diagnostic.h"
#include "model/io/text_scanner.h"

namespace lancer::io {
namespace {

/// The path of a name in `file`. Here `-` is an ordinary file name, not standard input.
std::string beside(const std::string& file, std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::string path =
        (std::filesystem::path(file).parent_path() / std::filesystem::path(name)).string();
    return path == "-" ? "./-" : path;
}

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    constexpr const char* blanks = " \t";
    std::size_t begin = 0;
    while ((begin = text.find_first_not_of(blanks, begin)) != std::string::npos) {
        const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

class MaterialFinder {
  public:
    MaterialFinder(const std::string& mesh, const ReadFile& read_file)
        : mesh_(mesh), read_file_(read_file) {}

    ObjMaterials find(const LoadedMesh& loaded) {
        for (const LibraryStatement& statement : loaded.libraries) read_all(statement);
        std::string missing;
        for (const std::string& name : loaded.materials) {
            const auto known =
                std::find_if(known_.begin(), known_.end(),
                             [&](const MtlMaterial& material) { return material.name == name; });
            found_.materials.emplace_back();
            if (known != known_.end()) {
                found_.materials.back() = *known;
            } else if (!name.empty()) {
                missing += (missing.empty() ? "'" : ", '") + quotable(name) + "'";
            }
        }
        // The warning about a library that could not be read covers its materials.
        if (!missing.empty() && all_read_)
            found_.warnings.push_back(
                fmt::format("{}: no library contains these materials: {}", mesh_, missing));
        return std::move(found_);
    }

  private:
    /// The names are tried as one name with blanks, then as several names.
    void read_all(const LibraryStatement& statement) {
        std::string problem;
        if (read(statement.names, problem)) return;
        const std::vector<std::string> names = words_of(statement.names);
        if (names.size() > 1) problem.clear();
        for (const std::string& name : names) {
            std::string own_problem;
            if (names.size() > 1 && !read(name, own_problem) && problem.empty())
                problem = own_problem;
        }
        if (names.empty()) problem = "no file is named";
        if (problem.empty()) return;
        all_read_ = false;
        found_.warnings.push_back(
            fmt::format("{}:{}: the materials cannot be read: {}", mesh_, statement.line, problem));
    }

    bool read(const std::string& name, std::string& problem) {
        if (name.empty()) return false;
        const std::string path = beside(mesh_, name);
        if (!seen_.insert(path).second) return true;
        MtlFile file;
        try {
            file = read_mtl(read_file_(path), path);
        } catch (const FileError& error) {
            problem = error.what();
            return false;
        }
        for (MtlMaterial& material : file.materials) {
            if (!material.image.empty()) material.image = beside(path, material.image);
            known_.push_back(std::move(material));
        }
        std::string skipped;
        for (const std::string& what : file.skipped)
            skipped += (skipped.empty() ? "" : ", ") + what;
        if (!skipped.empty())
            found_.warnings.push_back(
                fmt::format("{}: skipped, because Lancer does not support it: {}", path, skipped));
        return true;
    }

    const std::string& mesh_;
    const ReadFile& read_file_;
    ObjMaterials found_;
    std::vector<MtlMaterial> known_;
    std::set<std::string> seen_;  ///< paths
    bool all_read_ = true;
};

}  // namespace

ObjMaterials find_materials(const LoadedMesh& loaded, const std::string& path,
                            const ReadFile& read_file) {
    return MaterialFinder(path, read_file).find(loaded);
}

}  // namespace lancer::io
