// TIFF files byte by byte, for tests: any bits, planes, strips, tiles and orientation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lancer::io {

/// What to write. `value(x, y, sample)` gives the steps 0 to 2^bits - 1, or the bits of a float.
struct TiffFile {
    std::uint32_t width = 4;
    std::uint32_t height = 4;
    std::uint32_t samples = 3;
    std::uint32_t bits = 8;
    std::uint32_t photometric = 2;  ///< 0 white is zero, 1 black is zero, 2 RGB, 3 palette, 5 CMYK
    std::uint32_t rows_per_strip = 0;  ///< 0: all of them
    std::uint32_t tile = 0;            ///< width and height of tiles; 0: strips
    std::uint32_t claimed_tile = 0;    ///< the height that the file states, when not 0
    bool separate = false;             ///< plane by plane
    bool pack_bits = false;            ///< compressed
    std::uint32_t orientation = 0;     ///< 0: not said
    std::uint32_t format = 1;          ///< 1 whole numbers, 2 signed, 3 floats
    std::vector<std::uint32_t> extra;  ///< 0 unknown, 1 alpha multiplied in, 2 alpha
    std::vector<std::uint32_t> palette;
    std::function<std::uint64_t(std::uint32_t x, std::uint32_t y, std::uint32_t sample)> value;

    std::string bytes() const {
        std::vector<std::string> parts;
        const std::uint32_t planes = separate ? samples : 1;
        const std::uint32_t step = tile > 0 ? tile : rows_per_strip > 0 ? rows_per_strip : height;
        for (std::uint32_t plane = 0; plane < planes; ++plane) {
            for (std::uint32_t y = 0; y < height; y += step) {
                if (tile == 0) {
                    parts.push_back(part(plane, 0, width, y, std::min(y + step, height)));
                    continue;
                }
                for (std::uint32_t x = 0; x < width; x += tile)
                    parts.push_back(part(plane, x, x + tile, y, y + tile));
            }
        }
        return file(parts, step);
    }

  private:
    static std::string number(std::uint64_t value, int size) {
        std::string out;
        for (int i = 0; i < size; ++i) out.push_back(static_cast<char>(value >> 8 * i));
        return out;
    }

    /// The pixels of one strip or tile; beyond the picture they repeat its edge.
    std::string part(std::uint32_t plane, std::uint32_t x0, std::uint32_t x1, std::uint32_t y0,
                     std::uint32_t y1) const {
        std::string out;
        for (std::uint32_t y = y0; y < y1; ++y) {
            std::string row;
            std::uint32_t filled = 0;  // bits of the last byte
            for (std::uint32_t x = x0; x < x1; ++x) {
                for (std::uint32_t s = 0; s < (separate ? 1 : samples); ++s) {
                    const std::uint64_t v = value(std::min(x, width - 1), std::min(y, height - 1),
                                                  separate ? plane : s);
                    if (bits % 8 == 0) {
                        row += number(v, static_cast<int>(bits / 8));
                        continue;
                    }
                    for (std::uint32_t bit = bits; bit-- > 0;) {
                        if (filled % 8 == 0) row.push_back('\0');
                        row.back() = static_cast<char>(static_cast<unsigned char>(row.back()) |
                                                       (v >> bit & 1) << (7 - filled++ % 8));
                    }
                }
            }
            out += pack_bits ? packed(row) : row;
        }
        return out;
    }

    /// Apple's PackBits: here as literal runs only.
    static std::string packed(const std::string& row) {
        std::string out;
        for (std::size_t at = 0; at < row.size(); at += 128) {
            const std::string run = row.substr(at, 128);
            out.push_back(static_cast<char>(run.size() - 1));
            out += run;
        }
        return out;
    }

    std::string file(const std::vector<std::string>& parts, std::uint32_t step) const {
        using Values = std::vector<std::uint32_t>;
        std::vector<std::uint32_t> places(parts.size(), 0);
        std::vector<std::uint32_t> sizes;
        for (const std::string& bytes_of_part : parts)
            sizes.push_back(static_cast<std::uint32_t>(bytes_of_part.size()));
        const auto directory = [&] {
            struct Tag {
                int number;
                int size;  // of a value, in bytes
                Values values;
            };
            std::vector<Tag> tags{{256, 4, {width}},
                                  {257, 4, {height}},
                                  {258, 2, Values(samples, bits)},
                                  {259, 2, {pack_bits ? 32773u : 1u}},
                                  {262, 2, {photometric}}};
            if (tile == 0) tags.push_back({273, 4, places});
            if (orientation > 0) tags.push_back({274, 2, {orientation}});
            tags.push_back({277, 2, {samples}});
            if (tile == 0) tags.push_back({278, 4, {step}});
            if (tile == 0) tags.push_back({279, 4, sizes});
            tags.push_back({284, 2, {separate ? 2u : 1u}});
            if (!palette.empty()) tags.push_back({320, 2, palette});
            if (tile > 0) {
                tags.push_back({322, 2, {tile}});
                tags.push_back({323, 4, {claimed_tile > 0 ? claimed_tile : tile}});
                tags.push_back({324, 4, places});
                tags.push_back({325, 4, sizes});
            }
            if (!extra.empty()) tags.push_back({338, 2, extra});
            tags.push_back({339, 2, Values(samples, format)});
            std::string list = number(tags.size(), 2);
            std::string pool;
            const std::size_t pool_at = 8 + 2 + 12 * tags.size() + 4;
            for (const Tag& tag : tags) {
                std::string values;
                for (const std::uint32_t v : tag.values) values += number(v, tag.size);
                list += number(static_cast<std::uint64_t>(tag.number), 2);
                list += number(tag.size == 2 ? 3 : 4, 2);
                list += number(tag.values.size(), 4);
                if (values.size() <= 4) {
                    values.resize(4);
                    list += values;
                } else {
                    list += number(pool_at + pool.size(), 4);
                    pool += values;
                }
            }
            return list + number(0, 4) + pool;
        };
        std::size_t at = 8 + directory().size();
        std::string pixels;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            places[i] = static_cast<std::uint32_t>(at + pixels.size());
            pixels += parts[i];
        }
        return std::string("II*\0\x8\0\0\0", 8) + directory() + pixels;
    }
};

}  // namespace lancer::io
