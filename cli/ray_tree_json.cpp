#include "cli/ray_tree_json.h"

#include "cli/scene_words.h"
#include "model/light_facts.h"

namespace lancer::cli {
namespace {

using Json = nlohmann::ordered_json;

Json index_json(std::uint32_t index) {
    return index == none ? Json() : Json(index);
}

class RayTreeJson {
  public:
    RayTreeJson(const Scene& scene, const SourceMap& sources) : scene_(scene), sources_(sources) {}

    Json of(const RayTree::Ray& ray) const {
        static constexpr const char* kinds[] = {"camera", "mirrored", "refracted",
                                                "total reflection"};
        static constexpr const char* ends[] = {"bent",      "background",       "opaque",
                                               "max_depth", "min_contribution", "surfaces"};
        Json json;
        json["kind"] = kinds[static_cast<std::size_t>(ray.kind)];
        json["origin"] = vector_json(ray.origin);
        json["direction"] = vector_json(ray.direction);
        json["inside"] = of(ray.inside);
        json["weight"] = ray.weight;
        json["depth"] = ray.depth;
        json["contacts"] = list_of(ray.contacts);
        json["end"] = ends[static_cast<std::size_t>(ray.end)];
        if (ray.end == RayTree::End::background) json["background_share"] = vector_json(ray.share);
        if (ray.end == RayTree::End::depth || ray.end == RayTree::End::weight)
            json["end_weight"] = ray.end_weight;
        return json;
    }

  private:
    template <class Things>
    Json list_of(const Things& things) const {
        Json list = Json::array();
        for (const auto& thing : things) list.push_back(of(thing));
        return list;
    }

    Json named(const Object& object) const {
        return {{"name", describe(scene_, object)},
                {"place", describe_place(object.place, sources_)}};
    }
    Json of(const std::vector<std::uint32_t>& objects) const {
        Json list = Json::array();
        for (const std::uint32_t object : objects) list.push_back(of(RayTree::Owner{object}));
        return list;
    }
    Json of(const RayTree::Owner& owner) const {
        const Object& object = scene_.objects[owner.object];
        Json json = named(object);
        json["object"] = owner.object;
        if (owner.leaf != none) {
            const auto& made = std::get<CompositeRef>(object.shape);
            json["leaf"] = named(scene_.composites[made.composite].leaves[owner.leaf].object);
        }
        return json;
    }
    Json of(const RayTree::Hit& hit) const {
        return {{"of", of(hit.of)},
                {"face", hit.face},
                {"t", hit.t},
                {"t_error", hit.t_error},
                {"entering", hit.entering}};
    }
    Json of(const RayTree::Contact& contact) const {
        return {{"t", contact.t},
                {"hits", list_of(contact.hits)},
                {"inside_behind", of(contact.inside)},
                {"share", vector_json(contact.share)},
                {"index_ratio", contact.index_ratio},
                {"total_reflection", contact.total},
                {"surfaces", list_of(contact.surfaces)},
                {"bent", index_json(contact.bent)}};
    }
    Json of(const RayTree::Surface& s) const {
        const Material& material = scene_.materials[s.material];
        Json texture;
        if (material.texture != none && scene_.settings.textures) {
            const Texture& used = scene_.textures[material.texture];
            texture = {{"kind", pattern_kind(used)}};
            if (const auto* image = std::get_if<ImageTexture>(&used.pattern))
                texture["file"] = scene_.images[image->image].path;
        }
        return {{"of", of(s.of)},
                {"face", s.face},
                {"material", material_name(scene_, s.material)},
                {"texture", texture},
                {"point", vector_json(s.point)},
                {"point_error", s.point_error},
                {"normal", vector_json(s.normal)},
                {"geometric_normal", vector_json(s.geometric)},
                {"color", vector_json(s.color)},
                {"transmittance", vector_json(s.transmittance)},
                {"glow", vector_json(s.glow)},
                {"lights", list_of(s.lights)},
                {"own_light", vector_json(s.own)},
                {"weight", vector_json(s.weight)},
                {"reflectance", vector_json(s.reflectance)},
                {"mirror_weight", s.mirror_weight},
                {"mirrored", index_json(s.mirrored)}};
    }
    Json of(const RayTree::Light& light) const {
        const Light& source = scene_.lights[light.light];
        return {{"light", light.light},
                {"name", facts_of(source.kind).name},
                {"place", describe_place(source.place, sources_)},
                {"direction", vector_json(light.direction)},
                {"distance", light.distance},  // null: infinite
                {"cosine", light.cosine},
                {"answered", light.asked},
                {"sent", vector_json(light.sent)},
                {"share", vector_json(light.share)},
                {"losses", list_of(light.losses)},
                {"added", vector_json(light.added)}};
    }
    Json of(const RayTree::Loss& loss) const {
        static constexpr const char* kinds[] = {"blocked", "surface", "medium"};
        Json json{{"kind", kinds[static_cast<std::size_t>(loss.kind)]}, {"by", of(loss.by)}};
        if (loss.kind != RayTree::Loss::Kind::blocked) json["t"] = loss.t;
        json["share"] = vector_json(loss.share);
        return json;
    }

    const Scene& scene_;
    const SourceMap& sources_;
};

}  // namespace

nlohmann::ordered_json vector_json(const Vec3d& v) {
    return {v.x, v.y, v.z};
}

nlohmann::ordered_json ray_tree_json(const RayTree& tree, const Scene& scene,
                                     const SourceMap& sources) {
    const RayTreeJson json(scene, sources);
    Json rays = Json::array();
    for (const RayTree::Ray& ray : tree.rays) rays.push_back(json.of(ray));
    return rays;
}

}  // namespace lancer::cli
