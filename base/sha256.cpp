#include "base/sha256.h"

#include <algorithm>

#include "base/sha256_blocks.h"

namespace lancer {

void Sha256::add(std::string_view bytes) {
    size_ += bytes.size();
    if (!rest_.empty()) {
        const std::size_t missing = std::min(64 - rest_.size(), bytes.size());
        rest_ += bytes.substr(0, missing);
        bytes.remove_prefix(missing);
        if (rest_.size() < 64) return;
        absorb(state_, rest_.data(), 1);
        rest_.clear();
    }
    absorb(state_, bytes.data(), bytes.size() / 64);
    rest_ = bytes.substr(bytes.size() / 64 * 64);
}

std::string Sha256::digits() {
    // FIPS 180-4, 5.1.1: a one bit, zeros, and the length in bits as a 64-bit number fill the last
    // block.
    std::string tail = "\x80";
    while ((rest_.size() + tail.size()) % 64 != 56) tail += '\0';
    const std::uint64_t bits = size_ * 8;
    for (int shift = 56; shift >= 0; shift -= 8) tail += static_cast<char>(bits >> shift & 0xFF);
    add(tail);
    std::string out;
    for (const std::uint32_t word : state_) {
        for (int shift = 28; shift >= 0; shift -= 4) out += "0123456789abcdef"[word >> shift & 0xF];
    }
    return out;
}

std::string sha256(std::string_view bytes) {
    Sha256 digest;
    digest.add(bytes);
    return digest.digits();
}

std::string framed(std::string_view part) {
    return std::to_string(part.size()) + ":" + std::string(part) + "\n";
}

}  // namespace lancer
