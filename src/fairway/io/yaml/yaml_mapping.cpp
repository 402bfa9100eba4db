// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/yaml/yaml_mapping.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "fairway/io/number_text.hpp"

namespace fairway::io {

YamlMapping::YamlMapping(YamlFile& file, const YAML::Node& node, std::string prefix)
    : file_(&file),
      node_(node),
      prefix_(std::move(prefix)),
      line_(line_of(node)) {
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) {
      file_->complain(line_of(entry.first), prefix_, "expected a name as key, found another thing");
    } else if (!seen.insert(entry.first.Scalar()).second) {
      file_->complain(line_of(entry.first), full(excerpt(entry.first.Scalar())),
                      "expected a key once, found it twice");
    }
  }
}

std::string YamlMapping::full(const std::string& key) const {
  return prefix_.empty() ? key : fmt::format("{}.{}", prefix_, key);
}

YAML::Node YamlMapping::find(const char* key) {
  asked_.insert(key);
  for (const auto& entry : node_) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) return entry.second;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

bool YamlMapping::has(const char* key) const {
  for (const auto& entry : node_) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) return true;
  }
  return false;
}

int YamlMapping::line(const char* key) const {
  for (const auto& entry : node_) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) return line_of(entry.first);
  }
  return line_;
}

void YamlMapping::complain(const char* key, const std::string& message) {
  file_->complain(line(key), full(key), message);
}

void YamlMapping::warn(const std::string& message) {
  std::vector<std::string>& warnings = file_->warnings;
  if (std::find(warnings.begin(), warnings.end(), message) == warnings.end())
    warnings.push_back(message);
}

void YamlMapping::missing(const char* key, const std::string& expected) {
  complain(key, fmt::format("expected {}, found no such key", expected));
}

std::optional<std::string> YamlMapping::scalar(const char* key) {
  const YAML::Node node = find(key);
  if (node.IsDefined() && node.IsScalar()) return node.Scalar();
  complain(key, fmt::format("expected a value, found {}", kind_of(node)));
  return std::nullopt;
}

double YamlMapping::number(const char* key,
                           const NumberRange& range,
                           std::optional<double> fallback) {
  const YAML::Node node = find(key);
  const std::string expected = describe("a number", range);
  if (!node.IsDefined()) {
    if (!fallback) missing(key, expected);
    return fallback.value_or(0.0);
  }
  const std::optional<double> value =
      node.IsScalar() ? parse_number(node.Scalar()) : std::optional<double>();
  if (value && *value <= range.max &&
      (range.min_allowed ? *value >= range.min : *value > range.min)) {
    return *value;
  }
  complain(key, fmt::format("expected {}, found {}", expected, kind_of(node)));
  return fallback.value_or(0.0);
}

int YamlMapping::integer(const char* key, const NumberRange& range, std::optional<int> fallback) {
  const YAML::Node node = find(key);
  const std::string expected = describe("an integer", range);
  if (!node.IsDefined()) {
    if (!fallback) missing(key, expected);
    return fallback.value_or(0);
  }
  const std::optional<int> value =
      node.IsScalar() ? parse_integer(node.Scalar()) : std::optional<int>();
  if (value && *value >= range.min && *value <= range.max) return *value;
  complain(key, fmt::format("expected {}, found {}", expected, kind_of(node)));
  return fallback.value_or(0);
}

bool YamlMapping::boolean(const char* key, std::optional<bool> fallback) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) {
    if (!fallback) missing(key, "true or false");
    return fallback.value_or(false);
  }
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  complain(key, fmt::format("expected true or false, found {}", kind_of(node)));
  return fallback.value_or(false);
}

std::string YamlMapping::text(const char* key, std::optional<std::string> fallback) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) {
    if (!fallback) missing(key, "a text");
    return fallback.value_or("");
  }
  if (node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  complain(key, fmt::format("expected a text, found {}", kind_of(node)));
  return fallback.value_or("");
}

