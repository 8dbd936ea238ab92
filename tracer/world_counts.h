// How much a compiled world holds: for statistics.
#pragma once

#include "tracer/render.h"
#include "tracer/scene/world.h"

namespace lancer {

template <class Real>
WorldCounts counts_of(const World<Real>& world) {
    WorldCounts c;
    c.shapes = world.primitives.size();
    c.lights = world.lights.size();
    c.nodes = world.bvh.nodes.size();
    for (const auto& mesh : world.meshes) {
        c.triangles += mesh->source->faces.size();
        c.nodes += mesh->bvh.nodes.size();
    }
    // Of the patches, what rays asked for.
    for (const auto& patch : world.patches) {
        if (const auto* mesh = patch->built()) {
            c.triangles += mesh->source->faces.size();
            c.nodes += mesh->bvh.nodes.size();
        }
    }
    for (const auto& patch : world.bicubics) {
        if (const auto* tree = patch->built()) c.nodes += tree->bvh.nodes.size();
    }
    return c;
}

}  // namespace lancer
