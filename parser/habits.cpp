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
    "use difference { ... } for its first body minus all others, intersection { ... } for what all "
    "its bodies have in common";
constexpr std::string_view no_directive = "statements are written without '#'";
constexpr std::string_view put_together = "use group { ... } to put shapes together";
constexpr std::string_view in_material = "use material { ... } to describe a surface";
constexpr std::string_view loops =
    "use 'for i in 0..10 { ... }' or 'for x in list { ... }' for a loop";
constexpr std::string_view templates =
    "use 'def name(a, b) { ... }' for statements with parameters";
constexpr std::string_view any_form = "use a prism or a lathe for any outline, a mesh for any form";
constexpr std::string_view sharp_shadows =
    "shadows are sharp; several point lights close together look like a soft shadow";
constexpr std::string_view no_indirect =
    "there is no indirect light: 'ambient' lights all surfaces alike";
constexpr std::string_view no_fog =
    "there is no fog: 'absorption' takes light on its way through a body";
constexpr std::string_view patterns =
    "surfaces have no bumps; use an image, a checker or a gradient as a texture";
constexpr std::string_view sharp_cameras =
    "a picture is sharp at every distance and shows one moment";
constexpr std::string_view values = "use 'let name = ...' to give a value a name";

constexpr Entry words[] = {
    // Shapes
    {"major", "a torus takes 'radius', the radius of its ring, and 'tube', the radius of its tube"},
    {"minor", "a torus takes 'radius', the radius of its ring, and 'tube', the radius of its tube"},
    {"major_radius",
     "a torus takes 'radius', the radius of its ring, and 'tube', the radius of its tube"},
    {"minor_radius",
     "a torus takes 'radius', the radius of its ring, and 'tube', the radius of its tube"},
    {"cube", "use a box, given by two corners: box { min [-1, -1, -1] max [1, 1, 1] }"},
    {"cuboid", "use a box, given by two corners: box { min [-1, -1, -1] max [1, 1, 1] }"},
    {"ball", "use a sphere: sphere { radius 1 }"},
    {"disc", "use a flat cylinder, or a prism with a round outline"},
    {"disk", "use a flat cylinder, or a prism with a round outline"},
    {"quad", "use a mesh: mesh { vertices [...] faces [[0, 1, 2, 3]] }"},
    {"polygon", "use a mesh: mesh { vertices [...] faces [[0, 1, 2, ...]] }"},
    {"polyhedron", "use a mesh: mesh { vertices [...] faces [[0, 1, 2], ...] }"},
    {"mesh2", "use a mesh: mesh { vertices [...] faces [...] }"},
    {"smooth_triangle", "use a triangle with 'normals'"},
    {"bicubic_patch", "use a patch: patch { control [...] }"},
    {"linear_extrude", "use a prism to extrude an outline: prism { outline [...] bottom 0 top 1 }"},
    {"rotate_extrude", "use a lathe to turn a curve round the y axis: lathe { profile [...] }"},
    {"sor", "use a lathe for a surface of revolution: lathe { profile [...] spline catmull_rom }"},
    {"subtract", cut},
    {"merge", "use union { ... } to make one body of several"},
    {"object", put_together},
    {"translation", "use 'translate [x, y, z]' to move an object"},
    {"rotation",
     "use rotate_x, rotate_y or rotate_z with degrees, or 'rotate [axis, angle]' for any axis"},
    {"instance", "define a template once and call it often: def leaf(at) { ... } leaf([0, 1, 0])"},
    {"module",
     "use 'def name(a, b) { ... }' for statements with parameters, and 'name(1, 2)' to call them"},
    // The scene
    {"light_source", "use light point, light directional or light spot { ... }"},
    {"sun", "use a directional light for a sun: light directional { direction [-1, -2, -1] }"},
    {"global_settings", "use render { max_depth 8 } for such settings, and 'ambient' in the file"},
    {"ambient_light", "use 'ambient [1, 1, 1]' in the file for the ambient light"},
    {"sky_sphere", "use 'background' or sky { gradient [0, 1, 0] ... } for rays that hit nothing"},
    {"location", "use 'position' for the place of the camera"},
    {"eye", "use 'position' for the place of the camera"},
    {"target", "use 'look_at' for the point that the camera looks at"},
    {"lookat", "use 'look_at' for the point that the camera looks at"},
    {"sky", "use 'up [0, 1, 0]' for the upward direction in the camera's picture"},
    {"angle", "use 'fov' for the camera's vertical angle of view, in degrees"},
    {"resolution", "use image { width 640 height 480 } for the size of the picture"},
    {"intensity", "use 'color' for the brightness of a light, too: color [2, 2, 2]"},
    {"brightness", "use 'color' for the brightness of a light, too: color [2, 2, 2]"},
    {"energy", "use 'color' for the brightness of a light, too: color [2, 2, 2]"},
    // Materials
    {"pigment", "use material { color [1, 0, 0] } for a colour"},
    {"finish", in_material},
    {"interior", "use material { ... } for 'ior' and 'absorption'"},
    {"appearance", in_material},
    {"shader", in_material},
    {"pattern", "use texture NAME { ... } for a pattern, and NAME as the 'color' of a material"},
    {"image_map",
     "use texture NAME { image \"file.png\" } for an image, and NAME as the 'color' of a material"},
    {"specular", "use 'phong' with 'shininess', or 'blinn' with 'roughness', for highlights"},
    {"specularity", "use 'phong' with 'shininess', or 'blinn' with 'roughness', for highlights"},
    {"glossiness", "use 'phong' with 'shininess', or 'blinn' with 'roughness', for highlights"},
    {"phong_size", "use 'shininess' for the exponent of 'phong'"},
    {"mirror", "use 'reflection 1' for an ideal mirror"},
    {"transparency",
     "use 'transmission' for the share of light that passes, 'filter' for the share that the "
     "colour tints"},
    {"transparent",
     "use 'transmission' for the share of light that passes, 'filter' for the share that the "
     "colour tints"},
    {"transmit",
     "use 'transmission' for the share of light that passes, 'filter' for the share that the "
     "colour tints"},
    {"opacity", "use 'transmission', which is 1 - opacity"},
    {"alpha", "use 'transmission', which is 1 - opacity"},
    {"albedo", "use 'color' for the colour of the surface"},
    {"emissive", "use 'emission' for light from the surface itself"},
    {"refraction", "use 'ior' for the index of refraction"},
    // Statements
    {"while", loops},
    {"until", loops},
    {"repeat", loops},
    {"foreach", loops},
    {"loop", loops},
    {"elif", "write 'else if'"},
    {"elsif", "write 'else if'"},
    {"elseif", "write 'else if'"},
    {"switch", "use 'if a == 1 { ... } else if a == 2 { ... }'"},
    {"function", callables},
    {"fn", callables},
    {"macro", templates},
    {"return",
     "a function is one expression, without 'return': 'func name(a, b) = ...'; a template has no "
     "value"},
    {"import", "use 'include \"file.lancer\"' to read another file"},
    {"var", values},
    {"const", values},
    {"local", values},
    {"global", values},
    {"set", values},
    {"float", values},
    {"double", values},
    {"echo", "use 'print' to write values"},
    {"printf", "use 'print' to write values"},
    // What the language does not have (docs/language.md)
    {"blob", any_form},
    {"metaball", any_form},
    {"height_field", any_form},
    {"heightfield", any_form},
    {"text", any_form},
    {"isosurface", any_form},
    {"parametric", any_form},
    {"superellipsoid", any_form},
    {"sphere_sweep", any_form},
    {"quadric", any_form},
    {"quartic", any_form},
    {"julia_fractal", any_form},
    {"area_light", sharp_shadows},
    {"soft_shadow", sharp_shadows},
    {"soft_shadows", sharp_shadows},
    {"radiosity", no_indirect},
    {"photons", no_indirect},
    {"caustics", no_indirect},
    {"global_illumination", no_indirect},
    {"fog", no_fog},
    {"mist", no_fog},
    {"media", no_fog},
    {"atmosphere", no_fog},
    {"bump", patterns},
    {"bumps", patterns},
    {"bump_map", patterns},
    {"normal_map", patterns},
    {"displacement", patterns},
    {"noise", patterns},
    {"turbulence", patterns},
    {"bozo", patterns},
    {"granite", patterns},
    {"marble", patterns},
    {"wood", patterns},
    {"agate", patterns},
    {"clouds", patterns},
    {"wrinkles", patterns},
    {"brick", patterns},
    {"hexagon", patterns},
    {"aperture", sharp_cameras},
    {"focal_point", sharp_cameras},
    {"focus", sharp_cameras},
    {"blur_samples", sharp_cameras},
    {"depth_of_field", sharp_cameras},
    {"motion_blur", sharp_cameras},
    {"shutter", sharp_cameras},
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
    {"rgba",
     "a colour is written [1, 0, 0]; use 'transmission' for the share of light that passes"},
    {"rgbf",
     "a colour is written [1, 0, 0]; use 'filter' for the share of light that passes tinted"},
    {"rgbt",
     "a colour is written [1, 0, 0]; use 'transmission' for the share of light that passes"},
    {"rgbft",
     "a colour is written [1, 0, 0]; use 'filter' and 'transmission' for the shares of light that "
     "pass"},
    {"hsv", "a colour is written [1, 0, 0] or #ff0000"},
    {"vector", "a vector is written [x, y, z]"},
    {"vec2", "a vector is written [x, y]"},
    {"vec3", "a vector is written [x, y, z]"},
    {"float3", "a vector is written [x, y, z]"},
    {"random", "use rand(i) for a random number; it is the same for the same i"},
    {"rnd", "use rand(i) for a random number; it is the same for the same i"},
    {"lerp", "use mix(a, b, t) to interpolate"},
    {"ln", "use log(x) for the natural logarithm"},
    {"log10", "use log(x) / log(10) for the logarithm to base 10"},
    {"mod", "use a % b for the remainder"},
    {"norm", "use length(v) for the length of a vector"},
    {"vlength", "use length(v) for the length of a vector"},
    {"vnormalize", "use normalize(v)"},
    {"vdot", "use dot(a, b)"},
    {"vcross", "use cross(a, b)"},
    {"int", "use floor(x), ceil(x) or round(x) to get a whole number"},
    {"PI", "write 'pi'"},
    {"Pi", "write 'pi'"},
    {"TAU", "write 'tau'"},
};

