// A sweep over many scenes, shared by several machines: each takes every N-th scene and keeps what
// is costly in the cache, from which a last run without --part makes the report of all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"

namespace lancer::cli {

/// The option --part. `what`: what is dealt.
void add_share_option(CLI::App& app, std::optional<PartOf>& part,
                      const std::string& what = "scene");

/// Throws as below when this part of a sweep cannot be of use.
void check_share(const std::optional<PartOf>& part, const std::string& report,
                 const std::string& cache);

/// The scenes of this part, all of them without one.
///
/// \param report  the option that asks for a report of all scenes; empty: none stands there
/// \param cache   the folder that the machines share; empty: none, by --no-cache
///
/// Throws UsageError when a part has no cache to keep its results in or is asked for a report, and
/// FileError when the cache cannot be written.
std::vector<std::string> share_of(const std::vector<std::string>& scenes,
                                  const std::optional<PartOf>& part, const std::string& report,
                                  const std::string& cache);

}  // namespace lancer::cli
