#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "model/diagnostic.h"
#include "model/io/image_module.h"

namespace lancer::io {
namespace {

/// The possible places of the module: as installed (LANCER_MODULE_FOLDER is relative to the
/// program's folder), in the build, or beside the program.
std::vector<std::filesystem::path> candidates() {
    const std::string name = "lancer_images.so";
    std::error_code error;
    const std::filesystem::path folder =
        std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    return {folder / LANCER_MODULE_FOLDER / name, folder / "../lib" / name, folder / name};
}

const ImageModule& load() {
    std::string reason;
    for (const std::filesystem::path& path : candidates()) {
        std::error_code error;
        if (!std::filesystem::exists(path, error)) continue;
        void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays loaded until the end
        void* symbol = library != nullptr ? dlsym(library, "lancer_image_module") : nullptr;
        if (symbol != nullptr) {
            return *reinterpret_cast<decltype(&lancer_image_module)>(symbol)();
        }
        reason = dlerror();
    }
    if (reason.empty()) {
        reason = candidates().front().lexically_normal().string() +
                 " is missing (Debian: apt-get install lancer-pictures)";
    }
    throw FileError(
        fmt::format("only PNG and PPM pictures can be read and written, and PFM pictures can be "
                    "read: the module for other formats cannot be loaded: {}",
                    reason));
}

}  // namespace

const ImageModule& image_module() {
    static const ImageModule& module = load();  // tried again after an exception
    return module;
}

}  // namespace lancer::io
