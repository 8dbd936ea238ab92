// What the libraries behind the module do not notice, or only after taking gigabytes of memory.
#pragma once

#include <string>
#include <string_view>

namespace lancer::io {

/// Why these bytes are no whole JPEG file; empty when they are. libjpeg itself makes up what is
/// missing from a truncated one, however much that is.
std::string jpeg_problem(std::string_view bytes);

/// Why the header of these bytes is none of an EXR file; empty when it is. OpenEXR trusts the
/// lengths and the size that stand there.
std::string exr_problem(std::string_view bytes);

}  // namespace lancer::io
