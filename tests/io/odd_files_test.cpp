// Meshes and materials as many programs write them: each file is unusual in its own way, and valid.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "model/io/mesh_file.h"
#include "model/io/mtl_reader.h"

namespace lancer::io {
namespace {

struct OddMesh {
    const char* oddity;
    std::string bytes;
    std::size_t vertices, faces;
};

void expect_read(const std::vector<OddMesh>& files, const char* name) {
    EXPECT_GE(files.size(), 10u);
    for (const OddMesh& file : files) {
        try {
            const LoadedMesh loaded = read_mesh(file.bytes, name);
            EXPECT_EQ(loaded.mesh.vertices.size(), file.vertices) << file.oddity;
            EXPECT_EQ(loaded.mesh.faces.size(), file.faces) << file.oddity;
            EXPECT_EQ(loaded.degenerate, 0u) << file.oddity;
        } catch (const std::exception& error) {
            ADD_FAILURE() << file.oddity << ": " << error.what();
        }
    }
}

const std::string one_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(OddFiles, TenObj) {
    expect_read(
        {{"a byte order mark", "\xEF\xBB\xBF" + one_triangle + "f 1 2 3\n", 3, 1},
         {"tabs, blanks in front, CR LF",
          "\tv  0\t0 0 \r\n  v 1 0 0\r\nv 0 1 0\t\r\n f\t1 2 3 \r\n", 3, 1},
         {"a weight behind each place", "v 0 0 0 1.0\nv 1 0 0 1.0\nv 0 1 0 1.0\nf 1 2 3\n", 3, 1},
         {"texture places of three numbers, of one",
          one_triangle + "vt 0 0 0\nvt 1\nvt 1 1 0\nf 1/1 2/2 3/3\n", 3, 1},
         {"a pentagon with a comment behind it",
          "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv -1 1 0\nf 1 2 3 4 5 # five\n", 5, 3},
         {"a statement over three lines", one_triangle + "f 1 \\\n2 \\\r\n3\n", 3, 1},
         {"numbers as people type them", "v .0 0. +0\nv 1e0 -0 0\nv 0 1E+0 0e5\nf 1 2 3\n", 3, 1},
         {"groups without names, smoothing off, objects with blanks",
          "o my object 1\ng\n" + one_triangle + "s off\ng a b c\nf 1 2 3\ns 1\n", 3, 1},
         {"negative indices with normals", one_triangle + "vn 0 0 1\nf -3//-1 -2//-1 -1//-1\n", 3,
          1},
         {"no new line at the end, and blank lines", "\n\n" + one_triangle + "\n#end\nf 1 2 3", 3,
          1},
         {"points, lines, curves between faces",
          one_triangle +
              "p 1\nl 1 2 3\nf 1 2 3\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 1\nend\nf 3 2 1\n",
          3, 2}},
        "odd.obj");
}

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

TEST(OddFiles, TenPly) {
    const std::string places = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string list = "property list uchar int vertex_indices\n";
    const std::string ascii = "ply\nformat ascii 1.0\n";
    expect_read(
        {{"comments and words everywhere in the head",
          ascii +
              "comment\ncomment made by 3 people\nobj_info num_cols 512\nelement vertex 3\ncomment "
              "between\n" +
              xyz + "element face 1\n" + list + "end_header\n" + places + "3 0 1 2\n",
          3, 1},
         {"CR LF",
          "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float "
          "y\r\nproperty float z\r\n"
          "element face 1\r\nproperty list uchar int vertex_index\r\nend_header\r\n0 0 0\r\n1 0 "
          "0\r\n0 1 0\r\n3 0 1 2\r\n",
          3, 1},
         {"a camera before, edges behind",
          ascii + "element camera 1\nproperty float view_px\nelement vertex 3\n" + xyz +
              "element face 1\n" + list +
              "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n7\n" +
              places + "3 0 1 2\n0 1\n1 2\n",
          3, 1},
         {"faces before vertices",
          ascii + "element face 1\n" + list + "element vertex 3\n" + xyz + "end_header\n3 0 1 2\n" +
              places,
          3, 1},
         {"confidence and intensity beside each place",
          ascii + "element vertex 3\n" + xyz +
              "property float confidence\nproperty float intensity\nelement face 1\n" + list +
              "end_header\n0 0 0 1 0.5\n1 0 0 1 0.5\n0 1 0 1 0.5\n3 0 1 2\n",
          3, 1},
         {"a list beside each place",
          ascii + "element vertex 3\n" + xyz +
              "property list uchar int neighbours\nelement face 1\n" + list +
              "end_header\n0 0 0 2 1 2\n1 0 0 0\n0 1 0 1 0\n3 0 1 2\n",
          3, 1},
         {"a pentagon and a triangle",
          ascii + "element vertex 5\n" + xyz + "element face 2\n" + list +
              "end_header\n0 0 0\n2 0 0\n3 1 0\n1 2 0\n-1 1 0\n5 0 1 2 3 4\n3 0 2 4\n",
          5, 4},
         {"names of types with their bits, indices of 16",
          ascii +
              "element vertex 3\nproperty float64 x\nproperty float32 y\nproperty int16 z\nelement "
              "face 1\n"
              "property list uint32 uint16 vertex_indices\nend_header\n" +
              places + "3 0 1 2\n",
          3, 1},
         {"binary, its texture places in the faces",
          "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + xyz + "element face 1\n" +
              list + "property list uchar float texcoord\nend_header\n" +
              little(0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, std::uint8_t{3}, 0, 1, 2,
                     std::uint8_t{6}, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f),
          3, 1},
         {"numbers over several lines",
          ascii + "element vertex 3\n" + xyz + "element face 1\n" + list +
              "end_header\n0 0\n0 1 0 0\n0 1 0 3\n0 1 2\n",
          3, 1}},
        "odd.ply");
}

std::string facet(const std::string& a, const std::string& b, const std::string& c,
                  const std::string& end = "\n") {
    return "facet normal 0 0 0" + end + "outer loop" + end + "vertex " + a + end + "vertex " + b +
           end + "vertex " + c + end + "endloop" + end + "endfacet" + end;
}

std::string binary_stl(std::string head, std::uint32_t count, std::uint16_t color) {
    head.resize(80, '\0');
    std::string bytes = head + little(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto z = static_cast<float>(i);
        bytes += little(9.f, 9.f, 9.f, 0.f, 0.f, z, 1.f, 0.f, z, 0.f, 1.f, z, color);
    }
    return bytes;
}

TEST(OddFiles, TenStl) {
    const std::string one = facet("0 0 0", "1 0 0", "0 1 0");
    expect_read(
        {{"a solid with a name of several words",
          "solid part 7 of Bob's box\n" + one + "endsolid part 7\n", 3, 1},
         {"no name at all", "solid\n" + one + "endsolid\n", 3, 1},
         {"capital letters",
          "SOLID X\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\n"
          "ENDLOOP\nENDFACET\nENDSOLID X\n",
          3, 1},
         {"a facet in one line", "solid a\n" + facet("0 0 0", "1 0 0", "0 1 0", " ") + "endsolid a",
          3, 1},
         {"exponents of three digits",
          "solid a\n" + facet("0.0e+000 0 0", "1.0E+000 0 0", "0 +1.0e-000 0") + "endsolid\n", 3,
          1},
         {"CR LF and tabs",
          "solid a\r\n\t" + facet("0\t0\t0", "1 0 0", "0 1 0", "\r\n\t") + "endsolid a\r\n", 3, 1},
         {"two solids with a blank line between",
          "solid a\n" + one + "endsolid a\n\nsolid b\n" + facet("0 0 1", "1 0 1", "0 1 1") +
              "endsolid b\n",
          6, 2},
         {"binary with a colour in each facet", binary_stl("COLOR=\x7f\x7f\x7f\xff", 2, 0x83E0), 6,
          2},
         {"binary that begins as a text does",
          binary_stl("solid made by a program that says so", 1, 0), 3, 1},
         {"binary with a head of blanks", binary_stl(std::string(80, ' '), 3, 0xFFFF), 9, 3}},
        "odd.stl");
}

TEST(OddFiles, TenMtl) {
    struct OddMtl {
        const char* oddity;
        std::string text;
        std::function<bool(const MtlFile&)> is_right;
    };
    const auto first = [](const MtlFile& f) { return f.materials.at(0); };
    const OddMtl files[] = {
        {"a byte order mark", "\xEF\xBB\xBFnewmtl a\nKd 1 0 0\n",
         [&](const MtlFile& f) { return first(f).name == "a"; }},
        {"CR LF and tabs", "newmtl\ta\r\n\tKd\t1 0 0\r\n",
         [&](const MtlFile& f) { return first(f).diffuse == Color(1, 0, 0); }},
        {"one number for a grey", "newmtl a\nKd 0.5\n",
         [&](const MtlFile& f) { return first(f).diffuse == Color(0.5); }},
        {"a name with blanks", "newmtl dark oak 3\nKd 0 0 0\n",
         [&](const MtlFile& f) { return first(f).name == "dark oak 3"; }},
        {"a file name with blanks, and backslashes", "newmtl a\nmap_Kd C:\\my files\\a b.png\n",
         [&](const MtlFile& f) { return first(f).image.ends_with("my files/a b.png"); }},
        {"two materials without a blank line", "newmtl a\nKd 1 1 1\nnewmtl b\nKd 0 0 0\n",
         [](const MtlFile& f) { return f.materials.size() == 2; }},
        {"comments behind values", "# by hand\nnewmtl a # first\nNs 10.0 # shiny\n",
         [&](const MtlFile& f) { return first(f).shininess == 10.0; }},
        {"both ways to say how clear", "newmtl a\nd 0.25\nTr 0.75\n",
         [&](const MtlFile& f) { return first(f).opacity == 0.25; }},
        {"what physically based programs add",
         "newmtl a\nPr 0.5\nPm 1\nmap_Pr r.png\nnorm n.png\nKd 1 1 1\n",
         [&](const MtlFile& f) { return f.skipped.size() == 4 && first(f).diffuse == Color(1); }},
        {"no new line at the end", "newmtl a\nKd 0 1 0",
         [&](const MtlFile& f) { return first(f).diffuse == Color(0, 1, 0); }},
    };
    for (const OddMtl& file : files) {
        try {
            EXPECT_TRUE(file.is_right(read_mtl(file.text, "odd.mtl"))) << file.oddity;
        } catch (const std::exception& error) {
            ADD_FAILURE() << file.oddity << ": " << error.what();
        }
    }
}

}  // namespace
}  // namespace lancer::io
