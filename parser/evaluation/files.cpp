#include "parser/evaluation/files.h"

#include <filesystem>

namespace lancer {
namespace {

/// The path without `.` and `..`, unless that would name another file: `..` behind a link to a
/// folder is the parent of the folder that the link leads to.
std::string tidied(const std::filesystem::path& path) {
    const std::filesystem::path tidy = path.lexically_normal();
    // the usual case: no access to the disk
    if (tidy.native() == path.native()) return tidy.string();
    std::error_code ignored;
    const bool elsewhere =
        std::filesystem::exists(path, ignored) && !std::filesystem::equivalent(path, tidy, ignored);
    return (elsewhere ? path : tidy).string();
}

/// Reads the file unless it was read or tried before.
template <class Content, class Read>
void load_once(Loaded<Content>& loaded, const Read& read) {
    if (loaded.content != nullptr || !loaded.problem.empty()) return;
    try {
        loaded.content = std::make_shared<const Content>(read());
    } catch (const FileError& error) {
        loaded.problem = error.what();
    }
}

}  // namespace

std::string identity(const std::string& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    const auto followed = std::filesystem::weakly_canonical(absolute, error);
    return (error ? absolute.lexically_normal() : followed).string();
}

std::string Files::resolve_path(const ast::File& file, std::string_view path) const {
    const std::filesystem::path given(path);
    const std::string& script = context_.sources.name(file.source);
    if (given.is_absolute() || script == "-") return tidied(given);
    return tidied(std::filesystem::path(script).parent_path() / given);
}

std::shared_ptr<const io::LoadedMesh> Files::mesh(const std::string& path,
                                                  const SourceSpan& place) {
    auto& loaded = context_.program.meshes[path];
    load_once(loaded, [&] { return loader_.mesh(path); });
    if (loaded.content == nullptr) report_unreadable(path, place, loaded.problem);
    return loaded.content;
}

const Loaded<Image>& Files::image_at(const std::string& path, io::ColorSpace space) {
    auto& loaded = context_.program.images[{path, space}];
    load_once(loaded, [&] { return in_color(loader_.image(path, space)); });
    return loaded;
}

std::shared_ptr<const Image> Files::image(const std::string& path, io::ColorSpace space,
                                          const SourceSpan& place) {
    const Loaded<Image>& loaded = image_at(path, space);
    if (loaded.content == nullptr) report_unreadable(path, place, loaded.problem);
    return loaded.content;
}

std::shared_ptr<const Image> Files::image_of_mesh(const std::string& path, io::ColorSpace space,
                                                  const SourceSpan& place) {
    const Loaded<Image>& loaded = image_at(path, space);
    if (loaded.content == nullptr)
        context_.report.warning(Message::mesh_file, place, loaded.problem);
    return loaded.content;
}

void Files::report_unreadable(const std::string& path, const SourceSpan& place,
                              const std::string& problem) const {
    Diagnostic* error = context_.report.error(Message::file_unreadable, place, problem);
    if (error != nullptr && path.find_first_of("\n\t") != std::string::npos)
        error->hint =
            "in a string '\\n' is a new line and '\\t' a tab: write '/' or '\\\\' in file names";
}

}  // namespace lancer
