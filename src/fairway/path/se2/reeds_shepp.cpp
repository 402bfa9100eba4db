// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/reeds_shepp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "fairway/base/contract.hpp"
#include "fairway/geometry/angle.hpp"

// The eight base formulas of Reeds and Shepp (1990), section 8. The title is "Optimal paths for a
// car that goes both forwards and backwards". The rest follows by time flip, reflection and
// reversal.

namespace fairway {

namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
constexpr double kSkin = 1e-10;

struct Goal {
  double x;
  double y;
  double phi;
};

struct Lengths {
  double t;
  double u;
  double v;
};
using Found = std::optional<Lengths>;

struct Polar {
  double r;
  double theta;
};

double length_of(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

Polar polar(double x, double y) noexcept { return {length_of(x, y), std::atan2(y, x)}; }

// Formula 8.1: L+ S+ L+.
Found left_straight_left(const Goal& g) noexcept {
  const Polar p = polar(g.x - std::sin(g.phi), g.y - 1.0 + std::cos(g.phi));
  const double v = wrap_to_pi(g.phi - p.theta);
  if (p.theta < -kSkin || v < -kSkin) return std::nullopt;
  return Lengths{p.theta, p.r, v};
}

// Formula 8.2: L+ S+ R+.
Found left_straight_right(const Goal& g) noexcept {
  const Polar p = polar(g.x + std::sin(g.phi), g.y - 1.0 - std::cos(g.phi));
  const double square = p.r * p.r - 4.0;
  if (square < 0.0) return std::nullopt;
  const double u = std::sqrt(square);
  const double t = wrap_to_pi(p.theta + std::atan2(2.0, u));
  const double v = wrap_to_pi(t - g.phi);
  if (t < -kSkin || v < -kSkin) return std::nullopt;
  return Lengths{t, u, v};
}

// Formulas 8.3 and 8.4: L+ R- L.
Found left_right_left(const Goal& g) noexcept {
  const Polar p = polar(g.x - std::sin(g.phi), g.y - 1.0 + std::cos(g.phi));
  if (p.r > 4.0) return std::nullopt;
  const double u = -2.0 * std::asin(0.25 * p.r);
  const double t = wrap_to_pi(p.theta + 0.5 * u + kHalfTurn);
  if (t < -kSkin || u > kSkin) return std::nullopt;
  return Lengths{t, u, wrap_to_pi(g.phi - t + u)};
}

struct TauOmega {
  double tau;
  double omega;
};

TauOmega tau_omega(double u, double v, double xi, double eta, double phi) noexcept {
  const double delta = wrap_to_pi(u - v);
  const double a = std::sin(u) - std::sin(delta);
  const double b = std::cos(u) - std::cos(delta) - 1.0;
  const double first = std::atan2(eta * a - xi * b, xi * a + eta * b);
  const double second = 2.0 * (std::cos(delta) - std::cos(v) - std::cos(u)) + 3.0;
  const double tau = wrap_to_pi(second < 0.0 ? first + kHalfTurn : first);
  return {tau, wrap_to_pi(tau - u + v - phi)};
}

// Formula 8.7: L+ R+u L-u R-.
Found left_right_left_right_turned(const Goal& g) noexcept {
  const double xi = g.x + std::sin(g.phi);
  const double eta = g.y - 1.0 - std::cos(g.phi);
  const double rho = 0.25 * (2.0 + length_of(xi, eta));
  if (rho > 1.0) return std::nullopt;
  const double u = std::acos(rho);
  const TauOmega r = tau_omega(u, -u, xi, eta, g.phi);
  if (r.tau < -kSkin || r.omega > kSkin) return std::nullopt;
  return Lengths{r.tau, u, r.omega};
}

// Formula 8.8: L+ R-u L-u R+.
Found left_right_left_right(const Goal& g) noexcept {
  const double xi = g.x + std::sin(g.phi);
  const double eta = g.y - 1.0 - std::cos(g.phi);
  const double rho = (20.0 - xi * xi - eta * eta) / 16.0;
  if (rho < 0.0 || rho > 1.0) return std::nullopt;
  const double u = -std::acos(rho);
  const TauOmega r = tau_omega(u, u, xi, eta, g.phi);
  if (u < -kQuarterTurn || r.tau < -kSkin || r.omega < -kSkin) return std::nullopt;
  return Lengths{r.tau, u, r.omega};
}

// Formula 8.9: L+ R- S- L-.
Found left_right_straight_left(const Goal& g) noexcept {
  const Polar p = polar(g.x - std::sin(g.phi), g.y - 1.0 + std::cos(g.phi));
  if (p.r < 2.0) return std::nullopt;
  const double r = std::sqrt(p.r * p.r - 4.0);
  const Lengths l{wrap_to_pi(p.theta + std::atan2(r, -2.0)), 2.0 - r, 0.0};
  const double v = wrap_to_pi(g.phi - kQuarterTurn - l.t);
  if (l.t < -kSkin || l.u > kSkin || v > kSkin) return std::nullopt;
  return Lengths{l.t, l.u, v};
}

// Formula 8.10: L+ R- S- R-.
Found left_right_straight_right(const Goal& g) noexcept {
  const double xi = g.x + std::sin(g.phi);
  const double eta = g.y - 1.0 - std::cos(g.phi);
  const Polar p = polar(-eta, xi);
  if (p.r < 2.0) return std::nullopt;
  const double v = wrap_to_pi(p.theta + kQuarterTurn - g.phi);
  if (p.theta < -kSkin || 2.0 - p.r > kSkin || v > kSkin) return std::nullopt;
  return Lengths{p.theta, 2.0 - p.r, v};
}

// Formula 8.11: L+ R- S- L- R+.
Found left_right_straight_left_right(const Goal& g) noexcept {
  const double xi = g.x + std::sin(g.phi);
  const double eta = g.y - 1.0 - std::cos(g.phi);
  const Polar p = polar(xi, eta);
  if (p.r < 2.0) return std::nullopt;
  const double u = 4.0 - std::sqrt(p.r * p.r - 4.0);
  if (u > kSkin) return std::nullopt;
  const double t = wrap_to_pi(std::atan2((4.0 - u) * xi - 2.0 * eta, -2.0 * xi + (u - 4.0) * eta));
  const double v = wrap_to_pi(t - g.phi);
  if (t < -kSkin || v < -kSkin) return std::nullopt;
  return Lengths{t, u, v};
}

// How the lengths t, u, v of a formula make up a word. It says which of them are used, times which
// factor, or a quarter turn backwards, and to which side each piece turns.
struct Piece {
  char length;  // 't', 'u', 'v', 'U' for -u, 'q' for a quarter turn backwards
  int turn;
};
struct Family {
  Found (*formula)(const Goal&) noexcept;
  bool backwards;  // solved for the reversed path; pieces are listed in driving order
  int count;
  std::array<Piece, 5> pieces;
};

constexpr std::array<Family, 11> kFamilies{{
    {left_straight_left, false, 3, {{{'t', 1}, {'u', 0}, {'v', 1}}}},
    {left_straight_right, false, 3, {{{'t', 1}, {'u', 0}, {'v', -1}}}},
    {left_right_left, false, 3, {{{'t', 1}, {'u', -1}, {'v', 1}}}},
    {left_right_left, true, 3, {{{'v', 1}, {'u', -1}, {'t', 1}}}},
    {left_right_left_right_turned, false, 4, {{{'t', 1}, {'u', -1}, {'U', 1}, {'v', -1}}}},
    {left_right_left_right, false, 4, {{{'t', 1}, {'u', -1}, {'u', 1}, {'v', -1}}}},
    {left_right_straight_left, false, 4, {{{'t', 1}, {'q', -1}, {'u', 0}, {'v', 1}}}},
    {left_right_straight_right, false, 4, {{{'t', 1}, {'q', -1}, {'u', 0}, {'v', -1}}}},
    {left_right_straight_left, true, 4, {{{'v', 1}, {'u', 0}, {'q', -1}, {'t', 1}}}},
    {left_right_straight_right, true, 4, {{{'v', -1}, {'u', 0}, {'q', -1}, {'t', 1}}}},
    {left_right_straight_left_right,
     false,
     5,
     {{{'t', 1}, {'q', -1}, {'u', 0}, {'q', 1}, {'v', -1}}}},
}};

double length_of(char which, const Lengths& l) noexcept {
  switch (which) {
    case 't':
      return l.t;
    case 'u':
      return l.u;
    case 'U':
      return -l.u;
    case 'v':
      return l.v;
    default:
      return -kQuarterTurn;
  }
}

bool ends_at(const ReedsSheppWord& word, const Goal& goal) noexcept {
  double x = 0.0;
  double y = 0.0;
  double phi = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(word.count); ++i) {
    const double way = word.lengths[i];
    const int turn = word.turns[i];
    if (turn == 0) {
      x += way * std::cos(phi);
      y += way * std::sin(phi);
      continue;
    }
    const double next = phi + turn * way;
    x += turn * (std::sin(next) - std::sin(phi));
    y -= turn * (std::cos(next) - std::cos(phi));
    phi = next;
  }
  constexpr double kExact = 1e-7;
  return std::abs(x - goal.x) < kExact && std::abs(y - goal.y) < kExact &&
         std::abs(wrap_to_pi(phi - goal.phi)) < kExact;
}

// Calls use(word) for every word of every family, in all four symmetries. With `check`, only for
// those that end at the goal.
template <typename Use>
void for_each_word(const Goal& goal, Use&& use) {
  const double c = std::cos(goal.phi);
  const double s = std::sin(goal.phi);
  const Goal back{goal.x * c + goal.y * s, goal.x * s - goal.y * c, goal.phi};
  for (const Family& family : kFamilies) {
    const Goal& from = family.backwards ? back : goal;
    for (int symmetry = 0; symmetry < 4; ++symmetry) {
      const double flip = (symmetry & 1) != 0 ? -1.0 : 1.0;    // time flip
      const double mirror = (symmetry & 2) != 0 ? -1.0 : 1.0;  // reflection
      const Found lengths =
          family.formula({flip * from.x, mirror * from.y, flip * mirror * from.phi});
      if (!lengths) continue;
      ReedsSheppWord word;
      word.count = family.count;
      for (std::size_t i = 0; i < static_cast<std::size_t>(family.count); ++i) {
        word.lengths[i] = flip * length_of(family.pieces[i].length, *lengths);
        word.turns[i] = static_cast<int>(mirror) * family.pieces[i].turn;
        word.length += std::abs(word.lengths[i]);
      }
      use(word);
    }
  }
}

Goal goal_in_radii(const Pose2& from, const Pose2& to, double radius) noexcept {
  const Eigen::Vector2d way = inverse_transform(from, to.position) / radius;
  return {way.x(), way.y(), shortest_turn(from.heading, to.heading)};
}

}  // namespace

void reeds_shepp_words(const Pose2& from,
                       const Pose2& to,
                       double radius,
                       std::vector<ReedsSheppWord>& words) {
  FAIRWAY_EXPECTS(radius > 0.0);
  words.clear();
  const Goal goal = goal_in_radii(from, to, radius);
  for_each_word(goal, [&](const ReedsSheppWord& word) {
    if (ends_at(word, goal)) words.push_back(word);
  });
}

double reeds_shepp_length(const Pose2& from, const Pose2& to, double radius) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for_each_word(goal_in_radii(from, to, radius),
                [&](const ReedsSheppWord& word) { least = std::min(least, word.length); });
  return radius * least;
}

}  // namespace fairway
