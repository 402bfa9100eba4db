// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/base_response.hpp"

namespace fairway {

void advance(BaseResponse& response,
             const CommandHistory& history,
             const BaseActuation& actuation,
             double from,
             double to) noexcept {
  constexpr double kPiece = 0.025;  // [s]
  constexpr double kMemory = 5.0;   // [s]; later it has answered to all that was sent
  const double start = std::max(from, to - kMemory);
  const double duration = to - start;
  const auto sent = [&](double time) { return history.sent(time); };
  const auto ramped = [&](double time) { return history.ramped(time); };
  const auto next_change = [&](double time) { return history.next_change(time); };
  const auto follow = [&](double Twist2::*member, const AxisActuation& axis) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(duration / kPiece - 1e-6)));
    const double h = duration / pieces;
    const auto quick = [&](double speed, double command, double time) {
      return quick_change(speed, command, axis, time);
    };
    const auto slow = [&](double speed, double command, double time) {
      return slow_change(speed, command, axis, time);
    };
    for (int i = 0; i < pieces && duration > 0.0; ++i) {
      const double begin = start + i * h - axis.delay;
      response.quick.*member =
          follow_axis(member, response.quick.*member, begin, begin + h, sent, next_change, quick)
              .end;
      if (axis.lag <= 0.0) continue;
      response.slow.*member =
          follow_axis(member, response.slow.*member, begin, begin + h, ramped, next_change, slow)
              .end;
    }
    if (axis.lag > 0.0) return;
    response.slow.*member =
        axis.delay == 0.0 ? history.reached(to).*member : history.ramped(to - axis.delay).*member;
  };
  follow(&Twist2::linear, actuation.linear);
  follow(&Twist2::angular, actuation.angular);
}

}  // namespace fairway
