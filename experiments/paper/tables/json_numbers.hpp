// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/sample_statistics.hpp"

namespace fairway::reproduction {

[[nodiscard]] inline Json to_json(const Estimate& e) {
  return {{"mean", e.mean},
          {"standard_deviation", e.deviation},
          {"ci95", {e.low, e.high}},
          {"count", e.count}};
}

[[nodiscard]] inline Json to_json(const TestResult& test) {
  return {{"t", test.t},
          {"degrees_of_freedom", test.degrees},
          {"p", test.p},
          {"mark", significance_mark(test.p)}};
}

}  // namespace fairway::reproduction
