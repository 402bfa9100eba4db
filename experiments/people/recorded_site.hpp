// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "experiments/people/recorded.hpp"
#include "fairway/prediction/entrances.hpp"

namespace fairway {

/// What a robot remembers of the place of a recording: where people appeared up to now.
class RecordedSite {
 public:
  /// @param recording  Must outlive this.
  RecordedSite(const PeopleRecording& recording, const RecordedCase& task);

  /// Notes who appeared up to and with `frame`: people who were not in the frame before. The first
  /// frame of a recording shows people who were there already.
  void watch_until(int frame);

  [[nodiscard]] const EntranceMap& entrances() const noexcept { return entrances_; }

 private:
  const PeopleRecording* recording_;
  std::map<int, std::vector<RecordedPlace>>::const_iterator next_;
  EntranceMap entrances_;
};

}  // namespace fairway
