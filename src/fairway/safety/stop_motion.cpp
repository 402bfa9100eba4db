// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/stop_motion.hpp"

#include <cmath>

namespace fairway {

namespace {

constexpr double kSameInstant = 1e-9;    // [s]
constexpr double kLongestPiece = 0.025;  // [s]
constexpr double kStopped = 2e-3;     // [m/s] or [rad/s]; what a lag leaves is counted as distance
constexpr double kLongestTail = 8.0;  // [s]

Twist2 between(const Twist2& from, const Twist2& to, double share) noexcept {
  return {.linear = from.linear + share * (to.linear - from.linear),
          .angular = from.angular + share * (to.angular - from.angular)};
}

int pieces_in(double duration) noexcept {
  return std::max(1, static_cast<int>(std::ceil(duration / kLongestPiece - 1e-6)));
}

}  // namespace

MotionFamily::MotionFamily(const StopManoeuvre& manoeuvre) noexcept : m_(manoeuvre) {
  if (m_.ramp <= 0.0) m_.ramp = m_.period;
  m_.hold = std::max(m_.hold > 0.0 ? m_.hold : m_.period, m_.ramp);
  exact_ = m_.actuation == nullptr || m_.actuation->is_exact();
  response_ =
      m_.response != nullptr ? *m_.response : BaseResponse{.slow = m_.current, .quick = m_.current};
  least_ = greatest_ = m_.command;
  from_ = m_.current;
  to_ = m_.command;
  end_ = m_.ramp;
  pieces_ = pieces_in(m_.ramp);
  h_ = m_.ramp / pieces_;
}

bool MotionFamily::next(StopPiece& piece) noexcept {
  if (piece_ == pieces_ && !begin_segment()) return false;
  const BaseResponse before = response_;
  const double share = (piece_ + 0.5) / pieces_;
  Twist2 slow = between(from_, to_, share);
  Twist2 quick;
  if (!exact_) {
    follow_late(&Twist2::linear, m_.actuation->linear, slow, quick);
    follow_late(&Twist2::angular, m_.actuation->angular, slow, quick);
  } else if (m_.actuation != nullptr) {
    const Twist2 sent = sent_at(start_ + (piece_ + 0.5) * h_);
    const SpeedChange linear =
        quick_change(response_.quick.linear, sent.linear, m_.actuation->linear, h_);
    const SpeedChange angular =
        quick_change(response_.quick.angular, sent.angular, m_.actuation->angular, h_);
    response_.quick = {.linear = linear.end, .angular = angular.end};
    quick = {.linear = linear.mean, .angular = angular.mean};
  }
  piece.mean = slow;
  piece.duration = h_;
  piece.fastest = fastest_in_piece(before);
  if (m_.actuation != nullptr) deviate(quick, slow, h_, piece);
  if (m_.later + m_.earlier > 0.0) spread(slow, h_, piece);
  ++piece_;
  return true;
}

// Within a piece a member changes its speed evenly, or ever more slowly. A member that follows a
// ramp late stays between its speed and the ramp.
double MotionFamily::fastest_in_piece(const BaseResponse& before) const noexcept {
  const auto greatest = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
  if (exact_) {
    const double first = between(from_, to_, static_cast<double>(piece_) / pieces_).linear;
    const double last = between(from_, to_, (piece_ + 1.0) / pieces_).linear;
    const double slow = greatest(first, last);
    if (m_.actuation == nullptr) return slow;
    return std::max(slow, greatest(before.quick.linear, response_.quick.linear));
  }
  return std::max(greatest(before.slow.linear, response_.slow.linear),
                  greatest(before.quick.linear, response_.quick.linear));
}

// One axis with its delay and lag: the mean speeds of both members in this piece.
void MotionFamily::follow_late(double Twist2::*member,
                               const AxisActuation& axis,
                               Twist2& slow,
                               Twist2& quick) noexcept {
  const double begin = start_ + piece_ * h_ - axis.delay;
  const auto next = [this](double time) { return next_change(time); };
  const SpeedChange slow_part = follow_axis(
      member, response_.slow.*member, begin, begin + h_,
      [this](double time) { return ramped_at(time); }, next,
      [&](double speed, double command, double time) {
        return slow_change(speed, command, axis, time);
      });
  const SpeedChange quick_part = follow_axis(
      member, response_.quick.*member, begin, begin + h_,
      [this](double time) { return sent_at(time); }, next,
      [&](double speed, double command, double time) {
        return quick_change(speed, command, axis, time);
      });
  response_.slow.*member = slow_part.end;
  response_.quick.*member = quick_part.end;
  slow.*member = slow_part.mean;
  quick.*member = quick_part.mean;
}

// The quick base drives along a path that is turned against the slow one's by its gain in heading.
// It is further along this path by its gain in speed.
void MotionFamily::deviate(const Twist2& quick,
                           const Twist2& slow,
                           double h,
                           StopPiece& piece) noexcept {
  const double before = std::abs(turned_);
  along_ += (quick.linear - slow.linear) * h;
  turned_ += (quick.angular - slow.angular) * h;
  const double turned = std::max(before, std::abs(turned_));
  const double speed = std::max(std::abs(quick.linear), std::abs(slow.linear));
  aside_ += speed * h * turned;
  piece.ahead = std::max(0.0, slow.linear >= 0.0 ? along_ : -along_);
  piece.apart = std::abs(along_);
  piece.aside = aside_;
  piece.turned = turned;
}

// A base that follows `delay` later has gained, at each time, at most `delay` times what its speed
// has changed by since. Lateness can begin at any time, and so it can be further along the path
// than this one without being turned further.
void MotionFamily::spread(const Twist2& slow, double h, StopPiece& piece) noexcept {
  least_ = {.linear = std::min(least_.linear, slow.linear),
            .angular = std::min(least_.angular, slow.angular)};
  greatest_ = {.linear = std::max(greatest_.linear, slow.linear),
               .angular = std::max(greatest_.angular, slow.angular)};
  const double both = m_.later + m_.earlier;
  const double slower =
      slow.linear >= 0.0 ? greatest_.linear - slow.linear : slow.linear - least_.linear;
  const double turn =
      both * std::max(greatest_.angular - slow.angular, slow.angular - least_.angular);
  // What is gained on a path that still turns is not all gained in the direction of its end.
  aside_ += std::abs(slow.angular) * h * both * slower;
  between_ += std::abs(slow.linear) * h * turn;
  piece.ahead += m_.later * slower;
  piece.aside = aside_;
  piece.turned_between = turn;
  piece.aside_between = between_;
}

// @return false where the motion ends.
bool MotionFamily::begin_segment() noexcept {
  ++segment_;
  piece_ = 0;
  start_ = end_;
  from_ = to_;
  if (segment_ == 0) {
    if (m_.hold - start_ > kSameInstant) {
      end_ = m_.hold;
      pieces_ = pieces_in(end_ - start_);
      h_ = (end_ - start_) / pieces_;
      return true;
    }
    ++segment_;
  }
  if (segment_ > static_cast<int>(m_.stop.size())) return begin_tail();
  to_ = stop_command(segment_);
  end_ = start_ + m_.period;
  pieces_ = pieces_in(m_.period);
  h_ = m_.period / pieces_;
  return true;
}

// After the last command the delay and the lag have still to pass.
bool MotionFamily::begin_tail() noexcept {
  if (exact_) return false;
  to_ = stop_command(static_cast<int>(m_.stop.size()));
  const double last = std::max(m_.hold, m_.hold + m_.period * static_cast<double>(m_.stop.size()));
  const auto moves = [](const Twist2& twist) {
    return std::abs(twist.linear) > kStopped || std::abs(twist.angular) > kStopped;
  };
  const bool waits = start_ < last + m_.actuation->longest_delay() - kSameInstant;
  const bool to_standstill = to_.linear == 0.0 && to_.angular == 0.0;
  if (!waits && !(to_standstill && (moves(response_.slow) || moves(response_.quick)) &&
                  start_ < last + kLongestTail)) {
    return false;
  }
  end_ = start_ + m_.period;
  pieces_ = pieces_in(m_.period);
  h_ = m_.period / pieces_;
  return true;
}

// Command `k` of the stop; 0 is the one before it, and the last one stays.
Twist2 MotionFamily::stop_command(int k) const noexcept {
  const int last = std::min(k, static_cast<int>(m_.stop.size()));
  return last <= 0 ? m_.command : m_.stop[static_cast<std::size_t>(last - 1)];
}

// What a slow base without delay has ramped to.
Twist2 MotionFamily::ramped_at(double time) const noexcept {
  if (time < 0.0) return m_.history != nullptr ? m_.history->ramped(m_.time + time) : m_.current;
  if (time < m_.ramp) return between(m_.current, m_.command, time / m_.ramp);
  if (time < m_.hold) return m_.command;
  const double index = (time - m_.hold) / m_.period;
  const int k = static_cast<int>(index);
  return between(stop_command(k), stop_command(k + 1), index - k);
}

// The command that a quick base without delay has.
Twist2 MotionFamily::sent_at(double time) const noexcept {
  if (time < 0.0) return m_.history != nullptr ? m_.history->sent(m_.time + time) : m_.current;
  if (time < m_.hold) return m_.command;
  const double index = (time - m_.hold) / m_.period;
  const int k = static_cast<int>(index) + 1;
  if (!m_.irregular) return stop_command(k);
  return between(stop_command(k), stop_command(k + 1), index - (k - 1));
}

// When either of the two changes next.
double MotionFamily::next_change(double time) const noexcept {
  if (time < -kSameInstant) {
    if (m_.history == nullptr) return 0.0;
    return std::min(0.0, m_.history->next_change(m_.time + time) - m_.time);
  }
  if (time < m_.ramp - kSameInstant) return m_.ramp;
  if (time < m_.hold - kSameInstant) return m_.hold;
  const double index = std::floor((time - m_.hold + kSameInstant) / m_.period);
  return m_.hold + (index + 1.0) * m_.period;
}

}  // namespace fairway
