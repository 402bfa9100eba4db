// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "fairway/base/error.hpp"

namespace fairway::app {

/// A position on the command line, optionally with a heading.
struct PointArgument {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  std::optional<double> heading;
};

/// Parses `X,Y` or `X,Y,HEADING`: finite numbers in metres and radians, nothing around them. The
/// error names `option`.
[[nodiscard]] Expected<PointArgument> parse_point(const std::string& text, const char* option);

/// Parses finite numbers separated by commas; none for any other text.
[[nodiscard]] std::optional<std::vector<double>> parse_list(const std::string& text);

}  // namespace fairway::app
