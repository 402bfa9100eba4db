// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/yaml/yaml_file.hpp"

#include <cmath>

#include <fmt/core.h>

#include "fairway/io/number_text.hpp"

namespace fairway::io {

std::string kind_of(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) return "nothing";
  if (node.IsMap()) return "a mapping";
  if (node.IsSequence()) return "a list";
  return excerpt(node.Scalar());
}

int line_of(const YAML::Node& node) { return node.IsDefined() ? node.Mark().line + 1 : 0; }

void YamlFile::complain(int line, const std::string& key, const std::string& message) {
  if (error) return;
  const std::string where = line > 0 ? fmt::format("{}:{}", name, line) : name;
  const std::string what = key.empty() ? message : fmt::format("{}: {}", key, message);
  error = fail(where.empty() ? what : fmt::format("{}: {}", where, what)).value();
}

std::string describe(const char* kind, const NumberRange& range) {
  const bool low = std::isfinite(range.min);
  const bool high = std::isfinite(range.max);
  if (low && high && range.min_allowed) {
    return fmt::format("{} from {} to {}", kind, range.min, range.max);
  }
  if (low && high) return fmt::format("{} above {} and at most {}", kind, range.min, range.max);
  if (low) {
    return fmt::format("{} {} {}", kind, range.min_allowed ? "of at least" : "above", range.min);
  }
  if (high) return fmt::format("{} of at most {}", kind, range.max);
  return kind;
}

std::string alternatives(std::span<const char* const> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace fairway::io
