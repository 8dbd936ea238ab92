#include "reference/pov/signature.h"

#include "base/sha256.h"
#include "model/io/png_file.h"

namespace lancer::reference {
namespace {

constexpr std::string_view author = "lancer export ";
constexpr std::size_t digest_size = 64;
constexpr std::string_view keyword = "Software";
constexpr std::size_t end_chunk = 12;  // IEND, the last chunk of a PNG

constexpr std::size_t size_in_pov = 3 + author.size() + digest_size + 1;
constexpr std::size_t size_in_png = 12 + keyword.size() + 1 + author.size() + digest_size;

}  // namespace

std::string with_signature(const std::string& bytes) {
    const std::string mark = std::string(author) + sha256(bytes);
    if (io::is_png(bytes)) return io::with_png_text(bytes, std::string(keyword), mark);
    return bytes + "// " + mark + "\n";
}

bool is_signed(std::string_view bytes) {
    std::string bare(bytes);
    if (io::is_png(bytes)) {
        if (bytes.size() < size_in_png + end_chunk) return false;
        bare.erase(bytes.size() - end_chunk - size_in_png, size_in_png);
    } else {
        if (bytes.size() < size_in_pov) return false;
        bare.resize(bytes.size() - size_in_pov);
    }
    return with_signature(bare) == bytes;
}

}  // namespace lancer::reference
