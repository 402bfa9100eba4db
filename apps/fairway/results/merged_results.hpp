// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/output.hpp"

namespace fairway::app {

/// A result of one shard, and the file that it is from.
struct ShardResult {
  std::string file;
  Json result;
};

/// Joins the results of the shards of one batch (`worlds`, `tasks`, `cases` or `runs`).
///
/// The runs are sorted as a whole batch has them. Rates and means are weighted by the number of
/// runs (means of `fairway people`: of successful runs), which is exact; of computing times the
/// median is a weighted mean of medians, and p99 and max are the largest. Fails where the schemas,
/// the versions or the settings differ, a run is there twice, or a result has no list of runs.
[[nodiscard]] Expected<Json> merge_results(std::span<const ShardResult> shards);

}  // namespace fairway::app
