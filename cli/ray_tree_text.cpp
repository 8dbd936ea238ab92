#include "cli/ray_tree_text.h"

#include <fmt/format.h>

#include "cli/scene_words.h"
#include "model/light_facts.h"

namespace lancer::cli {
namespace {

std::string in_words(const Vec3d& v) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x, v.y, v.z);
}

bool is_black(const Color& c) {
    return c == Color(0);
}

class RayTreeText {
  public:
    RayTreeText(const RayTree& tree, const Scene& scene, const SourceMap& sources)
        : tree_(tree), scene_(scene), sources_(sources) {}

    std::string write() {
        tell(tree_.rays.front(), 0);
        if (tree_.is_cut) line(0, "The tree is too large: the rest is left out.");
        return std::move(out_);
    }

  private:
    void line(std::size_t depth, const std::string& text) {
        out_ += std::string(2 * depth, ' ') + text + "\n";
    }

    const Object& object_of(const RayTree::Owner& owner) const {
        const Object& whole = scene_.objects[owner.object];
        const auto* made = std::get_if<CompositeRef>(&whole.shape);
        if (made == nullptr || owner.leaf == none) return whole;
        return scene_.composites[made->composite].leaves[owner.leaf].object;
    }
    /// `sphere "ball" (scene.lancer:3:1)`
    std::string name_of(const RayTree::Owner& owner) const {
        const Object& object = object_of(owner);
        std::string text = describe(scene_, object);
        if (const std::string at = describe_place(object.place, sources_); !at.empty())
            text += fmt::format(" ({})", at);
        if (owner.leaf != none) text += " of a composite";
        return text;
    }
    std::string names_of(const std::vector<std::uint32_t>& objects) const {
        std::string text;
        for (const std::uint32_t object : objects)
            text += (text.empty() ? "" : ", ") + name_of({object});
        return text;
    }
    std::string light_name(std::uint32_t index) const {
        const Light& light = scene_.lights[index];
        const std::string at = describe_place(light.place, sources_);
        return std::string(facts_of(light.kind).name) + (at.empty() ? "" : " (" + at + ")");
    }

    void tell(const RayTree::Ray& ray, std::size_t depth) {
        line(depth,
             fmt::format("from {} towards {}", in_words(ray.origin), in_words(ray.direction)));
        if (!ray.inside.empty()) line(depth, "inside of " + names_of(ray.inside));
        const std::vector<std::uint32_t>* inside = &ray.inside;
        for (const RayTree::Contact& contact : ray.contacts) {
            tell(contact, ray.depth, depth);
            if (contact.inside != *inside && contact.bent == none)
                line(depth + 1, contact.inside.empty()
                                    ? "behind it: not inside of anything"
                                    : "behind it, inside of " + names_of(contact.inside));
            inside = &contact.inside;
        }
        tell_end(ray, depth);
    }

    void tell_end(const RayTree::Ray& ray, std::size_t depth) {
        switch (ray.end) {
            case RayTree::End::open:
                return;
            case RayTree::End::opaque:
                line(depth, "ends: this surface lets nothing through");
                return;
            case RayTree::End::background:
                line(depth,
                     scene_.sky
                         ? fmt::format("ends: it hits nothing more; the colour of the sky is "
                                       "added, times {}",
                                       in_words(ray.share))
                         : fmt::format(
                               "ends: it hits nothing more; the background {} is added, times {}",
                               in_words(scene_.background), in_words(ray.share)));
                return;
            case RayTree::End::depth:
            case RayTree::End::weight:
                line(depth, "ends: " + why_not(ray.end_weight, ray.end == RayTree::End::depth));
                return;
            case RayTree::End::surfaces:
                line(depth, "ends: it has passed through too many surfaces");
                return;
        }
    }
    std::string why_not(double weight, bool too_deep) const {
        if (too_deep) return fmt::format("max_depth {} is reached", scene_.settings.max_depth);
        return fmt::format("its weight {:.6g} is below min_contribution {:.6g}", weight,
                           scene_.settings.min_contribution);
    }

    void tell(const RayTree::Contact& contact, int ray_depth, std::size_t depth) {
        for (const RayTree::Hit& hit : contact.hits)
            line(depth, fmt::format("at {:.9g} (error below {:.2g}) it hits the {} of {}, face {}",
                                    hit.t, hit.t_error, hit.entering ? "outside" : "inside",
                                    name_of(hit.of), hit.face));
        if (contact.surfaces.empty())
            line(depth + 1, "the same medium on both sides: the surface is not visible");
        for (const RayTree::Surface& surface : contact.surfaces)
            tell(surface, contact.hits.size() > 1, ray_depth, depth + 1);
        if (contact.bent == none) return;
        const RayTree::Ray& next = tree_.rays[contact.bent];
        line(depth + 1,
             contact.total
                 ? fmt::format("total reflection, ratio of indices before and after {:.6g} : 1; "
                               "weight {:.6g}",
                               contact.index_ratio, next.weight)
                 : fmt::format(
                       "refracted, ratio of indices before and after {:.6g} : 1; weight {:.6g}",
                       contact.index_ratio, next.weight));
        tell(next, depth + 2);
    }

