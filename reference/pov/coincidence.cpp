#include "reference/pov/coincidence.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "model/bodies.h"
#include "reference/pov/composites.h"
#include "reference/pov/materials.h"

namespace lancer::reference::pov {

namespace {

using Resolution = Coincidence::Resolution;

bool is_equal(const Material& a, const Material& b) {
    const auto parts = [](const Material& m) {
        return std::tie(m.color, m.texture, m.ambient, m.diffuse, m.emission, m.phong, m.shininess,
                        m.blinn, m.roughness, m.metallic, m.reflection, m.fresnel, m.transmission,
                        m.filter, m.ior, m.absorption, m.diffuse_transmission,
                        m.phong_transmission);
    };
    return parts(a) == parts(b);
}

/// The properties of an object for the contact rule: docs/shading.md, "Contact".
struct Kind {
    bool body = false;
    bool clear = false;  ///< lets light pass
};

class Resolver {
  public:
    explicit Resolver(const Scene& scene) : scene_(scene) {
        for (const Object& object : scene.objects)
            kinds_.push_back({is_body(scene, object.shape), lets_light_pass(scene, object)});
    }

    FacePair pair_of(Face a, Face b) const {
        if (b.object < a.object || (a.object == b.object && b.part < a.part)) std::swap(a, b);
        const Kind& first = kinds_[a.object];
        const Kind& second = kinds_[b.object];
        FacePair pair{a, b, look_alike(a, b), Resolution::none};
        if (a.object == b.object) return within(pair);
        pair.front.turned = is_cutter(a);
        pair.back.turned = is_cutter(b);
        if (!pair.front.turned && !pair.back.turned) {
            decide(pair, first, second);
            return pair;
        }
        // Where a cutter ends in a face of its own body, there is nothing. Otherwise its face is
        // the wall of a hole, in which another body may stand.
        pair.alike = !pair.alike;
        const bool wall = a.shows && b.shows && pair.front.turned != pair.back.turned &&
                          first.body && second.body;
        if (wall) decide(pair, first, second);
        if (pair.resolution == Resolution::none) pair.resolution = Resolution::hidden;
        return pair;
    }

    /// Whether the face is a cutter's and lies in a face of the body that is cut.
    bool ends_in_its_body(const Face& face, const std::vector<Face>& faces) const {
        return is_cutter(face) && std::any_of(faces.begin(), faces.end(), [&](const Face& other) {
                   return other.object == face.object && !is_cutter(other) &&
                          coincide(face, other) && look_alike(face, other);
               });
    }

  private:
    void decide(FacePair& pair, const Kind& first, const Kind& second) const {
        const std::uint32_t a = pair.front.object;
        const std::uint32_t b = pair.back.object;
        if (!first.body || !second.body) {
            with_sheet(pair, first, second);
        } else if (pair.alike) {
            // The body that the ray meets first is the one that shows, or that it enters first.
            if (first.clear && second.clear) return;
            if (second.clear || !first.clear)
                pair.resolution = Resolution::in_front;
            else
                in_front(pair, pair.back, pair.front);
        } else if (!first.clear && !second.clear) {
            pair.resolution = Resolution::hidden;
        } else if (first.clear != second.clear) {
            pair.resolution = Resolution::sunk;
            if (!first.clear) std::swap(pair.front, pair.back);
        } else if (!is_same_matter(a, b)) {
            pair.resolution = Resolution::overlapped;
        } else if (can_be_merged(a, b)) {
            pair.resolution = Resolution::merged;
        }
    }

    bool is_cutter(const Face& face) const {
        if (face.part == none) return false;
        const Composite& whole = composite_of(face.object);
        return is_subtracted(whole, whole.leaves[face.part]);
    }
    const Composite& composite_of(std::uint32_t object) const {
        return scene_.composites[std::get<CompositeRef>(scene_.objects[object].shape).composite];
    }

