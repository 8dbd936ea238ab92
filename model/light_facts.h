// The properties of each kind of light apart from its numbers, in one file. Messages, counts, the
// scale of the world, bounds on light and the judge use it. docs/adding-a-light.md lists the other
// places.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "model/light.h"

namespace lancer {

struct LightFacts {
    std::string_view name;
    const Vec3d* position = nullptr;            ///< null: it comes from infinitely far away
    const std::optional<Fade>* fade = nullptr;  ///< null: it cannot fade
};

namespace light_facts {

struct FactsOf {
    LightFacts operator()(const PointLight& light) const {
        return {"point light", &light.position, &light.fade};
    }
    LightFacts operator()(const DirectionalLight&) const { return {"directional light"}; }
    LightFacts operator()(const SpotLight& light) const {
        return {"spot light", &light.position, &light.fade};
    }
};

}  // namespace light_facts

/// The result points into `kind`.
inline LightFacts facts_of(const LightKind& kind) {
    return std::visit(light_facts::FactsOf{}, kind);
}

}  // namespace lancer
