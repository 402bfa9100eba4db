// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/setting_store.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <utility>

namespace fairway::nav2 {

namespace {

template <typename Value>
constexpr bool kIsNumber = std::is_same_v<Value, int> || std::is_same_v<Value, double>;

template <typename Value>
SettingValue stored(const Value& value) {
  if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, double>) {
    return value;
  } else if constexpr (std::is_same_v<Value, int>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::is_same_v<Value, BodyDiscs>) {
    return to_text(value);
  } else {
    return std::string(setting_names(value)[static_cast<std::size_t>(value)]);
  }
}

std::string number_text(double number) {
  char text[32];
  std::snprintf(static_cast<char*>(text), sizeof(text), "%.6g", number);
  return static_cast<const char*>(text);
}

template <typename Value>
std::string assign_number(const SettingValue& given, const SettingInfo& info, Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&given);
  const auto* real = std::get_if<double>(&given);
  const char* kind = std::is_same_v<Value, int> ? "a whole number" : "a number";
  const double number = whole != nullptr  ? static_cast<double>(*whole)
                        : real != nullptr ? *real
                                          : std::nan("");
  const bool fits = !std::is_same_v<Value, int> || number == std::round(number);
  if (!fits || !(number >= info.min && number <= info.max)) {
    return std::string("expected ") + kind + " from " + number_text(info.min) + " to " +
           number_text(info.max) +
           (std::isnan(number) ? ", found something else" : ", found " + number_text(number));
  }
  value = static_cast<Value>(number);
  return {};
}

// Copies a value to a setting; returns the fault, or an empty text.
template <typename Value>
std::string assign_value(const SettingValue& given, const SettingInfo& info, Value& value) {
  if constexpr (kIsNumber<Value>) {
    return assign_number(given, info, value);
  } else if constexpr (std::is_same_v<Value, bool>) {
    const bool* flag = std::get_if<bool>(&given);
    if (flag == nullptr) return "expected true or false";
    value = *flag;
  } else if constexpr (std::is_same_v<Value, BodyDiscs>) {
    const auto* text = std::get_if<std::string>(&given);
    const auto parsed = text != nullptr ? parse_body_discs(*text) : std::nullopt;
    if (!parsed) return std::string("expected ") + kBodyDiscsExpected;
    value = *parsed;
  } else {
    const auto names = setting_names(value);
    const auto* text = std::get_if<std::string>(&given);
    const auto found = text != nullptr ? std::find(names.begin(), names.end(), *text) : names.end();
    if (found == names.end()) {
      std::string expected = "expected one of";
      for (const char* name : names)
        expected += std::string(" ") + name;
      return expected;
    }
    value = static_cast<Value>(found - names.begin());
  }
  return {};
}

// Visits all settings with their full names.
template <typename S, typename Visitor>
void visit_all(S& settings, bool with_following, Visitor&& visit) {
  visit_follower_settings(settings, [&](const char* group, auto&& visit_fields) {
    if (!with_following && std::string_view(group) == "following") return;
    visit_fields([&](auto& value, const SettingInfo& info) {
      visit(std::string(group) + "." + info.name, value, info);
    });
  });
}

}  // namespace

SettingStore::SettingStore(const FollowerSettings& defaults, bool with_following)
    : with_following_(with_following),
      settings_(defaults) {}

std::vector<SettingDeclaration> SettingStore::declarations() const {
  const FollowerSettings settings = this->settings();
  std::vector<SettingDeclaration> all;
  visit_all(settings, with_following_,
            [&](const std::string& name, const auto& value, const SettingInfo& info) {
              SettingDeclaration declaration{
                  .name = name, .value = stored(value), .meaning = info.meaning};
              if (*info.unit != '\0') declaration.meaning += std::string(" [") + info.unit + "]";
              if (std::isfinite(info.min)) declaration.least = info.min;
              if (std::isfinite(info.max)) declaration.greatest = info.max;
              all.push_back(std::move(declaration));
            });
  return all;
}

std::string SettingStore::assign(std::span<const SettingChange> changes,
                                 FollowerSettings& settings) const {
  std::string fault;
  visit_all(settings, with_following_,
            [&](const std::string& name, auto& value, const SettingInfo& info) {
              for (const SettingChange& change : changes) {
                if (change.name != name || !fault.empty()) continue;
                fault = assign_value(change.value, info, value);
                if (!fault.empty()) fault = name + ": " + fault;
              }
            });
  if (!fault.empty()) return fault;
  const auto valid = validate(settings.robot);
  if (!valid) return valid.error().message;
  if (settings.motion.model == MotionModel::Disc) return {};
  const auto base = validate(base_of(settings.motion, settings.robot.robot));
  return base ? std::string() : "motion: " + base.error().message;
}

std::string SettingStore::set(std::span<const SettingChange> changes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  FollowerSettings wanted = settings_;
  std::string fault = assign(changes, wanted);
  if (fault.empty()) settings_ = wanted;
  return fault;
}

std::string SettingStore::propose(std::span<const SettingChange> changes, double time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  FollowerSettings wanted = settings_;
  std::vector<SettingChange> all;
  for (const auto& [name, value] : proposed_)
    all.push_back({.name = name, .value = value});
  all.insert(all.end(), changes.begin(), changes.end());
  std::string fault = assign(all, wanted);
  if (!fault.empty()) return fault;
  for (const SettingChange& change : changes)
    proposed_[change.name] = change.value;
  proposal_time_ = time;
  return {};
}

std::optional<FollowerSettings> SettingStore::take_change(
    double time,
    const std::function<std::optional<SettingValue>(const std::string&)>& stored_value) {
  constexpr double kRefused = 1.0;  // [s] after which a proposal was refused by another validator
  std::map<std::string, SettingValue> proposed;
  bool old = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (proposed_.empty()) return std::nullopt;
    proposed = proposed_;
    old = std::abs(time - proposal_time_) > kRefused;
  }
  // The node is asked without the lock, because it may hold its own while it calls `propose`.
  std::vector<SettingChange> accepted;
  for (const auto& [name, value] : proposed) {
    if (stored_value(name) == value) accepted.push_back({.name = name, .value = value});
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  FollowerSettings next = settings_;
  // Settings that belong together arrive together.
  const bool complete = accepted.size() == proposed.size();
  if (!complete && !old) return std::nullopt;
  for (const auto& [name, value] : proposed) {
    const auto entry = proposed_.find(name);
    if (entry != proposed_.end() && entry->second == value) proposed_.erase(entry);
  }
  if (accepted.empty() || !assign(accepted, next).empty()) return std::nullopt;
  settings_ = next;
  return settings_;
}

FollowerSettings SettingStore::settings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return settings_;
}

}  // namespace fairway::nav2
