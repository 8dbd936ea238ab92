// --resume: keeps existing files that are complete and are what this run would draw.
#pragma once

#include <optional>
#include <string>

#include "model/io/part_layout.h"

namespace lancer::cli {

/// What a run finds under the name of a picture or part that it would draw.
struct Found {
    bool is_kept = false;
    std::string reason;  ///< why it is drawn again; empty when no file exists
};

Found found_picture(const std::string& path, const io::Origin& wanted);
Found found_part(const std::string& path, const io::PartHead& wanted);

}  // namespace lancer::cli
