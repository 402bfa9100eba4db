// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocol/messages/field_reader.hpp"

namespace fairway::vda5050 {

/// What else the vehicle may do during an action.
enum class BlockingType : std::uint8_t {
  None,    ///< driving and other actions continue
  Single,  ///< driving continues, other actions wait
  Soft,    ///< no driving; other actions continue
  Hard,    ///< no driving and no other action
};

inline constexpr std::array<const char*, 4> kBlockingNames{"NONE", "SINGLE", "SOFT", "HARD"};

/// Returns whether the vehicle must not drive during an action.
[[nodiscard]] constexpr bool forbids_driving(BlockingType type) noexcept {
  return type == BlockingType::Soft || type == BlockingType::Hard;
}

/// Returns whether an action excludes other actions.
[[nodiscard]] constexpr bool excludes_others(BlockingType type) noexcept {
  return type == BlockingType::Single || type == BlockingType::Hard;
}

/// A parameter of an action; its value can have any type.
struct ActionParameter {
  std::string key;
  nlohmann::json value;
};

/// An action of a node, of an edge, or an instant action.
struct Action {
  std::string type;
  std::string id;
  BlockingType blocking = BlockingType::Hard;
  std::vector<ActionParameter> parameters;

  /// Returns a parameter; null if it is not given.
  [[nodiscard]] const nlohmann::json* parameter(const char* key) const noexcept;

  /// Returns a parameter as a text; none if it is missing or has another type.
  [[nodiscard]] std::optional<std::string> text(const char* key) const;

  /// Returns a parameter as a number; a text with a number counts, because some fleet controls
  /// send numbers so. None if it is missing or has another type.
  [[nodiscard]] std::optional<double> number(const char* key) const;
};

/// Reads an action. Blocking types that an instant action may not have are accepted, because fleet
/// controls of version 2 send them.
[[nodiscard]] Action read_action(FieldReader& reader);

/// Status of an action; the last two are final.
enum class ActionStatus : std::uint8_t { Waiting, Initializing, Running, Paused, Finished, Failed };

[[nodiscard]] constexpr const char* to_text(ActionStatus status) noexcept {
  switch (status) {
    case ActionStatus::Waiting:
      return "WAITING";
    case ActionStatus::Initializing:
      return "INITIALIZING";
    case ActionStatus::Running:
      return "RUNNING";
    case ActionStatus::Paused:
      return "PAUSED";
    case ActionStatus::Finished:
      return "FINISHED";
    case ActionStatus::Failed:
      return "FAILED";
  }
  return "FAILED";
}

/// An action with its status.
struct ActionState {
  std::string id;
  std::string type;
  ActionStatus status = ActionStatus::Waiting;
  std::string result;

  [[nodiscard]] bool done() const noexcept {
    return status == ActionStatus::Finished || status == ActionStatus::Failed;
  }
};

}  // namespace fairway::vda5050
