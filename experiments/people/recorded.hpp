// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Where a recorded person is in one frame.
struct RecordedPlace {
  int person = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
};

/// A recording of walking people: who is where at each frame of 0.1 s.
struct PeopleRecording {
  static constexpr double kFrame = 0.1;  ///< time between two frames [s]
  std::map<int, std::vector<RecordedPlace>> frames;

  [[nodiscard]] const std::vector<RecordedPlace>& at(int frame) const {
    static const std::vector<RecordedPlace> kNone;
    const auto found = frames.find(frame);
    return found == frames.end() ? kNone : found->second;
  }
};

/// A task among recorded people.
struct RecordedCase {
  std::string scene;
  int number = 0;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();   ///< [m]
  int start_frame = 0;
  double time_limit = 0.0;  ///< [s]
};

}  // namespace fairway
