#include "parser/habits.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "parser/css_colors.h"
#include "parser/scan.h"

namespace lancer::habits {
namespace {

using Entry = std::pair<std::string_view, std::string_view>;

constexpr std::string_view cut =
    "difference { ... } is the first body in it without all others, intersection { ... } what all "
    "hold";
constexpr std::string_view no_directive = "statements are written without '#'";
constexpr std::string_view put_together = "shapes are put together by group { ... }";
constexpr std::string_view in_material = "what a surface looks like stands in material { ... }";
constexpr std::string_view loops =
    "what is repeated stands in 'for i in 0..10 { ... }' or 'for x in list { ... }'";
constexpr std::string_view templates = "statements with parameters are 'def name(a, b) { ... }'";
constexpr std::string_view values = "a value gets its name by 'let name = ...'";

constexpr Entry words[] = {
    // Shapes
    {"major", "a torus has a 'radius', of its ring, and a 'tube'"},
    {"minor", "a torus has a 'radius', of its ring, and a 'tube'"},
    {"major_radius", "a torus has a 'radius', of its ring, and a 'tube'"},
    {"minor_radius", "a torus has a 'radius', of its ring, and a 'tube'"},
    {"cube", "a box has two corners: box { min [-1, -1, -1] max [1, 1, 1] }"},
    {"cuboid", "a box has two corners: box { min [-1, -1, -1] max [1, 1, 1] }"},
    {"ball", "a ball is a sphere { radius 1 }"},
    {"disc", "a disc is a flat cylinder, or a prism with a round outline"},
    {"disk", "a disc is a flat cylinder, or a prism with a round outline"},
    {"quad", "a quad is a mesh { vertices [...] faces [[0, 1, 2, 3]] }"},
    {"polygon", "a polygon is a mesh { vertices [...] faces [[0, 1, 2, ...]] }"},
    {"polyhedron", "a polyhedron is a mesh { vertices [...] faces [[0, 1, 2], ...] }"},
    {"mesh2", "a mesh is written mesh { vertices [...] faces [...] }"},
    {"smooth_triangle", "a triangle takes 'normals'"},
    {"bicubic_patch", "a bicubic patch is a patch { control [...] }"},
    {"linear_extrude", "an outline drawn up is a prism { outline [...] bottom 0 top 1 }"},
    {"rotate_extrude", "an outline that is turned is a lathe { profile [...] }"},
    {"sor", "a surface of revolution is a lathe { profile [...] spline catmull_rom }"},
    {"subtract", cut},
    {"merge", "several bodies are made one by union { ... }"},
    {"object", put_together},
    {"translation", "'translate [x, y, z]' moves"},
    {"rotation", "rotate_x, rotate_y, rotate_z take degrees; 'rotate [axis, angle]' any axis"},
    {"instance", "a template is made once and called often: def leaf(at) { ... } leaf([0, 1, 0])"},
    {"module", "statements with parameters are 'def name(a, b) { ... }', called 'name(1, 2)'"},
    // The scene
    {"light_source", "lights are light point, light directional and light spot { ... }"},
    {"area_light", "lights are light point, light directional and light spot { ... }"},
    {"sun", "a sun is light directional { direction [-1, -2, -1] }"},
    {"global_settings", "such settings stand in render { max_depth 8 }, and 'ambient' in the file"},
    {"ambient_light", "the ambient light is the file's property 'ambient [1, 1, 1]'"},
    {"sky_sphere",
     "what stands behind everything is 'background', or sky { gradient [0, 1, 0] ... }"},
    {"location", "a camera stands at its 'position'"},
    {"eye", "a camera stands at its 'position'"},
    {"target", "a camera looks at its 'look_at'"},
    {"lookat", "a camera looks at its 'look_at'"},
    {"sky", "what is up in a camera's picture is 'up [0, 1, 0]'"},
    {"angle", "a camera's angle is 'fov', vertical and in degrees"},
    {"resolution", "the size of the picture is image { width 640 height 480 }"},
    {"intensity", "a light's brightness is in its colour: color [2, 2, 2]"},
    {"brightness", "a light's brightness is in its colour: color [2, 2, 2]"},
    {"energy", "a light's brightness is in its colour: color [2, 2, 2]"},
    // Materials
    {"pigment", "a colour stands in material { color [1, 0, 0] }"},
    {"finish", in_material},
    {"interior", "ior and absorption stand in material { ... }"},
    {"appearance", in_material},
    {"shader", in_material},
    {"pattern", "a pattern is a texture NAME { ... }, which a material takes as its color"},
    {"image_map",
     "an image is a texture NAME { image \"file.png\" }, which a material takes as color"},
    {"specular", "highlights are 'phong' with 'shininess', or 'blinn' with 'roughness'"},
    {"specularity", "highlights are 'phong' with 'shininess', or 'blinn' with 'roughness'"},
    {"glossiness", "highlights are 'phong' with 'shininess', or 'blinn' with 'roughness'"},
    {"phong_size", "the exponent of phong is 'shininess'"},
    {"mirror", "an ideal mirror is 'reflection 1'"},
    {"transparency", "what passes is 'transmission', or 'filter' for what the colour tints"},
    {"transparent", "what passes is 'transmission', or 'filter' for what the colour tints"},
    {"transmit", "what passes is 'transmission', or 'filter' for what the colour tints"},
    {"opacity", "opacity is 1 - transmission"},
    {"alpha", "opacity is 1 - transmission"},
    {"albedo", "the surface's colour is 'color'"},
    {"emissive", "a surface's own light is 'emission'"},
    {"refraction", "the index of refraction is 'ior'"},
    // Statements
    {"while", loops},
    {"until", loops},
    {"repeat", loops},
    {"foreach", loops},
    {"loop", loops},
    {"elif", "write 'else if'"},
    {"elsif", "write 'else if'"},
    {"elseif", "write 'else if'"},
    {"switch", "choices are 'if a == 1 { ... } else if a == 2 { ... }'"},
    {"function", callables},
    {"fn", callables},
    {"macro", templates},
    {"return", "a function is one expression: 'func name(a, b) = ...'; a template has no value"},
    {"import", "another file is read by 'include \"file.lancer\"'"},
    {"var", values},
    {"const", values},
    {"local", values},
    {"global", values},
    {"set", values},
    {"float", values},
    {"double", values},
    {"echo", "'print' writes values"},
    {"printf", "'print' writes values"},
    // Operators and values
    {"and", "write '&&'"},
    {"or", "write '||'"},
    {"not", "write '!'"},
    {"True", "write 'true'"},
    {"False", "write 'false'"},
    {"yes", "write 'true'"},
    {"no", "write 'false'"},
    {"on", "write 'true'"},
    {"off", "write 'false'"},
    // Functions
    {"rgb", "a colour is written [1, 0, 0]; srgb(r, g, b) takes sRGB from 0 to 1"},
    {"rgba", "a colour is written [1, 0, 0]; what passes is 'transmission'"},
    {"rgbf", "a colour is written [1, 0, 0]; what passes tinted is 'filter'"},
    {"rgbt", "a colour is written [1, 0, 0]; what passes is 'transmission'"},
    {"rgbft", "a colour is written [1, 0, 0]; what passes is 'filter' and 'transmission'"},
    {"hsv", "a colour is written [1, 0, 0] or #ff0000"},
    {"vector", "a vector is written [x, y, z]"},
    {"vec2", "a vector is written [x, y]"},
    {"vec3", "a vector is written [x, y, z]"},
    {"float3", "a vector is written [x, y, z]"},
    {"random", "a random number is rand(i), the same for the same i"},
    {"rnd", "a random number is rand(i), the same for the same i"},
    {"lerp", "a mixture is mix(a, b, t)"},
    {"ln", "the natural logarithm is log(x)"},
    {"log10", "a logarithm to 10 is log(x) / log(10)"},
    {"mod", "the remainder is a % b"},
    {"norm", "the length of a vector is length(v)"},
    {"vlength", "the length of a vector is length(v)"},
    {"vnormalize", "normalize(v)"},
    {"vdot", "dot(a, b)"},
    {"vcross", "cross(a, b)"},
    {"int", "floor(x), ceil(x) and round(x) give whole numbers"},
    {"PI", "write 'pi'"},
    {"Pi", "write 'pi'"},
    {"TAU", "write 'tau'"},
};

constexpr Entry directives[] = {
    {"include", "write 'include \"file.lancer\"', without '#'"},
    {"declare", "a value gets its name by 'let name = ...'"},
    {"local", "a value gets its name by 'let name = ...'"},
    {"define", "a value gets its name by 'let name = ...'"},
    {"macro", templates},
    {"while", loops},
    {"for", loops},
    {"if", "choices are 'if a > 1 { ... } else { ... }'"},
    {"else", "choices are 'if a > 1 { ... } else { ... }'"},
    {"end", "what an '#end' closes stands in braces: { ... }"},
    {"version", no_directive},
    {"default", no_directive},
    {"debug", "'print' writes values"},
    {"warning", "'print' writes values"},
    {"error", "'assert condition, \"message\"' makes an error"},
};

/// Characters by how they begin.
constexpr Entry characters[] = {
    {"\xE2\x80\x98", "a string stands between straight double quotes: \"text\""},
    {"\xE2\x80\x99", "a string stands between straight double quotes: \"text\""},
    {"\xE2\x80\x9A", "a string stands between straight double quotes: \"text\""},
    {"\xE2\x80\x9C", "a string stands between straight double quotes: \"text\""},
    {"\xE2\x80\x9D", "a string stands between straight double quotes: \"text\""},
    {"\xE2\x80\x9E", "a string stands between straight double quotes: \"text\""},
    {"\xC2\xAB", "a string stands between straight double quotes: \"text\""},
    {"\xE2\x80\x93", "the minus sign of the language is '-', the one on the keyboard"},
    {"\xE2\x80\x94", "the minus sign of the language is '-', the one on the keyboard"},
    {"\xE2\x88\x92", "the minus sign of the language is '-', the one on the keyboard"},
    {"\xC3\x97", "multiplication is written '*'"},
    {"\xC2\xB7", "multiplication is written '*'"},
    {"\xC2\xB0", "angles have no unit: properties take degrees, functions take radians"},
    {"\xCF\x80", "write 'pi'"},
    {"\xC2\xB2", "a square is written x ^ 2"},
    {"\xC2\xA0", "this is a no-break space: white space is blanks, tabs and ends of lines"},
    {"\xE2\x80\x8B", "this is a zero-width space: white space is blanks, tabs and ends of lines"},
    {"\xEF\xBB\xBF", "this is a byte order mark: it may stand at the start of a file only"},
};

std::string_view find(std::span<const Entry> entries, std::string_view word) {
    for (const auto& [known, hint] : entries)
        if (word == known) return hint;
    return {};
}

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& all, std::string_view word) {
    return std::find(all.begin(), all.end(), word) != all.end();
}

std::string lower(std::string_view word) {
    std::string result(word);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

constexpr std::array<std::string_view, 4> angle_units{"deg", "degrees", "rad", "radians"};
constexpr std::array<std::string_view, 14> lengths{"mm", "cm", "dm",   "m",  "km", "um", "nm",
                                                   "in", "ft", "inch", "px", "em", "pt", "s"};

}  // namespace

std::string_view instead_of(std::string_view word) {
    return find(words, word);
}

bool begins_foreign_statement(std::string_view word) {
    static constexpr std::array<std::string_view, 14> all{
        "while",  "until",  "repeat",   "foreach", "loop",  "elif",   "elsif",
        "elseif", "switch", "function", "fn",      "macro", "module", "return"};
    return is_one_of(all, word);
}

bool declares(std::string_view word) {
    static constexpr std::array<std::string_view, 8> all{"var", "const", "local", "global",
                                                         "set", "int",   "float", "double"};
    return is_one_of(all, word);
}

bool announces_color(std::string_view word) {
    static constexpr std::array<std::string_view, 6> all{"rgb",  "rgba",  "rgbf",
                                                         "rgbt", "rgbft", "srgb"};
    return is_one_of(all, word);
}

std::string color_called(std::string_view name) {
    const CssColor* color = css_color(lower(name));
    return color == nullptr ? ""
                            : "a colour has its name in css(\"" + std::string(color->name) + "\")";
}

bool is_unit(std::string_view word) {
    return is_one_of(lengths, word) || is_one_of(angle_units, word);
}

std::string_view about_unit(std::string_view unit) {
    return is_one_of(angle_units, unit)
               ? "angles have no unit: properties take degrees, functions take radians"
               : "numbers have no unit: the scene's lengths are in whatever unit you think of";
}

std::string_view instead_of_directive(std::string_view word) {
    return find(directives, word);
}

std::string_view about_character(std::string_view text) {
    for (const auto& [known, hint] : characters)
        if (text.starts_with(known)) return hint;
    const bool letter =
        !text.empty() && (text[0] == '\xC3' || text[0] == '\xC4' || text[0] == '\xC5' ||
                          text[0] == '\xCE' || text[0] == '\xCF' || text[0] == '\xD0');
    return letter ? "a name is made of a to z, A to Z, 0 to 9 and _" : "";
}

std::string vector_hint(std::string_view inside, std::string_view what,
                        std::string_view otherwise) {
    constexpr std::size_t longest = 40;
    const auto commas = std::count(inside.begin(), inside.end(), ',');
    const bool plain = inside.size() <= longest && (commas == 1 || commas == 2) &&
                       inside.find_first_of("<>{}()[]\"\r\n") == std::string_view::npos;
    while (!inside.empty() && scan::is_blank(inside.front())) inside.remove_prefix(1);
    while (!inside.empty() && scan::is_blank(inside.back())) inside.remove_suffix(1);
    return std::string(what) + " is written [" + std::string(plain ? inside : otherwise) + "]";
}

}  // namespace lancer::habits
