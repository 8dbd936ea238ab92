// Is a JPEG file whole?
#pragma once

#include <string_view>

namespace lancer::io {

/// True when the end-of-image marker follows the scan: libjpeg itself makes up what is missing from
/// a truncated file. Walks over the segments before the scan, for a thumbnail in one of them has an
/// end-of-image marker too (ITU-T T.81, annex B).
inline bool jpeg_is_complete(std::string_view bytes) {
    const auto byte = [&](std::size_t i) -> std::size_t {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
    };
    std::size_t at = 2;  // behind the start-of-image marker
    while (at < bytes.size()) {
        if (byte(at) != 0xFF) return false;
        const std::size_t marker = byte(at + 1);
        if (marker == 0xFF) {  // a fill byte
            ++at;
            continue;
        }
        const bool start_of_scan = marker == 0xDA;
        const std::size_t length = byte(at + 2) << 8 | byte(at + 3);
        at += 2 + length;
        // In the scan itself 0xFF is always followed by a zero or a restart marker.
        if (start_of_scan) return bytes.find("\xFF\xD9", at) != std::string_view::npos;
    }
    return false;
}

}  // namespace lancer::io