std::size_t YamlMapping::choice(const char* key,
                                std::span<const char* const> names,
                                std::optional<std::size_t> fallback) {
  const YAML::Node node = find(key);
  const std::string expected = alternatives(names);
  if (!node.IsDefined()) {
    if (!fallback) missing(key, expected);
    return fallback.value_or(0);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (node.IsScalar() && node.Scalar() == names[i]) return i;
  }
  complain(key, fmt::format("expected {}, found {}", expected, kind_of(node)));
  return fallback.value_or(0);
}

std::vector<double> YamlMapping::numbers(const char* key, std::size_t least, std::size_t most) {
  const YAML::Node node = find(key);
  const std::string expected = least == most
                                   ? fmt::format("a list of {} numbers", least)
                                   : fmt::format("a list of {} to {} numbers", least, most);
  if (!node.IsDefined()) {
    if (least > 0) missing(key, expected);
    return {};
  }
  return number_list(node, key, expected, least, most);
}

std::vector<double> YamlMapping::number_list(const YAML::Node& node,
                                             const char* key,
                                             const std::string& expected,
                                             std::size_t least,
                                             std::size_t most) {
  if (!node.IsSequence() || node.size() < least || node.size() > most) {
    const std::string found =
        node.IsSequence() ? fmt::format("{} of them", node.size()) : kind_of(node);
    file_->complain(line_of(node), full(key),
                    fmt::format("expected {}, found {}", expected, found));
    return {};
  }
  std::vector<double> values;
  for (const YAML::Node& item : node) {
    const std::optional<double> value =
        item.IsScalar() ? parse_number(item.Scalar()) : std::optional<double>();
    if (!value) {
      file_->complain(line_of(item), full(key),
                      fmt::format("expected {}, found {}", expected, kind_of(item)));
      return {};
    }
    values.push_back(*value);
  }
  return values;
}

std::vector<std::vector<double>> YamlMapping::rows(const char* key, std::size_t columns) {
  const YAML::Node node = find(key);
  const std::string expected = fmt::format("lists of {} numbers", columns);
  std::vector<std::vector<double>> result;
  if (!node.IsDefined()) return result;
  if (!node.IsSequence()) {
    complain(key, fmt::format("expected {}, found {}", expected, kind_of(node)));
    return result;
  }
  for (const YAML::Node& item : node) {
    std::vector<double> row = number_list(item, key, expected, columns, columns);
    if (row.empty()) return {};
    result.push_back(std::move(row));
  }
  return result;
}

std::optional<YamlMapping> YamlMapping::mapping(const char* key) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsMap()) {
    complain(key, fmt::format("expected a mapping, found {}", kind_of(node)));
    return std::nullopt;
  }
  return YamlMapping(*file_, node, full(key));
}

std::vector<YamlMapping> YamlMapping::mappings(const char* key) {
  const YAML::Node node = find(key);
  std::vector<YamlMapping> result;
  if (!node.IsDefined()) return result;
  if (!node.IsSequence()) {
    complain(key, fmt::format("expected a list, found {}", kind_of(node)));
    return result;
  }
  for (const YAML::Node& item : node) {
    const std::string name = full(fmt::format("{}[{}]", key, result.size()));
    if (!item.IsMap()) {
      file_->complain(line_of(item), name,
                      fmt::format("expected a mapping, found {}", kind_of(item)));
      return result;
    }
    result.emplace_back(*file_, item, name);
  }
  return result;
}

void YamlMapping::finish() {
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar() || asked_.contains(entry.first.Scalar())) continue;
    std::string known;
    for (const std::string& name : asked_)
      known += (known.empty() ? "" : ", ") + name;
    file_->complain(line_of(entry.first), full(excerpt(entry.first.Scalar())),
                    fmt::format("expected one of {}, found an unknown key", known));
    return;
  }
}

}  // namespace fairway::io
