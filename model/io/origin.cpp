#include "model/io/origin.h"

#include <fmt/format.h>

#include "base/sha256.h"
#include "model/io/file.h"
#include "model/io/picture_format.h"
#include "model/io/png_file.h"

namespace lancer::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view keyword = "lancer:origin";
constexpr std::string_view seal_line = "seal ";
constexpr std::size_t end_chunk = 12;  // IEND, the last of a PNG
constexpr std::size_t checksum = 4;

/// Takes the next line off `text` and returns what follows `key` on it.
std::optional<std::string> line(std::string_view& text, std::string_view key) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos || !text.starts_with(key)) return std::nullopt;
    std::string value(text.substr(key.size(), end - key.size()));
    text.remove_prefix(end + 1);
    return value;
}

/// The position of a PNG's last chunk before its end; nothing when that chunk holds no origin.
std::optional<std::size_t> origin_chunk(std::string_view png) {
    const std::string mark = "tEXt" + std::string(keyword) + '\0';
    const std::size_t found = png.rfind(mark);
    if (found == std::string_view::npos || found < 4) return std::nullopt;
    return found - 4;
}

/// The note that reserves room in an EXR for the origin and the digest.
std::pair<std::string, std::string> note_of(const Origin& origin) {
    return {std::string(keyword.substr(keyword.find(':') + 1)),
            to_text(origin) + std::string(seal_line) + std::string(sha256_digits, '0')};
}

/// The place of the digest in an EXR that was written with its note, and the origin.
struct Place {
    std::size_t digits;
    Origin origin;
};
std::optional<Place> place_in_exr(std::string_view exr) {
    const std::string mark = std::string(keyword) + '\0' + "string" + '\0';
    const std::size_t found = exr.find(mark);
    if (found == std::string_view::npos) return std::nullopt;
    const std::size_t text = found + mark.size() + sizeof(std::uint32_t);
    const std::size_t seal = exr.find(seal_line, std::min(text, exr.size()));
    if (seal == std::string_view::npos || exr.size() - seal < seal_line.size() + sha256_digits)
        return std::nullopt;
    const std::optional<Origin> origin = origin_of_text(exr.substr(text, seal - text));
    if (!origin) return std::nullopt;
    return Place{seal + seal_line.size(), *origin};
}

}  // namespace

std::string to_text(const Origin& origin) {
    return fmt::format("scene {}\nbuild {}\noptions {}\n", origin.scene, origin.build,
                       origin.options);
}

std::optional<Origin> origin_of_text(std::string_view text) {
    const auto scene = line(text, "scene ");
    const auto build = line(text, "build ");
    const auto options = line(text, "options ");
    if (!scene || !build || !options || !text.empty()) return std::nullopt;
    return Origin{*scene, *build, *options};
}

std::string difference(const Origin& there, const Origin& wanted) {
    if (there.scene != wanted.scene) return "another scene";
    if (there.options != wanted.options) {
        return fmt::format("other options ({}; wanted are {})", there.options, wanted.options);
    }
    if (there.build != wanted.build) return "another build of lancer";
    return "";
}

std::string with_origin(std::string bytes, const Origin& origin) {
    if (is_png(bytes)) {
        const std::string text = to_text(origin);
        const std::string seal = sha256(bytes + text);
        return with_png_text(std::move(bytes), std::string(keyword),
                             text + std::string(seal_line) + seal);
    }
    if (const std::optional<Place> place = place_in_exr(bytes))
        bytes.replace(place->digits, sha256_digits, sha256(bytes));
    return bytes;
}

ImageWriteOptions options_with_origin(ImageWriteOptions options, const std::string& path,
                                      const Origin& origin) {
    if (format_of_name(path) == "openexr") options.notes.push_back(note_of(origin));
    return options;
}

void write_image(const std::string& path, const Image& image, ImageWriteOptions options,
                 const Origin& origin) {
    options = options_with_origin(std::move(options), path, origin);
    write_file(path, with_origin(encode_image(path, image, options), origin));
}

std::optional<Origin> origin_of_picture(std::string bytes) {
    if (!is_png(bytes)) {
        const std::optional<Place> place = place_in_exr(bytes);
        if (!place) return std::nullopt;
        const std::string seal = bytes.substr(place->digits, sha256_digits);
        bytes.replace(place->digits, sha256_digits, sha256_digits, '0');
        return sha256(bytes) == seal ? std::optional(place->origin) : std::nullopt;
    }
    const std::optional<std::size_t> chunk = origin_chunk(bytes);
    if (!chunk) return std::nullopt;
    const std::size_t begin = *chunk + 8 + keyword.size() + 1;
    const std::size_t seal = bytes.find(seal_line, begin);
    if (seal == std::string::npos) return std::nullopt;
    const std::size_t end = seal + seal_line.size() + sha256_digits;
    if (bytes.size() != end + checksum + end_chunk) return std::nullopt;
    const std::optional<Origin> origin =
        origin_of_text(std::string_view(bytes).substr(begin, seal - begin));
    if (!origin) return std::nullopt;
    // Restores the file without the chunk and adds the chunk again: so its length and checksum are
    // compared, too.
    std::string bare = bytes;
    bare.erase(*chunk, end + checksum - *chunk);
    return with_origin(std::move(bare), *origin) == bytes ? origin : std::nullopt;
}

}  // namespace lancer::io
