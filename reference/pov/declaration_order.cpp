#include "reference/pov/declaration_order.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "model/bodies.h"
#include "reference/pov/composites.h"
#include "reference/pov/export_scale.h"
#include "reference/pov/materials.h"

namespace lancer::reference::pov {

std::vector<std::uint32_t> declaration_order(const Scene& scene, const ExportView& view) {
    struct Holder {
        std::uint32_t object;
        double size;
    };
    std::vector<std::uint32_t> order(scene.objects.size());
    std::iota(order.begin(), order.end(), 0u);
    Bounds eye;
    eye.add(scene.cameras[view.camera].position);
    std::vector<Holder> holders;
    for (const std::uint32_t i : order) {
        const Object& object = scene.objects[i];
        if (!lets_light_pass(scene, object) || !is_body(scene, object.shape)) continue;
        const auto own = shape_bounds(scene, object.shape);
        if (!own) {
            holders.push_back({i, std::numeric_limits<double>::infinity()});
            continue;
        }
        const Bounds world = moved(scene.transforms[object.transform], *own);
        if (world.overlaps(eye)) holders.push_back({i, world.diagonal()});
    }
    std::vector<std::uint32_t> places;
    places.reserve(holders.size());
    for (const Holder& holder : holders) places.push_back(holder.object);
    std::stable_sort(holders.begin(), holders.end(),
                     [](const Holder& a, const Holder& b) { return a.size > b.size; });
    for (std::size_t i = 0; i < holders.size(); ++i) order[places[i]] = holders[i].object;
    return order;
}

}  // namespace lancer::reference::pov
