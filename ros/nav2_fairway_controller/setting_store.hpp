// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "nav2_fairway_controller/following/following_settings.hpp"

namespace fairway::nav2 {

/// The value of a parameter.
using SettingValue = std::variant<bool, std::int64_t, double, std::string>;

/// A parameter's name, without the name of the plugin, and a value for it.
struct SettingChange {
  std::string name;
  SettingValue value;
};

/// What a plugin declares for a setting.
struct SettingDeclaration {
  std::string name;             ///< group.name
  SettingValue value;           ///< default
  std::string meaning;          ///< with unit
  std::optional<double> least;  ///< range of a number
  std::optional<double> greatest;
};

/// The settings of a plugin, changed by name.
///
/// ROS asks several validators before it stores a parameter. A change that this store accepts is
/// therefore only proposed; it takes effect when `take_change` finds that the node has stored it.
/// All functions may be called from any thread.
class SettingStore {
 public:
  /// @param with_following  Whether the group `following` is part of the parameters.
  SettingStore(const FollowerSettings& defaults, bool with_following);

  /// The declarations of all settings, with the present values as defaults.
  [[nodiscard]] std::vector<SettingDeclaration> declarations() const;

  /// Sets values at once, all or none. A whole number is accepted for a real one; names of other
  /// parameters are ignored.
  /// @return The first fault, which names the setting, or an empty text.
  std::string set(std::span<const SettingChange> changes);

  /// Checks changes together with those proposed before, and proposes them if there is no fault.
  /// @return As `set`.
  std::string propose(std::span<const SettingChange> changes, double time);

  /// Returns the settings after a proposed change has taken effect, and otherwise none.
  /// @param stored  Returns the value that the node has stored for a name.
  [[nodiscard]] std::optional<FollowerSettings> take_change(
      double time, const std::function<std::optional<SettingValue>(const std::string&)>& stored);

  [[nodiscard]] FollowerSettings settings() const;

 private:
  std::string assign(std::span<const SettingChange> changes, FollowerSettings& settings) const;

  mutable std::mutex mutex_;
  bool with_following_;
  FollowerSettings settings_;
  std::map<std::string, SettingValue> proposed_;
  double proposal_time_ = 0.0;
};

}  // namespace fairway::nav2
