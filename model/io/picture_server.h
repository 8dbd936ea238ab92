// The picture process's side of picture_process.h.
#pragma once

namespace lancer::io {

/// Serves the requests from `socket` until the other end closes it, each in a process of its own.
/// False when `socket` is not a socket: somebody else started the program.
bool serve_pictures(int socket);

}  // namespace lancer::io
