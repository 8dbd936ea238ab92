// Describes the error of a picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "accuracy/error_picture.h"

namespace lancer::cli {

/// One line: the error with its interval, or why it cannot be told; and its cost.
std::string error_line(const accuracy::ErrorReport& report);
/// The same for the picture's file, as names and values.
std::vector<std::pair<std::string, std::string>> error_notes(const accuracy::ErrorReport& report);

}  // namespace lancer::cli
