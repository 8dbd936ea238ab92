// What the parts of a scene are called, for people.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "model/scene.h"
#include "model/source.h"

namespace lancer::cli {

/// `sphere "ball"`
std::string describe(const Scene& scene, const Object& object);

/// Empty where the script gives it none.
std::string material_name(const Scene& scene, std::uint32_t material);

/// `file:line:column`; empty for what is not from a script.
std::string describe_place(const SourceSpan& place, const SourceMap& sources);

}  // namespace lancer::cli
