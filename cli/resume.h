// --resume: what is there already is taken, when it is whole and what this run would draw.
#pragma once

#include <optional>
#include <string>

#include "model/io/part_layout.h"

namespace lancer::cli {

/// What a run finds at the name of a picture or part that it would draw.
struct Found {
    bool is_kept = false;
    std::string reason;  ///< why it is drawn again; empty where there is nothing yet
};

Found found_picture(const std::string& path, const io::Origin& wanted);
Found found_part(const std::string& path, const io::PartHead& wanted);

}  // namespace lancer::cli
