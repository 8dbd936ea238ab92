#include "reference/pov/differences.h"

#include <algorithm>
#include <limits>
#include <set>

#include "model/bodies.h"
#include "model/parts.h"
#include "reference/pov/composites.h"
#include "reference/pov/materials.h"

namespace lancer::reference::pov {

namespace {

using Rule = KnownDifference::Rule;

/// The properties of an object that the rules depend on.
struct Traits {
    std::uint32_t object = 0;
    Bounds bounds;  ///< in the picture's units; empty for a plane
    const Material* material = nullptr;
    bool plane = false;
    Vec3d normal{0, 0, 0};  ///< of a plane: normal·p = offset
    double offset = 0;
    bool body = false;
    bool passes = false;   ///< light passes through it
    bool absorbs = false;  ///< a body in which light fades
    bool smooth = false;   ///< a mesh whose shading normals are not its facets'
    bool patch = false;
};

/// Whether a plane intersects or touches a box.
bool meets_plane(const Traits& plane, const Bounds& box) {
    const Vec3d middle = (box.low + box.high) / 2.0;
    const double reach = dot(absolute(plane.normal), (box.high - box.low) / 2.0);
    return std::abs(dot(plane.normal, middle) - plane.offset) <= reach * (1 + 1e-9);
}

bool meet(const Traits& a, const Traits& b) {
    if (a.plane && b.plane) return true;
    if (a.plane) return meets_plane(a, b.bounds);
    if (b.plane) return meets_plane(b, a.bounds);
    return a.bounds.overlaps(b.bounds);
}

class Search {
  public:
    Search(const Scene& scene, PowerOfTen scale) : scene_(scene), scale_(scale) {
        for (std::uint32_t i = 0; i < scene.objects.size(); ++i) add(i);
    }

    std::vector<KnownDifference> run(const std::vector<Coincidence>& coincidences) {
        find_absorption();
        find_refraction();
        find_recursion();
        find_sizes();
        add(Rule::patch_facets, "POV-Ray draws a patch as flat triangles with interpolated normals",
            all([](const Traits& t) { return t.patch; }));
        add(Rule::coincident_surfaces,
            "where surfaces coincide, POV-Ray shows any one of them; Lancer resolves them together",
            in_one_place(coincidences));
        return std::move(found_);
    }

  private:
    /// Adds an object; a composite is added with each of its materials.
    void add(std::uint32_t index) {
        const Object& object = scene_.objects[index];
        Traits t = traits_of(object);
        t.object = index;
        objects_.push_back(t);
        std::set<std::uint32_t> materials{object.material};
        for_each_part(scene_, object, [&](const Object& part) {
            if (!materials.insert(part.material).second) return;
            t.material = &scene_.materials[part.material];
            objects_.push_back(t);
        });
    }

    Traits traits_of(const Object& object) const {
        Traits t;
        t.material = &scene_.materials[object.material];
        const Affine<double>& to_world = scene_.transforms[object.transform];
        if (const auto* plane = std::get_if<Plane>(&object.shape)) {
            t.plane = true;
            const Vec3d own = normalize(plane->normal);
            // Normals are transformed by the transposed inverse.
            t.normal = normalize(map_transposed(inverse(to_world), own));
            t.offset = dot(t.normal, scale_(map_point(to_world, own * plane->offset)));
        }
        t.body = is_body(scene_, object.shape);
        t.passes = lets_light_pass(scene_, object);
        t.absorbs = t.body && t.passes && max_component(t.material->absorption) > 0;
        for_each_part(scene_, object, [&](const Object& part) {
            const auto* mesh = std::get_if<MeshRef>(&part.shape);
            t.smooth = t.smooth || (mesh != nullptr && mesh->smooth && scene_.settings.smooth);
        });
        t.patch = std::holds_alternative<PatchRef>(object.shape);
        if (const auto own = shape_bounds(scene_, object.shape)) {
            t.bounds = moved(to_world, *own);
            t.bounds.low = scale_(t.bounds.low);
            t.bounds.high = scale_(t.bounds.high);
        }
        return t;
    }

    static std::vector<std::uint32_t> in_one_place(const std::vector<Coincidence>& coincidences) {
        std::vector<std::uint32_t> objects;
        for (const Coincidence& c : coincidences) {
            objects.push_back(c.first);
            objects.push_back(c.second);
        }
        std::sort(objects.begin(), objects.end());
        objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
        return objects;
    }

    void add(Rule rule, const std::string& explanation, std::vector<std::uint32_t> objects) {
        if (!objects.empty()) found_.push_back({rule, explanation, std::move(objects)});
    }
    template <class Test>
    std::vector<std::uint32_t> all(const Test& test) const {
        std::vector<std::uint32_t> out;
        for (const Traits& t : objects_)
            if (test(t) && (out.empty() || out.back() != t.object)) out.push_back(t.object);
        return out;
    }
    /// True without a test when there are too many pairs.
    bool meets_another(const Traits& t, const auto& other) const {
        if (objects_.size() > 20000) return true;
        return std::any_of(objects_.begin(), objects_.end(), [&](const Traits& o) {
            return o.object != t.object && other(o) && meet(t, o);
        });
    }

