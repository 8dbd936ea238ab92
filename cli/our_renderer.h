// The judge's port with our tracer behind it: reference/ itself never sees the tracer.
#pragma once

#include "reference/validate/validate.h"

namespace lancer::cli {

/// A reference::OurRenderer. One thread; the scene's settings as they stand.
reference::OurPicture render_ours(const Scene& scene, const reference::ExportView& view);

}  // namespace lancer::cli
