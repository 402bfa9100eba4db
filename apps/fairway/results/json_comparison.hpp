// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/output.hpp"

namespace fairway::app {

/// What a value in a result is about.
enum class ValueKind : std::uint8_t {
  Result,      ///< what was computed
  Timing,      ///< how long it took: differs from run to run
  Provenance,  ///< what it was made from
};

/// A value that differs between two results.
struct JsonDifference {
  std::string name;  ///< "robots[amr].time"; elements go by name, world and trial, or number
  ValueKind kind = ValueKind::Result;
  Json a;  ///< null where it is missing
  Json b;
};

/// Two results, value by value.
struct JsonComparison {
  std::size_t values = 0;  ///< compared
  std::vector<JsonDifference> differences;

  [[nodiscard]] std::size_t count(ValueKind kind) const noexcept;
};

/// Compares two results. Numbers are equal when they differ by at most `tolerance` times the larger
/// magnitude of the two; all else when it is the same. Elements of lists are matched by their
/// `name`, `task`, `id`, `case`, or `world` and `trial`; lists without such keys by position.
[[nodiscard]] JsonComparison compare_json(const Json& a, const Json& b, double tolerance);

/// The comparison as text for a person: a line per difference, with the change of a number.
/// @param limit  Lines at most; the rest is counted.
[[nodiscard]] std::string comparison_text(const JsonComparison& comparison,
                                          bool with_timings,
                                          std::size_t limit);

/// The comparison as JSON: `values`, and `differences` with `name`, `kind`, `a`, `b` and `change`.
[[nodiscard]] Json comparison_json(const JsonComparison& comparison);

}  // namespace fairway::app