    /// Two parts of one composite. A cutter that ends in a face must reach out of it, glued parts
    /// overlap, and of two faces that point the same way, the first declared shows.
    FacePair within(FacePair pair) const {
        const bool cuts = is_cutter(pair.front);
        if (cuts != is_cutter(pair.back)) {
            if (!pair.alike) return pair;
            if (!cuts) std::swap(pair.front, pair.back);
            pair.resolution = Resolution::in_front;
            return pair;
        }
        const Composite& whole = composite_of(pair.front.object);
        const Composite::Kind kind = meeting_node(whole, pair.front.part, pair.back.part).kind;
        if (!pair.alike) {
            if (kind != Composite::Kind::intersect) pair.resolution = Resolution::overlapped;
            return pair;
        }
        if (kind == Composite::Kind::intersect) std::swap(pair.front, pair.back);
        pair.resolution = Resolution::in_front;
        return pair;
    }

    static void in_front(FacePair& pair, const Face& front, const Face& back) {
        pair = FacePair{front, back, true, Resolution::in_front};
    }

    /// A sheet is visible from both sides. So only a body can hide it, or be hidden by it from
    /// outside.
    static void with_sheet(FacePair& pair, const Kind& first, const Kind& second) {
        if (!first.body && !second.body) return;
        const bool sheet_is_first = !first.body;
        const Kind& sheet = sheet_is_first ? first : second;
        const Kind& body = sheet_is_first ? second : first;
        const Face of_sheet = sheet_is_first ? pair.front : pair.back;
        const Face of_body = sheet_is_first ? pair.back : pair.front;
        if (sheet.clear && body.clear) return;
        if (sheet.clear)
            in_front(pair, of_body, of_sheet);
        else if (body.clear)
            pair = FacePair{of_body, of_sheet, false, Resolution::sunk};
        else if (sheet_is_first)
            in_front(pair, of_sheet, of_body);
        else
            in_front(pair, of_body, of_sheet);
    }

    bool is_same_matter(std::uint32_t a, std::uint32_t b) const {
        const Material& matter = scene_.materials[scene_.objects[a].material];
        return is_equal(matter, scene_.materials[scene_.objects[b].material]) &&
               texture_of(scene_, matter) == nullptr;
    }

    bool can_be_merged(std::uint32_t a, std::uint32_t b) const {
        const auto is_composite = [&](std::uint32_t i) {
            return std::holds_alternative<CompositeRef>(scene_.objects[i].shape);
        };
        return scene_.objects[a].casts_shadow == scene_.objects[b].casts_shadow &&
               !is_composite(a) && !is_composite(b);
    }

    const Scene& scene_;
    std::vector<Kind> kinds_;
};

}  // namespace

std::vector<FacePair> face_pairs(const Scene& scene) {
    constexpr std::size_t most = 4000;
    std::vector<Face> faces = faces_of(scene, most);
    const Resolver resolver(scene);
    for (Face& face : faces) face.shows = !resolver.ends_in_its_body(face, faces);
    std::vector<FacePair> pairs;
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j)
            if ((faces[i].object != faces[j].object || faces[i].part != faces[j].part) &&
                coincide(faces[i], faces[j]))
                pairs.push_back(resolver.pair_of(faces[i], faces[j]));
    return pairs;
}

std::vector<Coincidence> coincidences(const std::vector<FacePair>& pairs) {
    std::vector<Coincidence> found;
    for (const FacePair& pair : pairs) {
        const auto [first, second] = std::minmax(pair.front.object, pair.back.object);
        const auto same = [&, first = first, second = second](const Coincidence& c) {
            return c.first == first && c.second == second && c.resolution == pair.resolution;
        };
        if (std::none_of(found.begin(), found.end(), same))
            found.push_back({first, second, pair.resolution});
    }
    std::sort(found.begin(), found.end(), [](const Coincidence& a, const Coincidence& b) {
        return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    return found;
}

}  // namespace lancer::reference::pov
