// The other side of picture_process.h: what the program does when it was started to work on
// pictures.
#pragma once

namespace lancer::io {

/// Serves the requests that come over `socket` until the other end closes it. Each is worked on in
/// a process of its own. False when `socket` is none: somebody else started the program.
bool serve_pictures(int socket);

}  // namespace lancer::io
