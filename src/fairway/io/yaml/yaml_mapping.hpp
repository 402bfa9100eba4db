// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "fairway/io/yaml/yaml_file.hpp"

namespace fairway::io {

/// A mapping of a YAML file with typed access to its keys. Every reader ends with `finish`, which
/// reports the keys that were not read.
class YamlMapping {
 public:
  YamlMapping(YamlFile& file, const YAML::Node& node, std::string prefix = "");

  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] int line() const noexcept { return line_; }
  [[nodiscard]] int line(const char* key) const;  ///< of the key's value; of the mapping for a
                                                  ///< missing key

  /// Each returns the value of a key. A missing key gives `fallback`, or an error without a
  /// fallback.
  double number(const char* key,
                const NumberRange& range = {},
                std::optional<double> fallback = std::nullopt);
  int integer(const char* key,
              const NumberRange& range = {},
              std::optional<int> fallback = std::nullopt);
  bool boolean(const char* key, std::optional<bool> fallback = std::nullopt);
  std::string text(const char* key, std::optional<std::string> fallback = std::nullopt);

  /// The index of the value among `names`.
  std::size_t choice(const char* key,
                     std::span<const char* const> names,
                     std::optional<std::size_t> fallback = std::nullopt);

  /// Reads a list of `least` to `most` finite numbers. It is empty after an error, or for a missing
  /// key if `least` is 0.
  std::vector<double> numbers(const char* key, std::size_t least, std::size_t most);

  /// A list of lists of `columns` finite numbers each; empty for a missing key or after an error.
  std::vector<std::vector<double>> rows(const char* key, std::size_t columns);

  /// The mapping below a key; none for a missing key.
  std::optional<YamlMapping> mapping(const char* key);

  /// The mappings listed below a key; none for a missing key.
  std::vector<YamlMapping> mappings(const char* key);

  /// The scalar below a key as text; none after an error.
  std::optional<std::string> scalar(const char* key);

  /// Makes a key known to `finish` without reading it.
  void expect(const char* key) { asked_.insert(key); }

  /// Reports an error at a key of this mapping: `expected ..., found ...`.
  void complain(const char* key, const std::string& message);

  /// Reports an error of this mapping as a whole.
  void complain_here(const std::string& message) { file_->complain(line_, prefix_, message); }

  /// Warns once about a part that is accepted but should be written differently.
  void warn(const std::string& message);

  /// Reports the first key that was not read.
  void finish();

 private:
  YAML::Node find(const char* key);
  std::vector<double> number_list(const YAML::Node& node,
                                  const char* key,
                                  const std::string& expected,
                                  std::size_t least,
                                  std::size_t most);
  void missing(const char* key, const std::string& expected);
  [[nodiscard]] std::string full(const std::string& key) const;

  YamlFile* file_;
  YAML::Node node_;
  std::string prefix_;
  int line_ = 0;
  std::set<std::string> asked_;
};

}  // namespace fairway::io
