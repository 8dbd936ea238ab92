// A sweep over many scenes, shared by several machines: each takes every N-th scene and stores
// costly results in the cache. A last run without --part makes the report of all scenes from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"

namespace lancer::cli {

/// Adds the option --part. `what`: the items that are dealt to the machines.
void add_share_option(CLI::App& app, std::optional<PartOf>& part,
                      const std::string& what = "scene");

/// Throws like share_of() when this part of a sweep would be useless.
void check_share(const std::optional<PartOf>& part, const std::string& report,
                 const std::string& cache);

/// The scenes of this part; all scenes when there is no part.
///
/// \param report  the option that asks for a report of all scenes; empty: none was given
/// \param cache   the folder that the machines share; empty: none, because of --no-cache
///
/// Throws UsageError when a part has no cache for its results or is asked for a report, and
/// FileError when the cache cannot be written.
std::vector<std::string> share_of(const std::vector<std::string>& scenes,
                                  const std::optional<PartOf>& part, const std::string& report,
                                  const std::string& cache);

}  // namespace lancer::cli
