// Solids made of solids, as POV-Ray's own.
#pragma once

#include "reference/pov/export_scale.h"
#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// Opens the outermost block and writes all that is in it; the caller closes it.
void open_composite(Writer& writer, const Composite& composite);

/// Whether light passes any of the object's surfaces.
bool lets_light_pass(const Scene& scene, const Object& object);

/// The whole's box in the world; empty where it has none.
Bounds composite_bounds(const Scene& scene, const Composite& composite);

/// The object itself, or a leaf of the composite that it is.
const Object& part_of(const Scene& scene, std::uint32_t object, std::uint32_t part);

/// The node in which two leaves come together.
const Composite::Node& meeting_node(const Composite& composite, std::uint32_t a, std::uint32_t b);

/// Whether the whole lies where the leaf does not.
bool is_subtracted(const Composite& composite, const Composite::Leaf& leaf);

}  // namespace lancer::reference::pov
