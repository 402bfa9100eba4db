// SPDX-License-Identifier: Apache-2.0
#include "cli/point_argument.hpp"

#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/io/number_text.hpp"

namespace fairway::app {

std::optional<std::vector<double>> parse_list(const std::string& text) {
  std::vector<double> values;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> value = io::parse_number(rest.substr(0, comma));
    if (!value) return std::nullopt;
    values.push_back(*value);
    if (comma == std::string_view::npos) return values;
    rest.remove_prefix(comma + 1);
  }
}

Expected<PointArgument> parse_point(const std::string& text, const char* option) {
  const std::optional<std::vector<double>> values = parse_list(text);
  if (!values || values->size() < 2 || values->size() > 3) {
    return fail(fmt::format("{}: expected X,Y or X,Y,HEADING in metres and radians, found {}",
                            option, io::excerpt(text)));
  }
  PointArgument point{.position = {(*values)[0], (*values)[1]}, .heading = {}};
  if (values->size() == 3) point.heading = wrap_to_pi((*values)[2]);
  return point;
}

}  // namespace fairway::app
