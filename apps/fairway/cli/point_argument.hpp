// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "fairway/base/error.hpp"

namespace fairway::app {

/// A place given on the command line, with a heading where one was given.
struct PointArgument {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  std::optional<double> heading;
};

/// Parses `X,Y` or `X,Y,HEADING`: finite numbers, metres and radians, nothing around them.
/// `option` is named in the error.
[[nodiscard]] Expected<PointArgument> parse_point(const std::string& text, const char* option);

/// Parses finite numbers with commas between them; none if there is anything else.
[[nodiscard]] std::optional<std::vector<double>> parse_list(const std::string& text);

}  // namespace fairway::app
