// An OBJ file read by chunks is the same mesh, or the same mistake, as one read as a whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "model/io/obj_reader.h"
#include "tests/io/read_in_chunks.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

/// Lines of every kind, most of them right. Indices are seldom out of range.
std::string random_lines(std::mt19937& random) {
    const auto pick = [&](int count) {
        return static_cast<int>(random() % static_cast<unsigned>(count));
    };
    std::string text = pick(9) == 0 ? "\xEF\xBB\xBF" : "";
    const bool has_mistakes = pick(3) == 0;
    const char* const line_end = pick(5) == 0 ? "\r\n" : "\n";
    int vertices = 0;
    int normals = 0;
    int uvs = 0;
    const int lines = 5 + pick(60);
    const auto number = [&] { return std::to_string(pick(2000) / 64.0 - 10); };
    const auto corner = [&](int count) {
        const int at = 1 + pick(count);
        return std::to_string(pick(2) == 0 ? at : at - count - 1);
    };
    for (int i = 0; i < lines; ++i) {
        switch (pick(has_mistakes ? 17 : 15)) {
            case 0:
                text += "vn 0 " + number() + " 1";
                ++normals;
                break;
            case 1:
                text += " vt\t" + number() + (pick(2) == 0 ? "" : " 1");
                ++uvs;
                break;
            case 2:
                text += "usemtl " + std::string(pick(4) == 0 ? "" : pick(2) == 0 ? "a" : "b c");
                break;
            case 3:
                text += pick(2) == 0 ? "mtllib a.mtl" : "g part # one";
                break;
            case 4:
                text += pick(2) == 0 ? "# v 1 2 3" : "";
                break;
            case 5:
                if (pick(4) == 0) {
                    text += "v 1 2 3 0.5 0.25 " + number();
                    ++vertices;
                }
                break;
            case 6:
                if (pick(9) == 0) {
                    text += pick(2) == 0 ? "v nan 1 2" : "v 1 2 \\\n 3";
                    ++vertices;
                }
                break;
            case 15:
                text += pick(3) == 0 ? "f -1 -2 -99" : "";
                break;
            case 16:
                text += pick(3) == 0 ? "f 1 2" : pick(2) == 0 ? "v 1 x 2" : "what";
                break;
            default:
                if (vertices > 2 && pick(2) == 0) {
                    text += "f";
                    for (int k = 3 + pick(2); k > 0; --k) {
                        text += " " + corner(vertices);
                        const int form = pick(4);
                        if (form == 1 && uvs > 0) text += "/" + corner(uvs);
                        if (form == 2) text += "//" + (normals > 0 ? corner(normals) : "-1");
                    }
                } else {
                    text += "v " + number() + " " + number() + " " + number();
                    ++vertices;
                }
        }
        text += pick(40) == 0 ? "\r" : line_end;
    }
    return text;
}

TEST(ObjChunks, AreReadAsTheWholeIs) {
    std::mt19937 random(7);
    int meshes = 0;
    int mistakes = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const std::string text = random_lines(random);
        const int threads = std::array{1, 2, 3, 8}[random() % 4];
        const std::string whole = told(text, {});
        const std::string parts =
            told(text, {.threads = threads, .chunk_bytes = 1 + random() % 200});
        ASSERT_EQ(whole, parts) << text;
        ++(whole.starts_with("t.obj") ? mistakes : meshes);
    }
    EXPECT_GT(meshes, 150);
    EXPECT_GT(mistakes, 150);
}

TEST(ObjChunks, AreCutWhereLinesEnd) {
    const std::string text = "v 0 0 0\nv 1 0 0\r\nv 0 1 0\nf 1 2 3\nf 1 -2 3\n";
    const auto chunks_of = [](const std::string& file) {
        return read_obj(file, "t.obj", {.threads = 1, .chunk_bytes = 1}).size();
    };
    EXPECT_EQ(chunks_of(text), 5u);
    EXPECT_EQ(chunks_of(text + "f 1 2 \\\n 3\n"), 1u) << "a statement on two lines";
    EXPECT_EQ(chunks_of(text + "f 1 2 \\\r\n 3\n"), 1u);
    EXPECT_EQ(chunks_of(text + "v 0 0 0\rv 1 1 1\n"), 1u) << "a line that ends without LF";
    EXPECT_EQ(read_obj(text, "t.obj", {.threads = 8}).size(), 1u) << "short";
}

TEST(ObjChunks, LongFilesAreReadByThem) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    while (text.size() < 3'000'000) text += "v 0.25 0.5 0.75\nf 1 -2 3\nf -1 2 3\n";
    EXPECT_EQ(read_obj(text, "t.obj", {}).size(), 1u) << "one thread";
    EXPECT_EQ(read_obj(text, "t.obj", {.threads = 2}).size(), 3u);
    EXPECT_EQ(told(text, {}), told(text, {.threads = 2}));
    EXPECT_EQ(told(text, {}), told(text, {.threads = 3}));
    const auto lines = std::count(text.begin(), text.end(), '\n');
    EXPECT_THAT(told(text + "f 1 2\n", {.threads = 2}),
                testing::StartsWith(fmt::format("t.obj:{}: a face needs", lines + 1)));
}

TEST(ObjChunks, TheFirstMistakeIsReported) {
    const std::string text = "v 0 0 0\n\n\nv 1 x 0\nv 0 1 0\nf 1 2 9\nwhat\n";
    for (const int threads : {1, 2, 3, 8})
        EXPECT_THAT(told(text, {.threads = threads, .chunk_bytes = 1}),
                    testing::StartsWith("t.obj:4: a coordinate expected"));
}

}  // namespace
}  // namespace lancer::io