constexpr Entry directives[] = {
    {"include", "write 'include \"file.lancer\"', without '#'"},
    {"declare", "use 'let name = ...' to give a value a name"},
    {"local", "use 'let name = ...' to give a value a name"},
    {"define", "use 'let name = ...' to give a value a name"},
    {"macro", templates},
    {"while", loops},
    {"for", loops},
    {"if", "use 'if a > 1 { ... } else { ... }'"},
    {"else", "use 'if a > 1 { ... } else { ... }'"},
    {"end", "use braces instead of '#end': { ... }"},
    {"version", no_directive},
    {"default", no_directive},
    {"debug", "use 'print' to write values"},
    {"warning", "use 'print' to write values"},
    {"error", "use 'assert condition, \"message\"' to report an error"},
};

/// Characters by their first bytes.
constexpr Entry characters[] = {
    {"\xE2\x80\x98", "use straight double quotes around a string: \"text\""},
    {"\xE2\x80\x99", "use straight double quotes around a string: \"text\""},
    {"\xE2\x80\x9A", "use straight double quotes around a string: \"text\""},
    {"\xE2\x80\x9C", "use straight double quotes around a string: \"text\""},
    {"\xE2\x80\x9D", "use straight double quotes around a string: \"text\""},
    {"\xE2\x80\x9E", "use straight double quotes around a string: \"text\""},
    {"\xC2\xAB", "use straight double quotes around a string: \"text\""},
    {"\xE2\x80\x93", "use '-', the minus sign on the keyboard"},
    {"\xE2\x80\x94", "use '-', the minus sign on the keyboard"},
    {"\xE2\x88\x92", "use '-', the minus sign on the keyboard"},
    {"\xC3\x97", "use '*' to multiply"},
    {"\xC2\xB7", "use '*' to multiply"},
    {"\xC2\xB0", "angles have no unit: properties take degrees, functions take radians"},
    {"\xCF\x80", "write 'pi'"},
    {"\xC2\xB2", "use x ^ 2 for a square"},
    {"\xC2\xA0", "this is a no-break space: use an ordinary space"},
    {"\xE2\x80\x8B", "this is a zero-width space, which is not visible: remove it"},
    {"\xEF\xBB\xBF", "this is a byte order mark: it is allowed only at the start of a file"},
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
    return color == nullptr
               ? ""
               : "use css(\"" + std::string(color->name) + "\") for a colour by its name";
}

bool is_unit(std::string_view word) {
    return is_one_of(lengths, word) || is_one_of(angle_units, word);
}

std::string_view about_unit(std::string_view unit) {
    return is_one_of(angle_units, unit)
               ? "angles have no unit: properties take degrees, functions take radians"
               : "numbers have no unit: choose one unit of length for the whole scene";
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
    return letter ? "a name can contain only a to z, A to Z, 0 to 9 and _" : "";
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
