// A cache of POV-Ray's pictures, keyed by all that they depend on.
#pragma once

#include <optional>
#include <string>

#include "reference/povray/runner.h"

namespace lancer::reference {

/// The content of an entry.
struct CacheEntry {
    double seconds = 0;  ///< the time that POV-Ray took
    std::string png;     ///< the file's bytes
};

/// The digest of everything that the picture depends on: text, assets, size, options, version.
std::string cache_key(const PovRay& povray, const PovJob& job);

/// The entry; nothing when there is none or it is incomplete.
std::optional<CacheEntry> read_cache(const std::string& folder, const std::string& key);

/// Stores an entry. False when the cache cannot be written, which costs time but not the picture.
bool write_cache(const std::string& folder, const std::string& key, const CacheEntry& entry);

}  // namespace lancer::reference
