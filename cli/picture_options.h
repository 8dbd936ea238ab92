// Options for writing picture files, and limits on the work on them.
#pragma once

#include "model/io/image_file.h"

namespace CLI {
class App;
}

namespace lancer::cli {

/// Options for every command that reads or writes pictures. Each takes effect when it is parsed.
void add_picture_options(CLI::App& app);

/// --bits and --linear, for every command that writes a picture.
void add_encoding_options(CLI::App& app, io::ImageWriteOptions& image);

}  // namespace lancer::cli
