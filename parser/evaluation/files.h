// The files that a script names: their paths and contents, read once.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "parser/evaluation/context.h"

namespace lancer {

class Files {
  public:
    Files(const Context& context, const Loader& loader) : context_(context), loader_(loader) {}

    const Loader& loader() const { return loader_; }
    /// The path that the script in `file` means.
    std::string resolve_path(const ast::File& file, std::string_view path) const;

    /// The content of the file; nullptr after an error at `place`.
    std::shared_ptr<const io::LoadedMesh> mesh(const std::string& path, const SourceSpan& place);
    std::shared_ptr<const Image> image(const std::string& path, io::ColorSpace space,
                                       const SourceSpan& place);
    /// The same for an image that a mesh file names: a warning instead of an error.
    std::shared_ptr<const Image> image_of_mesh(const std::string& path, io::ColorSpace space,
                                               const SourceSpan& place);
    /// Reports a file that could not be read.
    void report_unreadable(const std::string& path, const SourceSpan& place,
                           const std::string& problem) const;

  private:
    const Loaded<Image>& image_at(const std::string& path, io::ColorSpace space);

    const Context context_;
    const Loader& loader_;
};

/// A key that is equal for two paths of the same file: absolute, with links resolved.
std::string identity(const std::string& path);

}  // namespace lancer