    void tell(const RayTree::Surface& surface, bool is_one_of_several, int ray_depth,
              std::size_t depth) {
        if (is_one_of_several) line(depth, "the visible surface is that of " + name_of(surface.of));
        line(depth, fmt::format("point {} (error below {:.2g}), normal {}", in_words(surface.point),
                                surface.point_error, in_words(surface.normal)));
        const Vec3d& outward = surface.geometric;
        if (surface.normal != outward && surface.normal != -outward)
            line(depth, "geometric normal, outward: " + in_words(outward));
        tell_material(surface, depth);
        line(depth, fmt::format("ambient and emitted light {}", in_words(surface.glow)));
        for (const RayTree::Light& light : surface.lights) tell(light, depth);
        line(depth, fmt::format("its own light {}, times {} in the pixel", in_words(surface.own),
                                in_words(surface.weight)));
        if (is_black(surface.reflectance)) return;
        line(depth, fmt::format("mirrors {}; weight {:.6g}", in_words(surface.reflectance),
                                surface.mirror_weight));
        if (surface.mirrored != none) {
            tell(tree_.rays[surface.mirrored], depth + 1);
        } else if (!tree_.is_cut) {
            line(depth + 1, "not followed: " + why_not(surface.mirror_weight,
                                                       ray_depth + 1 >= scene_.settings.max_depth));
        }
    }

    void tell_material(const RayTree::Surface& surface, std::size_t depth) {
        const Material& material = scene_.materials[surface.material];
        const std::string name = material_name(scene_, surface.material);
        std::string text = name.empty() ? "material" : "material " + name;
        text += ": color " + in_words(surface.color);
        if (material.texture != none && scene_.settings.textures)
            text += " of its " + texture_name(scene_.textures[material.texture]);
        if (!is_black(surface.transmittance))
            text += ", lets through " + in_words(surface.transmittance);
        line(depth, text);
    }
    std::string texture_name(const Texture& texture) const {
        if (const auto* image = std::get_if<ImageTexture>(&texture.pattern))
            return fmt::format("image \"{}\"", scene_.images[image->image].path);
        if (std::holds_alternative<VertexColors>(texture.pattern)) return "vertices";
        return std::string(pattern_kind(texture));
    }

    void tell(const RayTree::Light& light, std::size_t depth) {
        line(depth, fmt::format("{} at {:.6g}, cosine {:.6g}: {}", light_name(light.light),
                                light.distance, light.cosine, outcome(light)));
        for (const RayTree::Loss& loss : light.losses) tell(loss, depth + 1);
    }
    /// The colour that arrives, and the share of the light's colour that `fade` and `spot` left.
    std::string sent_words(const RayTree::Light& light) const {
        const Color& own = scene_.lights[light.light].color;
        const double whole = max_component(own);
        const double left = max_component(light.sent) / whole;
        if (light.sent == own || !(whole > 0)) return in_words(light.sent);
        return fmt::format("{} ({:.6g} of its color, after fade and spot)", in_words(light.sent),
                           left);
    }
    std::string outcome(const RayTree::Light& light) const {
        if (!light.asked)
            return light.cosine > 0 ? "the material scatters no light" : "it is behind the surface";
        if (is_black(light.sent)) return "it sends no light here";
        if (is_black(light.share)) return sent_words(light) + " is lost on the way";
        return fmt::format("of {}, {} arrives and adds {}", sent_words(light),
                           light.share == Color(1) ? "all" : in_words(light.share),
                           in_words(light.added));
    }
    void tell(const RayTree::Loss& loss, std::size_t depth) {
        const std::string name = name_of(loss.by);
        switch (loss.kind) {
            case RayTree::Loss::Kind::blocked:
                line(depth, "blocked by " + name);
                return;
            case RayTree::Loss::Kind::surface:
                line(depth, fmt::format("at {:.6g}, {} lets through {}", loss.t, name,
                                        in_words(loss.share)));
                return;
            case RayTree::Loss::Kind::medium:
                line(depth, fmt::format("up to {:.6g}, the inside of {} leaves {}", loss.t, name,
                                        in_words(loss.share)));
                return;
        }
    }

    const RayTree& tree_;
    const Scene& scene_;
    const SourceMap& sources_;
    std::string out_;
};

}  // namespace

std::string ray_tree_text(const RayTree& tree, const Scene& scene, const SourceMap& sources) {
    return RayTreeText(tree, scene, sources).write();
}

}  // namespace lancer::cli
