// The names of a scene's parts in messages.
#pragma once

#include <cstddef>
#include <string>

#include "judge/validate/validate.h"

namespace lancer::judge {

/// `object 3 "lid" at cup.lancer:12:1`, counted from 1.
std::string object_words(const ValidationJob& job, std::size_t index);

/// `light 2 at cup.lancer:4:1`
std::string light_words(const ValidationJob& job, std::size_t index);

}  // namespace lancer::judge
