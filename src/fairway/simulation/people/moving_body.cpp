// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/moving_body.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/base/contract.hpp"

namespace fairway {

bool MovingBody::is_there(double time) const {
  FAIRWAY_EXPECTS(!key_frames.empty());
  return !passing || loop || (time >= key_frames.front().time && time <= key_frames.back().time);
}

MovingObstacle MovingBody::at(double time) const {
  FAIRWAY_EXPECTS(!key_frames.empty());
  const double first = key_frames.front().time;
  const double period = key_frames.back().time - first;
  if (loop && period > 0.0 && time > first) time = first + std::fmod(time - first, period);
  const auto next =
      std::upper_bound(key_frames.begin(), key_frames.end(), time,
                       [](double t, const KeyFrame& frame) { return t < frame.time; });
  MovingObstacle body{.position = {}, .velocity = {}, .radius = is_there(time) ? radius : 0.0};
  body.velocity.setZero();
  if (next == key_frames.begin()) {
    body.position = next->position;
  } else if (next == key_frames.end()) {
    body.position = key_frames.back().position;
  } else {
    const KeyFrame& last = *(next - 1);
    body.velocity = (next->position - last.position) / (next->time - last.time);
    body.position = last.position + (time - last.time) * body.velocity;
  }
  return body;
}

std::vector<MovingBody> replayed(const std::vector<MovingBody>& recorded,
                                 double begin,
                                 double duration) {
  std::vector<MovingBody> seen;
  for (const MovingBody& body : recorded) {
    if (body.passing &&
        (body.key_frames.back().time < begin || body.key_frames.front().time > begin + duration)) {
      continue;
    }
    seen.push_back(body);
    for (MovingBody::KeyFrame& frame : seen.back().key_frames)
      frame.time -= begin;
  }
  return seen;
}

}  // namespace fairway
