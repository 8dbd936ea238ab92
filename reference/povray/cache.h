// Pictures that POV-Ray made already, kept by what they were made from.
#pragma once

#include <optional>
#include <string>

#include "reference/povray/runner.h"

namespace lancer::reference {

/// What an entry holds.
struct CacheEntry {
    double seconds = 0;  ///< that POV-Ray took
    std::string png;     ///< the file's bytes
};

/// The digest of everything that decides the picture: text, assets, size, options, version.
std::string cache_key(const PovRay& povray, const PovJob& job);

/// The entry, or nothing when there is none or it is not whole.
std::optional<CacheEntry> read_cache(const std::string& folder, const std::string& key);

/// Keeps an entry. A cache that cannot be written costs
/// time, not the picture: false then.
bool write_cache(const std::string& folder, const std::string& key, const CacheEntry& entry);

}  // namespace lancer::reference
