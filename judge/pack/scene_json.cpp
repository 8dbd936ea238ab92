#include "judge/pack/scene_json.h"

#include <fmt/format.h>

#include "model/io/pfm_file.h"

namespace lancer::judge {

namespace {

Json affine_json(const Affine<double>& map) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d& row = map.rows[i];
        rows.push_back({row.x, row.y, row.z, map.shift[static_cast<int>(i)]});
    }
    return rows;
}

Json camera_json(const Camera& camera) {
    Json json{{"position", to_json(camera.position)},
              {"look_at", to_json(camera.look_at)},
              {"up", to_json(camera.up)}};
    if (const auto* perspective = std::get_if<PerspectiveProjection>(&camera.projection)) {
        json["projection"] = "perspective";
        json["fov"] = perspective->fov;
    } else {
        json["projection"] = "orthographic";
        json["height"] = std::get<OrthographicProjection>(camera.projection).height;
    }
    return json;
}

Json fade_json(const std::optional<Fade>& fade) {
    if (!fade) return nullptr;
    return {{"distance", fade->distance}, {"power", fade->power}};
}

struct LightWriter {
    Json operator()(const PointLight& l) const {
        return {{"kind", "point"}, {"position", to_json(l.position)}, {"fade", fade_json(l.fade)}};
    }
    Json operator()(const DirectionalLight& l) const {
        return {{"kind", "directional"}, {"direction", to_json(l.direction)}};
    }
    Json operator()(const SpotLight& l) const {
        return {{"kind", "spot"},
                {"position", to_json(l.position)},
                {"look_at", to_json(l.look_at)},
                {"radius", l.radius},
                {"falloff", l.falloff},
                {"tightness", l.tightness},
                {"fade", fade_json(l.fade)}};
    }
};

Json material_json(const Material& m) {
    return {{"color", to_json(m.color)},
            {"texture", m.texture == none ? Json(nullptr) : Json(m.texture)},
            {"ambient", m.ambient},
            {"diffuse", m.diffuse},
            {"emission", to_json(m.emission)},
            {"phong", m.phong},
            {"shininess", m.shininess},
            {"blinn", m.blinn},
            {"roughness", m.roughness},
            {"metallic", m.metallic},
            {"reflection", to_json(m.reflection)},
            {"fresnel", m.fresnel},
            {"transmission", m.transmission},
            {"filter", m.filter},
            {"ior", m.ior},
            {"absorption", to_json(m.absorption)},
            {"diffuse_transmission", m.diffuse_transmission},
            {"phong_transmission", m.phong_transmission}};
}

const char* name_of(ImageTexture::Mapping mapping) {
    switch (mapping) {
        case ImageTexture::Mapping::planar:
            return "planar";
        case ImageTexture::Mapping::spherical:
            return "spherical";
        case ImageTexture::Mapping::cylindrical:
            return "cylindrical";
        case ImageTexture::Mapping::uv:
            return "uv";
    }
    return "";
}

Json gradient_json(const Gradient& g) {
    Json stops = Json::array();
    for (const Gradient::Stop& stop : g.stops)
        stops.push_back({{"at", stop.at}, {"color", to_json(stop.color)}});
    return {{"kind", "gradient"}, {"axis", to_json(g.axis)}, {"stops", stops}};
}

struct PatternWriter {
    Json operator()(const ImageTexture& t) const {
        return {{"kind", "image"},
                {"image", t.image},
                {"mapping", name_of(t.mapping)},
                {"filter", t.filter == ImageTexture::Filter::nearest ? "nearest" : "bilinear"},
                {"wrap", t.wrap == ImageTexture::Wrap::repeat ? "repeat" : "once"}};
    }
    Json operator()(const Checker& c) const {
        return {{"kind", "checker"}, {"even", to_json(c.even)}, {"odd", to_json(c.odd)}};
    }
    Json operator()(const Gradient& g) const { return gradient_json(g); }
    Json operator()(const VertexColors&) const { return {{"kind", "vertex"}}; }
};

Json image_json(const SceneImage& image, std::size_t index, PackSink& sink) {
    const Image& pixels = *image.pixels;
    const std::string name = fmt::format("image-{}.pfm", index);
    sink.files.push_back({name, io::encode_pfm(pixels, 0, 3)});
    Json json{{"file", name}, {"alpha", nullptr}};
    if (pixels.channels >= 4) {
        const std::string alpha = fmt::format("image-{}-alpha.pfm", index);
        sink.files.push_back({alpha, io::encode_pfm(pixels, 3, 1)});
        json["alpha"] = alpha;
    }
    return json;
}

}  // namespace

Json object_json(const Scene& scene, const Object& object, PackSink& sink) {
    Json json = shape_json(scene, object, sink);
    json["material"] = object.material;
    json["transform"] = object.transform;
    json["casts_shadow"] = object.casts_shadow;
    if (object.name != none) json["name"] = scene.names[object.name];
    const std::string place = sink.place_text ? sink.place_text(object.place) : std::string();
    if (!place.empty()) json["place"] = place;
    return json;
}

Json scene_json(const Scene& scene, std::size_t camera, PackSink& sink) {
    Json json;
    json["camera"] = camera_json(scene.cameras[camera]);
    json["max_depth"] = scene.settings.max_depth;
    json["shadows"] = scene.settings.shadows;
    json["background"] = to_json(scene.background);
    json["sky"] = scene.sky ? gradient_json(*scene.sky) : Json(nullptr);
    json["ambient"] = to_json(scene.ambient);
    for (const char* list : {"lights", "transforms", "images", "textures", "materials", "objects"})
        json[list] = Json::array();
    for (const Light& light : scene.lights) {
        Json made = std::visit(LightWriter{}, light.kind);
        made["color"] = to_json(light.color);
        made["shadows"] = light.shadows;
        json["lights"].push_back(std::move(made));
    }
    for (const Affine<double>& map : scene.transforms)
        json["transforms"].push_back(affine_json(map));
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        json["images"].push_back(image_json(scene.images[i], i, sink));
    for (const Texture& texture : scene.textures) {
        Json made = std::visit(PatternWriter{}, texture.pattern);
        made["to_object"] = affine_json(texture.to_object);
        json["textures"].push_back(std::move(made));
    }
    for (const Material& material : scene.materials)
        json["materials"].push_back(material_json(material));
    for (const Object& object : scene.objects)
        json["objects"].push_back(object_json(scene, object, sink));
    return json;
}

}  // namespace lancer::judge
