// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/field_reader.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace fairway::vda5050 {

using nlohmann::json;

namespace {

const json& empty_object() {
  static const json object = json::object();
  return object;
}

std::string number_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

std::string range_text(const FieldRange& range) {
  const bool low = range.low > -std::numeric_limits<double>::max();
  const bool high = range.high < std::numeric_limits<double>::max();
  if (low && high)
    return "a number from " + number_text(range.low) + " to " + number_text(range.high);
  if (low) return "a number from " + number_text(range.low) + " on";
  return "a finite number";
}

}  // namespace

std::string found_text(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list";
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  constexpr std::size_t kLongest = 60;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

FieldReader::FieldReader(const json& object, std::string path, std::optional<FieldProblem>& problem)
    : object_(&object),
      path_(std::move(path)),
      problem_(&problem) {
  if (object.is_object()) return;
  complain("", "expected an object, found " + found_text(object));
  object_ = &empty_object();
}

std::string FieldReader::path_of(const std::string& name) const {
  if (path_.empty() || name.empty()) return path_ + name;
  return path_ + "." + name;
}

void FieldReader::complain(const std::string& name, std::string message) {
  if (!*problem_) *problem_ = FieldProblem{.field = path_of(name), .message = std::move(message)};
}

bool FieldReader::has(const char* name) const {
  const auto found = object_->find(name);
  return found != object_->end() && !found->is_null();
}

const json* FieldReader::find(const char* name, const char* expected) {
  const auto found = object_->find(name);
  if (found != object_->end()) return &*found;
  complain(name, std::string("expected ") + expected + ", found nothing");
  return nullptr;
}

std::string FieldReader::text(const char* name) {
  const json* value = find(name, "a text");
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  complain(name, "expected a text, found " + found_text(*value));
  return {};
}

std::string FieldReader::optional_text(const char* name, std::string fallback) {
  return has(name) ? text(name) : std::move(fallback);
}

bool FieldReader::flag(const char* name) {
  const json* value = find(name, "true or false");
  if (value == nullptr) return false;
  if (value->is_boolean()) return value->get<bool>();
  complain(name, "expected true or false, found " + found_text(*value));
  return false;
}

bool FieldReader::optional_flag(const char* name, bool fallback) {
  return has(name) ? flag(name) : fallback;
}

double FieldReader::number(const char* name, const FieldRange& range) {
  const json* value = find(name, "a number");
  if (value == nullptr) return 0.0;
  const double number = value->is_number() ? value->get<double>() : std::nan("");
  if (number >= range.low && number <= range.high) return number;
  complain(name, "expected " + range_text(range) + ", found " + found_text(*value));
  return 0.0;
}

std::optional<double> FieldReader::optional_number(const char* name, const FieldRange& range) {
  if (!has(name)) return std::nullopt;
  return number(name, range);
}

std::uint32_t FieldReader::count(const char* name) {
  constexpr double kMost = std::numeric_limits<std::uint32_t>::max();
  const json* value = find(name, "a whole number");
  if (value == nullptr) return 0;
  const double number = value->is_number() ? value->get<double>() : -1.0;
  if (number >= 0.0 && number <= kMost && std::floor(number) == number) {
    return static_cast<std::uint32_t>(number);
  }
  complain(name, "expected a whole number from 0 on, found " + found_text(*value));
  return 0;
}

std::size_t FieldReader::word(const char* name, std::span<const char* const> words) {
  const std::string given = text(name);
  std::string expected;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (given == words[i]) return i;
    expected += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + std::string(words[i]);
  }
  complain(name, "expected " + expected + ", found \"" + given + "\"");
  return 0;
}

std::size_t FieldReader::optional_word(const char* name,
                                       std::span<const char* const> words,
                                       std::size_t fallback) {
  return has(name) ? word(name, words) : fallback;
}

FieldReader FieldReader::object(const char* name) {
  return {has(name) ? object_->at(name) : empty_object(), path_of(name), *problem_};
}

std::vector<FieldReader> FieldReader::objects(const char* name) {
  std::vector<FieldReader> readers;
  const json* value = find(name, "a list");
  if (value == nullptr) return readers;
  if (!value->is_array()) {
    complain(name, "expected a list, found " + found_text(*value));
    return readers;
  }
  readers.reserve(value->size());
  for (std::size_t i = 0; i < value->size(); ++i) {
    readers.emplace_back((*value)[i], path_of(name) + "[" + std::to_string(i) + "]", *problem_);
  }
  return readers;
}

std::vector<FieldReader> FieldReader::optional_objects(const char* name) {
  return has(name) ? objects(name) : std::vector<FieldReader>{};
}

std::vector<double> FieldReader::numbers(const char* name) {
  std::vector<double> list;
  if (!has(name)) return list;
  const json& value = object_->at(name);
  if (!value.is_array()) {
    complain(name, "expected a list of numbers, found " + found_text(value));
    return list;
  }
  for (const json& item : value) {
    if (!item.is_number()) {
      complain(name, "expected numbers, found " + found_text(item));
      return {};
    }
    list.push_back(item.get<double>());
  }
  return list;
}

}  // namespace fairway::vda5050