    void find_absorption() {
        add(Rule::absorption_inside,
            "inside a body, POV-Ray applies absorption to light that passes through the far "
            "surface, but not to what that surface itself shows or mirrors",
            all([](const Traits& t) {
                const Material& m = *t.material;
                const bool clear = m.filter + m.transmission >= 1 && m.texture == none;
                return t.absorbs &&
                       !(clear && m.reflection == Color(0, 0, 0) && m.phong == 0 && m.blinn == 0);
            }));
        add(Rule::absorption_nested,
            "POV-Ray leaves out the absorption along a ray that ends on another object",
            all([this](const Traits& t) {
                return t.absorbs && meets_another(t, [](const Traits&) { return true; });
            }));
        add(Rule::absorption_smooth,
            "where a smooth mesh refracts or mirrors a ray to the wrong side of a facet, POV-Ray "
            "chooses the medium by what happened to the ray, Lancer by the side where the ray is",
            all([](const Traits& t) { return t.absorbs && t.smooth; }));
        const bool fading = std::any_of(objects_.begin(), objects_.end(),
                                        [](const Traits& t) { return t.absorbs; });
        add(Rule::light_from_behind,
            "a shadow ray to a light behind the surface starts in the viewer's medium in POV-Ray, "
            "but in the medium behind the surface in Lancer",
            all([&](const Traits& t) {
                return fading && t.body && t.passes && t.material->diffuse_transmission > 0;
            }));
    }

    static bool bends(const Traits& t) { return t.body && t.passes && t.material->ior != 1; }
    static bool is_passed_body(const Traits& t) { return t.body && t.passes; }
    /// Sheets, bodies with the index of air, and bodies that a ray may leave while it is in another
    /// one.
    bool may_pass_straight(const Traits& t) const {
        return !t.body || t.material->ior == 1 || meets_another(t, is_passed_body) ||
               scene_.settings.max_depth == 1;
    }

    void find_refraction() {
        add(Rule::fresnel_nested,
            "where a ray leaves a body that is inside of another one, POV-Ray's Fresnel term takes "
            "the inner body's index for both sides and mirrors nothing",
            all([this](const Traits& t) {
                return is_passed_body(t) && t.material->fresnel &&
                       t.material->reflection != Color(0, 0, 0) && meets_another(t, is_passed_body);
            }));
        add(Rule::sheet_in_medium,
            "POV-Ray bends light at a transparent sheet inside a body, because the sheet's ior is "
            "1",
            all([this](const Traits& t) {
                return !t.body && t.passes && meets_another(t, bends);
            }));
        add(Rule::index_single,
            "POV-Ray keeps indices of refraction, and the ratio of two, in single precision",
            all([this](const Traits& t) {
                const double ior = t.material->ior;
                return bends(t) && (static_cast<double>(static_cast<float>(ior)) != ior ||
                                    meets_another(t, [&](const Traits& o) {
                                        return bends(o) && o.material->ior != ior;
                                    }));
            }));
    }

    void find_recursion() {
        const Settings& settings = scene_.settings;
        auto branching = all(
            [](const Traits& t) { return t.passes || t.material->reflection != Color(0, 0, 0); });
        if (settings.max_depth > 256)
            add(Rule::depth_limit, "POV-Ray follows no ray deeper than 256 levels", branching);
        const bool takes_levels =
            settings.max_depth == 1 || std::any_of(objects_.begin(), objects_.end(), [](auto& t) {
                return bends(t) || t.material->reflection != Color(0, 0, 0);
            });
        if (takes_levels)
            add(Rule::depth_limit,
                "on the last level of recursion POV-Ray shows nothing through a surface, even "
                "where light is not bent",
                all([this](const Traits& t) { return t.passes && may_pass_straight(t); }));
        if (settings.min_contribution > 0)
            add(Rule::contribution,
                "POV-Ray's adc_bailout also cuts rays through a surface by the grey value of its "
                "transmission; set min_contribution 0 to compare",
                std::move(branching));
    }

    void find_sizes() {
        add(Rule::small_features,
            "POV-Ray ignores hits nearer than 1e-4 and shadows nearer than 1e-3 of its units, and "
            "this body is hardly thicker",
            all([](const Traits& t) {
                if (!t.body || t.plane || t.bounds.empty) return false;
                const Vec3d d = t.bounds.high - t.bounds.low;
                return std::min({d.x, d.y, d.z}) < 5e-3;
            }));
        add(Rule::far_away, "POV-Ray sees nothing beyond 1e7 of its units",
            all([](const Traits& t) {
                return !t.bounds.empty && max_component(max_abs(t.bounds)) > 1e7;
            }));
    }
    static Vec3d max_abs(const Bounds& b) {
        return {std::max(std::abs(b.low.x), std::abs(b.high.x)),
                std::max(std::abs(b.low.y), std::abs(b.high.y)),
                std::max(std::abs(b.low.z), std::abs(b.high.z))};
    }

    const Scene& scene_;
    PowerOfTen scale_;
    std::vector<Traits> objects_;
    std::vector<KnownDifference> found_;
};

}  // namespace

std::vector<KnownDifference> known_differences(const Scene& scene, PowerOfTen scale,
                                               const std::vector<Coincidence>& coincidences) {
    return Search(scene, scale).run(coincidences);
}

}  // namespace lancer::reference::pov
