#include "model/scene.h"
#include "parser/blocks/blocks.h"
#include "parser/blocks/stops.h"

namespace lancer {
namespace rules {

template <>
struct Words<ImageTexture::Mapping> {
    static constexpr std::string_view takes = "one of planar, spherical, cylindrical, uv";
    static constexpr std::array<std::string_view, 4> words{"planar", "spherical", "cylindrical",
                                                           "uv"};
    static constexpr std::array values{
        ImageTexture::Mapping::planar, ImageTexture::Mapping::spherical,
        ImageTexture::Mapping::cylindrical, ImageTexture::Mapping::uv};
};
template <>
struct Words<ImageTexture::Filter> {
    static constexpr std::string_view takes = "nearest or bilinear";
    static constexpr std::array<std::string_view, 2> words{"nearest", "bilinear"};
    static constexpr std::array values{ImageTexture::Filter::nearest,
                                       ImageTexture::Filter::bilinear};
};
template <>
struct Words<ImageTexture::Wrap> {
    static constexpr std::string_view takes = "repeat or once";
    static constexpr std::array<std::string_view, 2> words{"repeat", "once"};
    static constexpr std::array values{ImageTexture::Wrap::repeat, ImageTexture::Wrap::once};
};
template <>
struct Words<io::ColorSpace> {
    static constexpr std::string_view takes = "srgb or linear";
    static constexpr std::array<std::string_view, 2> words{"srgb", "linear"};
    static constexpr std::array values{io::ColorSpace::automatic, io::ColorSpace::linear};
};

struct TwoColors {
    static constexpr std::string_view takes = "a list of two colours without negative parts";
    static bool read(const Value& value, Checker& out, std::string& instead) {
        return value.is_list() && value.size() == 2 &&
               ColorRule::read(value.at(0), out.even, instead) &&
               ColorRule::read(value.at(1), out.odd, instead);
    }
};

}  // namespace rules

namespace blocks {
namespace {

struct TextureSpec {
    std::string image;
    ImageTexture::Mapping mapping = ImageTexture{}.mapping;
    ImageTexture::Filter filter = ImageTexture{}.filter;
    ImageTexture::Wrap wrap = ImageTexture{}.wrap;
    io::ColorSpace color_space = io::ColorSpace::automatic;
    Checker checker;
    Vec3d gradient{0, 1, 0};
    std::vector<Gradient::Stop> stops;
    TransformList transforms;
};

constexpr Field texture_fields[] = {
    field<&TextureSpec::image, rules::String>("image", "none", "file of an image"),
    field<&TextureSpec::mapping, rules::WordRule<ImageTexture::Mapping>>(
        "mapping", "planar", "how the image is mapped: planar, spherical, cylindrical, uv"),
    field<&TextureSpec::filter, rules::WordRule<ImageTexture::Filter>>(
        "filter", "bilinear", "interpolation of texels: nearest or bilinear"),
    field<&TextureSpec::wrap, rules::WordRule<ImageTexture::Wrap>>(
        "wrap", "repeat", "repeat, or once: transparent outside"),
    field<&TextureSpec::color_space, rules::WordRule<io::ColorSpace>>(
        "color_space", "srgb", "linear: use the image's values as they are"),
    field<&TextureSpec::checker, rules::TwoColors>("checker", "none",
                                                   "two colours that alternate between unit cubes"),
    field<&TextureSpec::gradient, rules::Direction>("gradient", "none",
                                                    "the axis along which the stops repeat"),
    field<&TextureSpec::stops, rules::Stops>("stops", "none", "positions from 0 to 1 with colours"),
    repeated_field<&TextureSpec::transforms, transform_rules::Translate>("translate",
                                                                         "moves it by a vector"),
    repeated_field<&TextureSpec::transforms, transform_rules::Scale>("scale",
                                                                     "scales it about the origin"),
    repeated_field<&TextureSpec::transforms, transform_rules::RotateX>("rotate_x",
                                                                       "turns it about the x axis"),
    repeated_field<&TextureSpec::transforms, transform_rules::RotateY>("rotate_y",
                                                                       "turns it about the y axis"),
    repeated_field<&TextureSpec::transforms, transform_rules::RotateZ>("rotate_z",
                                                                       "turns it about the z axis"),
    repeated_field<&TextureSpec::transforms, transform_rules::Rotate>(
        "rotate", "turns it about an axis through the origin"),
    repeated_field<&TextureSpec::transforms, transform_rules::Matrix>("matrix",
                                                                      "three rows of four numbers"),
};

/// Reports options that belong to another pattern than the one given.
void refuse(BlockReader& block, std::initializer_list<std::string_view> options,
            std::string_view pattern) {
    if (block.has(pattern)) return;
    for (const std::string_view option : options)
        if (block.has(option))
            block.error(Message::texture_option, block.place(option), option, pattern);
}

/// Sets `index` to the index of the image in the scene. An image is loaded once however often it is
/// named.
bool find_image(BlockReader& block, const TextureSpec& spec, std::uint32_t& index) {
    const std::string path = block.resolve_path(spec.image);
    const bool srgb = spec.color_space == io::ColorSpace::automatic;
    auto& images = block.builder().scene.images;
    auto& indices = block.builder().image_indices;
    const auto known = indices.find({path, srgb});
    if (known != indices.end()) {
        index = known->second;
        return true;
    }
    const auto pixels = block.context().files.image(path, spec.color_space, block.place("image"));
    if (pixels == nullptr) return false;
    index = static_cast<std::uint32_t>(images.size());
    indices[{path, srgb}] = index;
    images.push_back({path, srgb, pixels});
    return true;
}

}  // namespace

const BlockInfo texture{"texture", "", texture_fields, {}, "a pattern of colours"};

void make_texture(BlockReader& block, std::uint32_t& result) {
    TextureSpec spec;
    block.read(&spec);
    const int patterns = block.has("image") + block.has("checker") + block.has("gradient");
    refuse(block, {"mapping", "filter", "wrap", "color_space"}, "image");
    refuse(block, {"stops"}, "gradient");
    if (patterns != 1 && block.good()) block.error(Message::texture_patterns, block.place());
    if (block.has("gradient") && !block.has("stops") && block.good())
        block.error(Message::stops_missing, block.place("gradient"));
    check_order(block, spec.stops);
    if (!block.good()) return;
    Texture made;
    if (spec.transforms.given && (is_singular(spec.transforms.map) ||
                                  !round_transform(spec.transforms.map, made.to_object))) {
        block.error(Message::transform_singular, block.place());
        return;
    }
    Report& report = block.report();
    for (const Gradient::Stop& stop : spec.stops)
        warn_bright_surface(report, block.place("stops"), stop.color);
    warn_bright_surface(report, block.place("checker"), spec.checker.even);
    warn_bright_surface(report, block.place("checker"), spec.checker.odd);
    if (block.has("image")) {
        ImageTexture pattern{0, spec.mapping, spec.filter, spec.wrap};
        if (!find_image(block, spec, pattern.image)) return;
        made.pattern = pattern;
    } else if (block.has("checker")) {
        made.pattern = spec.checker;
    } else {
        made.pattern = Gradient{spec.gradient, spec.stops};
    }
    result = block.builder().add(made, block.place());
}

}  // namespace blocks
}  // namespace lancer
