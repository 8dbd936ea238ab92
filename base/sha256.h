// SHA-256 (FIPS 180-4). Its digests name stored data by what it was made from, and detect damage.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace lancer {

/// The digest of bytes that come piece by piece.
class Sha256 {
  public:
    void add(std::string_view bytes);
    /// 64 lower-case hexadecimal digits; to be called once, after the last piece.
    std::string digits();

  private:
    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,  // 5.3.3
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::string rest_;  ///< less than a block
    std::uint64_t size_ = 0;
};

inline constexpr std::size_t sha256_digits = 64;

/// The digest of `bytes`, as digits.
std::string sha256(std::string_view bytes);

/// `part` with its length in front, so that two different lists of parts never read the same.
std::string framed(std::string_view part);

}  // namespace lancer
