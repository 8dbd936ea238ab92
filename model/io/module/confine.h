// What a process gives up before it looks at a picture.
#pragma once

namespace lancer::io {

/// See ImageModule::confine. Where the kernel has neither Landlock nor seccomp, nothing happens.
void confine();

}  // namespace lancer::io
