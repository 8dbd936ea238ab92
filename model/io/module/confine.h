// Confines a process before it reads a picture.
#pragma once

namespace lancer::io {

/// See ImageModule::confine. Does nothing where the kernel has neither Landlock nor seccomp.
void confine();

}  // namespace lancer::io
