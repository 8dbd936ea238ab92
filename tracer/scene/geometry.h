// The shapes of a compiled scene, as rays meet them: all that a search reads.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "model/scene.h"
#include "tracer/bvh/bvh.h"
#include "tracer/rays/frame.h"
#include "tracer/scene/composite.h"
#include "tracer/shapes/bicubic.h"
#include "tracer/shapes/box.h"
#include "tracer/shapes/composite.h"
#include "tracer/shapes/facets.h"
#include "tracer/shapes/frustum.h"
#include "tracer/shapes/lathe.h"
#include "tracer/shapes/mesh.h"
#include "tracer/shapes/patch.h"
#include "tracer/shapes/plane.h"
#include "tracer/shapes/prism.h"
#include "tracer/shapes/sphere.h"
#include "tracer/shapes/torus.h"
#include "tracer/shapes/triangle.h"
#include "tracer/textures/texture_binding.h"

namespace lancer {

/// The tracer's own closed list of shapes, derived from `Shape` by compile.
template <class Real>
using Solid = std::variant<BallSolid<Real>, BoxSolid<Real>, FrustumSolid<Real>, TorusSolid<Real>,
                           HalfSpace<Real>, TriangleSheet<Real>, MeshInstance<Real>,
                           PatchSolid<Real>, BicubicSolid<Real>, FacetSolid<Real>, LatheSolid<Real>,
                           PrismSolid<Real>, CompositeSolid<Real>>;

template <class Real>
SolidTraits traits_of(const Solid<Real>& solid) {
    return std::visit([](const auto& s) { return s.traits; }, solid);
}

/// The owner of a face of a primitive.
template <class Real>
struct FaceOwner {
    const Primitive<Real>* primitive;  ///< the primitive itself, or a leaf of a composite
    std::uint32_t face;                ///< number of the face in the owner's shape
    bool turned;                       ///< the owner's outside is the primitive's inside
    bool around;                       ///< the primitive lies in the owner
};

template <class Real>
struct Primitive {
    Solid<Real> solid;
    std::uint32_t frame = none;            ///< index into Geometry::frames; none: in world space
    std::uint32_t texture_binding = none;  ///< index into Geometry::texture_bindings
    std::uint32_t object = 0;  ///< index into Scene::objects, which is the order of declaration
    std::uint32_t material = 0;
    std::uint32_t corner_normals =
        none;                   ///< index into Geometry::corner_normals; lone smooth triangles
    bool body = false;          ///< has an inside
    bool convex = false;        ///< a straight line that has left it does not come back
    bool transmissive = false;  ///< some light may pass through its surface
    bool medium =
        false;  ///< a body whose inside matters to rays: transmissive, or with its own ior
    ///< or absorption
    bool casts_shadow = true;
    /// Light that passes is filtered alike everywhere: no texture on it, and nothing absorbs in it.
    bool filters_evenly = false;
    std::uint32_t medium_slot = none;  ///< index into Geometry::mediums

    /// The tree of a composite; null for other primitives.
    const CompositeTree<Real>* composite() const {
        const auto* solid_made = std::get_if<CompositeSolid<Real>>(&solid);
        return solid_made == nullptr ? nullptr : solid_made->tree;
    }
    FaceOwner<Real> owner_of(std::uint32_t of_whole) const {
        const CompositeTree<Real>* tree = composite();
        if (tree == nullptr) return {this, of_whole, false, true};
        const std::uint32_t number = of_whole & ~hidden_face;
        const CompositeLeaf<Real>& leaf = tree->leaves[tree->leaf_of(number)];
        return {&leaf.primitive, number - leaf.first_face, leaf.subtracted, leaf.around};
    }
};

/// The part of a World that says what rays meet and where. Searches see this part alone, so a
/// change of materials, lights or textures does not compile them anew.
template <class Real>
struct Geometry {
    std::vector<Primitive<Real>> primitives;  ///< in leaf order of `bvh`, then the unbounded ones
    std::uint32_t bounded = 0;                ///< primitives[bounded..] are not in the tree
    std::uint32_t planes = 0;  ///< primitives[planes..] are half spaces, after unbounded composites
    Bvh<Real> bvh;             ///< over primitives[0..bounded)
    std::vector<Frame<Real>> frames;
    std::vector<Bounds<Real>>
        medium_bounds;  ///< of `mediums`, in the same order; infinite if unbounded
    std::vector<std::uint32_t>
        mediums;  ///< primitives that are media: largest box first, then in order of declaration
    std::vector<std::unique_ptr<TriangleMesh<Real>>> meshes;
    splines::BorderTolerances patch_borders;  ///< where patches of different tolerances may meet
    std::vector<std::unique_ptr<PatchSurface<Real>>> patches;
    std::vector<std::unique_ptr<BicubicSurface<Real>>> bicubics;
    std::vector<std::unique_ptr<FacetSurface<Real>>> facets;  ///< patches by POV-Ray's rules
    std::vector<std::unique_ptr<splines::Revolution<Real>>> revolutions;
    std::vector<std::unique_ptr<splines::Extrusion<Real>>> extrusions;
    std::vector<std::unique_ptr<CompositeTree<Real>>> composites;
    std::vector<std::array<Vec3<Real>, 3>> corner_normals;  ///< unit, in the primitive's space
    std::vector<TextureBinding<Real>> texture_bindings;     ///< of the textured primitives

    /// World coordinates are those of the scene times 2^scale_exponent, so that their extent is
    /// near 1. Scaling a scene by a power of two therefore changes no bit of the compiled world.
    int scale_exponent = 0;
    bool has_transmission = false;  ///< some primitive is transmissive
    bool has_media = false;         ///< rays must carry lists of bodies
    bool has_smooth_media = false;  ///< some media are meshes with interpolated normals
};

}  // namespace lancer
