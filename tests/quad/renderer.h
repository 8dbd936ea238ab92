// The tracer in 113 bits, for checking last digits. About forty times slower than double.
#pragma once

#include <memory>

#include "tracer/render.h"

namespace lancer {

/// As compile(), whatever `settings.precision` says.
std::unique_ptr<Renderer> compile_quad(const Scene& scene, const Settings& settings);

}  // namespace lancer
