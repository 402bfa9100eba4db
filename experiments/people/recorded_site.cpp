// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/recorded_site.hpp"

#include <algorithm>

namespace fairway {

namespace {

constexpr double kAround = 6.0;  // of the region between start and goal [m]

}  // namespace

RecordedSite::RecordedSite(const PeopleRecording& recording, const RecordedCase& task)
    : recording_(&recording),
      next_(recording.frames.begin()),
      entrances_(task.start.cwiseMin(task.goal).array() - kAround,
                 task.start.cwiseMax(task.goal).array() + kAround) {
  watch_until(task.start_frame);
}

void RecordedSite::watch_until(int frame) {
  for (; next_ != recording_->frames.end() && next_->first <= frame; ++next_) {
    entrances_.observe(PeopleRecording::kFrame);
    if (next_ == recording_->frames.begin()) continue;
    const std::vector<RecordedPlace>& before = recording_->at(next_->first - 1);
    for (const RecordedPlace& place : next_->second) {
      const bool is_new = std::none_of(before.begin(), before.end(), [&](const RecordedPlace& old) {
        return old.person == place.person;
      });
      if (is_new) entrances_.note(place.position);
    }
  }
}

}  // namespace fairway
