// Writes composites as POV-Ray's own CSG.
#pragma once

#include "reference/pov/export_scale.h"
#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// Opens the outermost block and writes its content; the caller closes it.
void open_composite(Writer& writer, const Composite& composite);

/// Whether light passes any of the object's surfaces.
bool lets_light_pass(const Scene& scene, const Object& object);

/// The box of the whole in the world; empty if it has none.
Bounds composite_bounds(const Scene& scene, const Composite& composite);

/// The object itself, or a leaf if the object is a composite.
const Object& part_of(const Scene& scene, std::uint32_t object, std::uint32_t part);

/// The lowest common node of two leaves.
const Composite::Node& meeting_node(const Composite& composite, std::uint32_t a, std::uint32_t b);

/// Whether the leaf is a cutter: the whole lies outside of it.
bool is_subtracted(const Composite& composite, const Composite::Leaf& leaf);

}  // namespace lancer::reference::pov
