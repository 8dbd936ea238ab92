// How a picture file is written, and how much the work on it may cost.
#pragma once

#include "model/io/image_file.h"

namespace CLI {
class App;
}

namespace lancer::cli {

/// For every command that reads or writes pictures. What stands on the command line holds from the
/// moment it is read.
void add_picture_options(CLI::App& app);

/// --bits and --linear, for every command that writes one.
void add_encoding_options(CLI::App& app, io::ImageWriteOptions& image);

}  // namespace lancer::cli
