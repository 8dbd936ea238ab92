// The numbers of the faces of solids with several kinds of faces.
#pragma once

#include <cstdint>

namespace lancer {

namespace frustum_face {
inline constexpr std::uint32_t side = 0;
inline constexpr std::uint32_t small_cap = 1;
inline constexpr std::uint32_t large_cap = 2;
}  // namespace frustum_face

}  // namespace lancer
