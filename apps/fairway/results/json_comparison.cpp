// SPDX-License-Identifier: Apache-2.0
#include "results/json_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/core.h>

namespace fairway::app {

namespace {

// Keys that name an element of a list; the first that an element has counts.
constexpr std::array kNames = {"name", "task", "id", "case", "world", "class"};

bool is_timing(std::string_view key) {
  constexpr std::array kWhole = {"seconds", "timing"};
  constexpr std::array kEndings = {"_us", "_ms", "_seconds"};
  return std::find(kWhole.begin(), kWhole.end(), key) != kWhole.end() ||
         std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return key.ends_with(ending); });
}

ValueKind kind_under(ValueKind kind, std::string_view key) {
  if (kind != ValueKind::Result) return kind;
  if (key == "provenance" || key == "schema" || key == "version" || key == "command")
    return ValueKind::Provenance;
  return is_timing(key) ? ValueKind::Timing : ValueKind::Result;
}

std::string scalar_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::optional<std::string> name_of(const Json& element) {
  if (!element.is_object()) return std::nullopt;
  for (const char* key : kNames) {
    const auto found = element.find(key);
    if (found == element.end() || found->is_structured()) continue;
    std::string name = scalar_text(*found);
    if (const auto trial = element.find("trial"); trial != element.end())
      name += ", trial " + scalar_text(*trial);
    return name;
  }
  return std::nullopt;
}

// The elements of a list or an object by the name that they are matched by, in their order.
std::vector<std::pair<std::string, const Json*>> members(const Json& json) {
  std::vector<std::pair<std::string, const Json*>> all;
  if (json.is_object()) {
    for (const auto& [key, value] : json.items())
      all.emplace_back(key, &value);
    return all;
  }
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::optional<std::string> name = name_of(json[i]);
    const bool is_new = name && ++seen[*name] == 1;
    all.emplace_back(is_new ? *name : std::to_string(i), &json[i]);
  }
  return all;
}

bool equal(const Json& a, const Json& b, double tolerance) {
  if (!a.is_number() || !b.is_number()) return a == b;
  const auto x = a.get<double>();
  const auto y = b.get<double>();
  return x == y || std::abs(x - y) <= tolerance * std::max(std::abs(x), std::abs(y));
}

class Comparer {
 public:
  Comparer(double tolerance, JsonComparison& result) : tolerance_(tolerance), result_(result) {}

  void compare(const std::string& name, ValueKind kind, const Json& a, const Json& b) {
    if (!(a.is_object() && b.is_object()) && !(a.is_array() && b.is_array())) {
      ++result_.values;
      if (!equal(a, b, tolerance_)) result_.differences.push_back({name, kind, a, b});
      return;
    }
    const bool object = a.is_object();
    const auto of_a = members(a);
    const auto of_b = members(b);
    std::map<std::string, const Json*> left(of_b.begin(), of_b.end());
    const auto at = [&](const std::string& key) {
      if (object) return name.empty() ? key : name + "." + key;
      return name + "[" + key + "]";
    };
    for (const auto& [key, value] : of_a) {
      const auto found = left.find(key);
      compare(at(key), object ? kind_under(kind, key) : kind, *value,
              found != left.end() ? *found->second : kMissing);
      if (found != left.end()) left.erase(found);
    }
    for (const auto& [key, value] : of_b) {
      if (left.contains(key))
        compare(at(key), object ? kind_under(kind, key) : kind, kMissing, *value);
    }
  }

 private:
  const Json kMissing = nullptr;
  double tolerance_;
  JsonComparison& result_;
};

std::string short_text(const Json& value) {
  constexpr std::size_t kMost = 40;
  std::string text = value.is_null() ? "-" : scalar_text(value);
  return text.size() <= kMost ? text : text.substr(0, kMost - 3) + "...";
}

std::string change_text(const Json& a, const Json& b) {
  if (!a.is_number() || !b.is_number()) return "";
  const double change = b.get<double>() - a.get<double>();
  std::string text = fmt::format("  {:+.6g}", change);
  if (a.get<double>() != 0.0)
    text += fmt::format(" ({:+.2f} %)", 100.0 * change / std::abs(a.get<double>()));
  return text;
}

const char* to_text(ValueKind kind) {
  switch (kind) {
    case ValueKind::Result:
      return "result";
    case ValueKind::Timing:
      return "timing";
    case ValueKind::Provenance:
      return "provenance";
  }
  return "unknown";
}

}  // namespace

std::size_t JsonComparison::count(ValueKind kind) const noexcept {
  return static_cast<std::size_t>(
      std::count_if(differences.begin(), differences.end(),
                    [&](const JsonDifference& difference) { return difference.kind == kind; }));
}

JsonComparison compare_json(const Json& a, const Json& b, double tolerance) {
  JsonComparison comparison;
  Comparer(tolerance, comparison).compare("", ValueKind::Result, a, b);
  return comparison;
}

std::string comparison_text(const JsonComparison& comparison,
                            bool with_timings,
                            std::size_t limit) {
  std::vector<const JsonDifference*> shown;
  for (const ValueKind kind : {ValueKind::Provenance, ValueKind::Result, ValueKind::Timing}) {
    if (kind == ValueKind::Timing && !with_timings) continue;
    for (const JsonDifference& difference : comparison.differences) {
      if (difference.kind == kind) shown.push_back(&difference);
    }
  }
  const std::size_t lines = std::min(limit, shown.size());
  std::size_t width = 0;
  for (std::size_t i = 0; i < lines; ++i)
    width = std::max(width, std::min<std::size_t>(60, shown[i]->name.size()));
  std::string text;
  for (std::size_t i = 0; i < lines; ++i) {
    const JsonDifference& d = *shown[i];
    text += fmt::format("{:<{}}  {} -> {}{}\n", d.name, width, short_text(d.a), short_text(d.b),
                        change_text(d.a, d.b));
  }
  if (shown.size() > lines) text += fmt::format("... and {} more\n", shown.size() - lines);
  return text + fmt::format("{} values compared: {} results differ, {} timings, {} of provenance\n",
                            comparison.values, comparison.count(ValueKind::Result),
                            comparison.count(ValueKind::Timing),
                            comparison.count(ValueKind::Provenance));
}

Json comparison_json(const JsonComparison& comparison) {
  Json all = Json::array();
  for (const JsonDifference& d : comparison.differences) {
    Json one{{"name", d.name}, {"kind", to_text(d.kind)}, {"a", d.a}, {"b", d.b}};
    if (d.a.is_number() && d.b.is_number()) one["change"] = d.b.get<double>() - d.a.get<double>();
    all.push_back(std::move(one));
  }
  return {{"values", comparison.values},
          {"same", comparison.count(ValueKind::Result) == 0},
          {"differences", std::move(all)}};
}

}  // namespace fairway::app
