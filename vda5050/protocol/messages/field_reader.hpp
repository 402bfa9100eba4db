// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace fairway::vda5050 {

/// The first field of a message that is wrong: `path: expected ..., found ...`.
struct FieldProblem {
  std::string field;    ///< path in the message, such as nodes[1].nodePosition.x
  std::string message;  ///< expected ..., found ...

  [[nodiscard]] std::string text() const {
    return field.empty() ? message : field + ": " + message;
  }
};

/// Range of a number, both ends included.
struct FieldRange {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
};

/// Typed access to the fields of a JSON object. Readers note the first problem and continue with
/// harmless values; the caller asks for the problem once, at the end. Unknown fields are ignored,
/// as the standard demands.
class FieldReader {
 public:
  /// @param problem  Receives the first problem; shared by the readers of one message.
  FieldReader(const nlohmann::json& object, std::string path, std::optional<FieldProblem>& problem);

  /// Returns whether a field is present and not null.
  [[nodiscard]] bool has(const char* name) const;

  [[nodiscard]] std::string text(const char* name);
  [[nodiscard]] std::string optional_text(const char* name, std::string fallback = {});
  [[nodiscard]] bool flag(const char* name);
  [[nodiscard]] bool optional_flag(const char* name, bool fallback);
  [[nodiscard]] double number(const char* name, const FieldRange& range = {});
  [[nodiscard]] std::optional<double> optional_number(const char* name,
                                                      const FieldRange& range = {});
  /// Reads a whole number from 0 on.
  [[nodiscard]] std::uint32_t count(const char* name);

  /// Returns the index of a word among `words`.
  [[nodiscard]] std::size_t word(const char* name, std::span<const char* const> words);
  [[nodiscard]] std::size_t optional_word(const char* name,
                                          std::span<const char* const> words,
                                          std::size_t fallback);

  /// Returns a reader of a nested object. @pre has(name).
  [[nodiscard]] FieldReader object(const char* name);
  /// Returns readers of the objects of a list; a missing list is a problem.
  [[nodiscard]] std::vector<FieldReader> objects(const char* name);
  [[nodiscard]] std::vector<FieldReader> optional_objects(const char* name);
  /// Returns the numbers of a list; a missing list is empty.
  [[nodiscard]] std::vector<double> numbers(const char* name);

  /// Notes a problem with a field; an empty name means the object.
  void complain(const std::string& name, std::string message);

  [[nodiscard]] const nlohmann::json& value() const noexcept { return *object_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] bool sound() const noexcept { return !*problem_; }

 private:
  [[nodiscard]] const nlohmann::json* find(const char* name, const char* expected);
  [[nodiscard]] std::string path_of(const std::string& name) const;

  const nlohmann::json* object_;
  std::string path_;
  std::optional<FieldProblem>* problem_;
};

/// Returns a short form of a JSON value for messages.
[[nodiscard]] std::string found_text(const nlohmann::json& value);

}  // namespace fairway::vda5050
