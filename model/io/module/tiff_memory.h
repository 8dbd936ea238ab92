// libtiff over bytes in memory.
#pragma once

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

namespace lancer::io {

struct TiffMemory {
    std::string_view bytes;
    std::uint64_t at = 0;
};

inline tmsize_t read_memory(thandle_t handle, void* to, tmsize_t size) {
    auto& memory = *static_cast<TiffMemory*>(handle);
    if (memory.at >= memory.bytes.size() || size <= 0) return 0;
    const std::size_t count =
        std::min<std::size_t>(memory.bytes.size() - memory.at, static_cast<std::size_t>(size));
    std::memcpy(to, memory.bytes.data() + memory.at, count);
    memory.at += count;
    return static_cast<tmsize_t>(count);
}
inline tmsize_t write_nothing(thandle_t, void*, tmsize_t) {
    return 0;
}
inline toff_t seek_memory(thandle_t handle, toff_t offset, int whence) {
    auto& memory = *static_cast<TiffMemory*>(handle);
    const toff_t from = whence == SEEK_SET   ? 0
                        : whence == SEEK_CUR ? memory.at
                                             : memory.bytes.size();
    return memory.at = from + offset;
}
inline int close_nothing(thandle_t) {
    return 0;
}
inline toff_t size_of_memory(thandle_t handle) {
    return static_cast<TiffMemory*>(handle)->bytes.size();
}
inline int map_memory(thandle_t handle, void** base, toff_t* size) {
    const std::string_view bytes = static_cast<TiffMemory*>(handle)->bytes;
    *base = const_cast<char*>(bytes.data());
    *size = bytes.size();
    return 1;
}
inline void unmap_nothing(thandle_t, void*, toff_t) {}

struct TiffCloser {
    void operator()(TIFF* file) const { TIFFClose(file); }
};

/// Null when it is not a TIFF file. `memory` must outlive the result.
inline std::unique_ptr<TIFF, TiffCloser> open_in_memory(TiffMemory& memory) {
    return std::unique_ptr<TIFF, TiffCloser>(
        TIFFClientOpen("picture", "r", &memory, read_memory, write_nothing, seek_memory,
                       close_nothing, size_of_memory, map_memory, unmap_nothing));
}

}  // namespace lancer::io
