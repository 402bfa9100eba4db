// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/output.hpp"
#include "experiments/barn/barn_summary.hpp"

namespace fairway::app {

/// The values of the options under which the worlds were driven.
struct BarnConditions {
  std::string sensing;
  std::string physics;
  std::string noise;
};

/// The result of `fairway barn` and `fairway dynabarn`, without its provenance.
[[nodiscard]] Json barn_json(const BarnSummary& summary, const BarnConditions& conditions);

/// The same in two lines of text.
[[nodiscard]] std::string barn_text(const BarnSummary& summary);

}  // namespace fairway::app
