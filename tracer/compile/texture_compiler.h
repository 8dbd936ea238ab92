// Compiles the scene's textures. Only the files that instantiate it include it.
#pragma once

#include <variant>

#include "model/affine.h"
#include "tracer/scene/world.h"

namespace lancer {

template <class Real>
struct PatternMaker {
    const Scene& scene;
    const Affine<double>& to_object;

    Pattern<Real> operator()(const Checker& c) const {
        return CheckerPattern<Real>{convert<Real>(c.even), convert<Real>(c.odd)};
    }
    Pattern<Real> operator()(const Gradient& g) const {
        GradientPattern<Real> pattern;
        const Vec3<Wide<Real>> axis = convert<Wide<Real>>(g.axis / max_component(absolute(g.axis)));
        pattern.axis = convert<Real>(normalize(axis));
        for (const Gradient::Stop& stop : g.stops)
            pattern.stops.push_back({static_cast<Real>(stop.at), convert<Real>(stop.color)});
        return pattern;
    }
    Pattern<Real> operator()(const VertexColors&) const { return VertexPattern{}; }
    Pattern<Real> operator()(const ImageTexture& t) const {
        return ImagePattern<Real>{scene.images[t.image].pixels.get(), t.mapping, t.filter, t.wrap,
                                  convert<Real>(inverse(convert<Wide<Real>>(to_object)))};
    }
};

/// Adds all textures of the scene to world.textures, and keeps their images alive.
template <class Real>
void compile_textures(const Scene& scene, World<Real>& world) {
    for (const Texture& texture : scene.textures)
        world.textures.push_back(
            std::visit(PatternMaker<Real>{scene, texture.to_object}, texture.pattern));
    for (const SceneImage& image : scene.images) world.images.push_back(image.pixels);
}

}  // namespace lancer
