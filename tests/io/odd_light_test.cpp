// Files of light (EXR, Radiance) byte by byte, of kinds that our own writer does not write.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "tests/io/odd_pictures.h"

namespace lancer::io {
namespace {

template <class... Values>
std::string little(Values... values) {
    std::string bytes;
    const auto put = [&](auto value) {
        char raw[sizeof(value)];
        std::memcpy(raw, &value, sizeof(value));
        bytes.append(raw, sizeof(value));
    };
    (put(values), ...);
    return bytes;
}

std::string name(const std::string& text) {
    return text + std::string(1, '\0');
}
std::string attribute(const std::string& called, const std::string& type, const std::string& data) {
    return name(called) + name(type) + little(static_cast<std::int32_t>(data.size())) + data;
}

/// EXR without compression. Channels stand in the order of their names.
struct ExrFile {
    struct Channel {
        std::string called;
        std::int32_t type;   // 0 whole numbers, 1 half, 2 float
        std::string sample;  // the same everywhere
    };
    std::vector<Channel> channels{
        {"B", 2, little(0.25F)}, {"G", 2, little(-1.5F)}, {"R", 2, little(1e5F)}};
    int left = 0, top = 0, right = 10, bottom = 4;  ///< the last are within
    std::string display = little(0, 0, 10, 4);
    int tile = 0;  ///< width and height of tiles; 0: lines
    bool from_below = false;
    bool long_names = false;
    float aspect = 1;
    std::string more;  ///< attributes

    std::string bytes() const {
        std::string list;
        for (const Channel& c : channels)
            list += name(c.called) + little(c.type, std::uint32_t{0}, 1, 1);
        std::string head = little(20000630, 2 | (tile > 0 ? 0x200 : 0) | (long_names ? 0x400 : 0)) +
                           attribute("channels", "chlist", name(list)) +
                           attribute("compression", "compression", std::string(1, '\0')) +
                           attribute("dataWindow", "box2i", little(left, top, right, bottom)) +
                           attribute("displayWindow", "box2i", display) +
                           attribute("lineOrder", "lineOrder", {static_cast<char>(from_below)}) +
                           attribute("pixelAspectRatio", "float", little(aspect)) +
                           attribute("screenWindowCenter", "v2f", little(0.F, 0.F)) +
                           attribute("screenWindowWidth", "float", little(1.F)) + more;
        if (tile > 0)
            head += attribute("tiles", "tiledesc", little(tile, tile) + std::string(1, '\0'));
        head = name(head);
        const std::vector<std::string> parts = tile > 0 ? tiles() : lines();
        std::vector<std::uint64_t> places(parts.size());
        std::string data;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t part = from_below ? parts.size() - 1 - i : i;
            places[part] = head.size() + 8 * parts.size() + data.size();
            data += parts[part];
        }
        for (const std::uint64_t place : places) head += little(place);
        return head + data;
    }

