// Warnings about colours that are written from 0 to 255.
#pragma once

#include "model/math.h"
#include "parser/report.h"

namespace lancer {

/// Warns when a surface's colour is more than twice as bright as white.
void warn_bright_surface(Report& report, const SourceSpan& place, const Color& color);
/// Warns when a colour of light consists of whole numbers up to 255. Light may be as bright as one
/// likes, so a large value alone is no reason for a warning.
void warn_bright_light(Report& report, const SourceSpan& place, const Color& color);

}  // namespace lancer
