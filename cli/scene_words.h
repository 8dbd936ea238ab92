// Descriptions of a scene's parts for messages.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "model/scene.h"
#include "model/source.h"

namespace lancer::cli {

/// `sphere "ball"`
std::string describe(const Scene& scene, const Object& object);

/// Empty when the script gives the material no name.
std::string material_name(const Scene& scene, std::uint32_t material);

/// `checker`, `gradient`, `image` or `vertex`, as in JSON.
std::string_view pattern_kind(const Texture& texture);

/// `file:line:column`; empty for a place that is not in a script.
std::string describe_place(const SourceSpan& place, const SourceMap& sources);

}  // namespace lancer::cli