  private:
    std::string pixels(int width) const {
        std::string row;
        for (const Channel& c : channels)
            for (int x = 0; x < width; ++x) row += c.sample;
        return row;
    }
    std::vector<std::string> lines() const {
        std::vector<std::string> parts;
        const std::string row = pixels(right - left + 1);
        for (int y = top; y <= bottom; ++y)
            parts.push_back(little(y, static_cast<std::int32_t>(row.size())) + row);
        return parts;
    }
    std::vector<std::string> tiles() const {
        std::vector<std::string> parts;
        for (int y = top; y <= bottom; y += tile) {
            for (int x = left; x <= right; x += tile) {
                std::string block;
                for (int row = y; row < std::min(y + tile, bottom + 1); ++row)
                    block += pixels(std::min(tile, right + 1 - x));
                parts.push_back(little((x - left) / tile, (y - top) / tile, 0, 0,
                                       static_cast<std::int32_t>(block.size())) +
                                block);
            }
        }
        return parts;
    }
};

TEST(OddFiles, TenExr) {
    const std::string half = little(std::uint16_t{0x3800});  // 0.5
    const std::vector<double> light{1e5, -1.5, 0.25};
    const auto changed = [](const std::function<void(ExrFile&)>& change) {
        ExrFile file;
        change(file);
        return file.bytes();
    };
    expect_read(
        {{"lines without compression", ExrFile{}.bytes(), 11, 5, light},
         {"halves",
          changed([&](auto& f) {
              f.channels = {{"B", 1, half}, {"G", 1, half}, {"R", 1, half}};
          }),
          11,
          5,
          {0.5, 0.5, 0.5}},
         {"a type for each channel",
          changed([&](auto& f) {
              f.channels[1] = {"G", 1, half};
          }),
          11,
          5,
          {1e5, 0.5, 0.25}},
         {"a window that begins below zero",
          changed([](auto& f) { f.left = -3, f.top = -7, f.right = 0, f.bottom = -6; }), 4, 2,
          light},
         {"a window that is larger than what is shown",
          changed([](auto& f) { f.left = -5, f.top = -5; }), 16, 10, light},
         {"lines from below", changed([](auto& f) { f.from_below = true; }), 11, 5, light},
         {"tiles that do not divide it", changed([](auto& f) { f.tile = 4; }), 11, 5, light},
         {"a tile that is larger than it", changed([](auto& f) { f.tile = 64; }), 11, 5, light},
         {"grey",
          changed([&](auto& f) {
              f.channels = {{"Y", 1, half}};
          }),
          11,
          5,
          {0.5}},
         {"grey and alpha, which is multiplied in",
          changed([&](auto& f) {
              f.channels = {{"A", 1, half}, {"Y", 2, little(0.25F)}};
          }),
          11,
          5,
          {0.5, 0.5, 0.5, 0.5}},
         {"layers beside the colour", changed([&](auto& f) {
              f.channels.push_back({"beauty.R", 1, half});
              f.channels.push_back({"id", 0, little(7)});
          }),
          11, 5, light},
         {"names of more than 31 letters", changed([](auto& f) {
              f.long_names = true;
              f.more = attribute(std::string(40, 'n'), "string", "value");
          }),
          11, 5, light},
         {"attributes of types that nobody knows, and pixels that are not square",
          changed([](auto& f) {
              f.aspect = 2;
              f.more = attribute("color", "paint", "red") + attribute("empty", "nothing", "");
          }),
          11, 5, light}});
}

TEST(OddFiles, TenRadiance) {
    const std::string pixel("\x80\x40\x20\x82", 4);  // 128, 64, 32 times 2^(130 - 136)
    const std::vector<double> light{2, 1, 0.5};
    const auto flat = [&](int count) {
        std::string all;
        for (int i = 0; i < count; ++i) all += pixel;
        return all;
    };
    const std::string magic = "#?RADIANCE\n";
    const std::string format = "FORMAT=32-bit_rle_rgbe\n";
    // Each component of a line by itself: a run of 12, which begins with 128 and its length.
    std::string runs("\x02\x02\x00\x0C", 4);
    for (const char value : pixel) runs += std::string("\x8C", 1) + value;
    std::string literal("\x02\x02\x00\x0C", 4);
    for (const char value : pixel) literal += "\x0C" + std::string(12, value);
    const auto file = [&](const std::string& head, const std::string& size,
                          const std::string& pixels) { return head + "\n" + size + "\n" + pixels; };
    expect_read(
        {{"pixels one after the other", file(magic + format, "-Y 2 +X 4", flat(8)), 4, 2, light},
         {"runs", file(magic + format, "-Y 2 +X 12", runs + runs), 12, 2, light},
         {"runs that repeat nothing", file(magic + format, "-Y 2 +X 12", literal + literal), 12, 2,
          light},
         {"flat in lines that are long enough for runs",
          file(magic + format, "-Y 2 +X 12", flat(24)), 12, 2, light},
         {"the other first line", file("#?RGBE\n" + format, "-Y 1 +X 4", flat(4)), 4, 1, light},
         {"comments and settings",
          file(magic + "# made by hand\nSOFTWARE=pencil\nVIEW= -vtv -vp 0 0 1\n" + format +
                   "PRIMARIES=0.64 0.33 0.29 0.6 0.15 0.06 0.333 0.333\n",
               "-Y 1 +X 4", flat(4)),
          4, 1, light},
         {"the format behind the settings",
          file(magic + "CAPDATE= 2000:02:29 00:00:00\nGAMMA=1\n" + format, "-Y 1 +X 4", flat(4)), 4,
          1, light},
         {"one pixel", file(magic + format, "-Y 1 +X 1", flat(1)), 1, 1, light},
         {"columns first", file(magic + format, "+X 3 -Y 2", flat(6)), 3, 2, light},
         {"black, whose exponent is zero",
          file(magic + format, "-Y 1 +X 2", std::string("\x80\x40\x20\0\0\0\0\0", 8)),
          2,
          1,
          {0, 0, 0}},
         {"a large exponent",
          file(magic + format, "-Y 1 +X 1", "\x80\x40\x20\xE8"),
          1,
          1,
          {std::ldexp(1, 103), std::ldexp(1, 102), std::ldexp(1, 101)}}});
}

TEST(Hdr, OfRunsOfWholePixelsIsAnError) {
    const ScratchFolder folder;
    put(folder / "a.hdr",
        std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 12\n\x80\x40\x20\x82") +
            "\1\1\1\x0B");
    EXPECT_THROW(read_image(folder / "a.hdr"), FileError);
}

}  // namespace
}  // namespace lancer::io
