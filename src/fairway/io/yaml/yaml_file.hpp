// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// The file being read and its first error. Reading continues with harmless values after an error,
/// so that a reader is a plain list of its keys, and ends with `error`.
struct YamlFile {
  std::string name;                   ///< as used in messages
  std::optional<Error> error;         ///< the first error
  std::vector<std::string> warnings;  ///< accepted parts that should be written differently

  /// Records `FILE:LINE: key: message` if it is the first error; line 0 is omitted.
  void complain(int line, const std::string& key, const std::string& message);
};

/// Inclusive bounds of a number.
struct NumberRange {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_allowed = true;  ///< whether `min` itself is allowed
};

/// Describes a range to the user: "a number", "a number from 0 to 1", "a number above 0".
[[nodiscard]] std::string describe(const char* kind, const NumberRange& range);

/// "a", "a or b", "a, b or c".
[[nodiscard]] std::string alternatives(std::span<const char* const> names);

/// Describes a node to the user: its text in quotes, or "a list", "a mapping", "nothing".
[[nodiscard]] std::string kind_of(const YAML::Node& node);

/// The line of a node in its file, from 1; 0 for a missing node.
[[nodiscard]] int line_of(const YAML::Node& node);

}  // namespace fairway::io
