// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/orca.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/simulation/people/uniform_random.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Returns whether `relative`, the velocity of the agent less that of the other, leads to a contact
// within the horizon. This is the slow and obvious form of the velocity obstacle.
bool hits(const Vector2d& apart, const Vector2d& relative, double radius, double horizon) {
  constexpr int kSamples = 300;
  for (int k = 1; k <= kSamples; ++k) {
    const double time = horizon * k / kSamples;
    if ((apart - time * relative).norm() < radius) return true;
  }
  return false;
}

// The point on the border of the velocity obstacle nearest to `relative`, by sampling directions.
Vector2d nearest_border(const Vector2d& apart,
                        const Vector2d& relative,
                        double radius,
                        double horizon) {
  const bool inside = hits(apart, relative, radius, horizon);
  double least = 1e9;
  Vector2d best = relative;
  for (int k = 0; k < 360; ++k) {
    const double angle = k * 2.0 * 3.14159265358979 / 360.0;
    const Vector2d along(std::cos(angle), std::sin(angle));
    double low = 0.0;
    double high = 4.0;
    if (hits(apart, relative + high * along, radius, horizon) == inside) continue;
    for (int i = 0; i < 16; ++i) {
      const double middle = 0.5 * (low + high);
      (hits(apart, relative + middle * along, radius, horizon) == inside ? low : high) = middle;
    }
    if (low < least) {
      least = low;
      best = relative + low * along;
    }
  }
  return best;
}

TEST(Orca, PrefersTheWantedVelocityWithoutPeopleNear) {
  OrcaAgent agent{.preferred = {0.6, 0.3}};
  EXPECT_EQ(orca_velocity(agent, {}, {}), agent.preferred);
  const std::vector<OrcaNeighbour> far{{.position = {10.0, 0.0}, .velocity = {-1.0, 0.0}}};
  EXPECT_EQ(orca_velocity(agent, far, {}), agent.preferred);
  agent.preferred = {3.0, 4.0};
  EXPECT_TRUE(orca_velocity(agent, {}, {}).isApprox(Vector2d(0.6, 0.8), 1e-12));
}

TEST(Orca, TakesHalfOfTheLeastChangeThatAvoidsAContact) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  std::uniform_real_distribution<double> speed(-1.0, 1.0);
  int avoided = 0;
  for (int i = 0; i < 25; ++i) {
    OrcaAgent agent{.velocity = {speed(random), speed(random)}, .speed_max = 10.0};
    agent.preferred = agent.velocity;
    OrcaNeighbour other{.position = {place(random), place(random)}};
    if (other.position.norm() < 0.8) continue;
    // Towards the agent, more or less.
    other.velocity = agent.velocity - 0.6 * other.position.normalized() +
                     0.2 * Vector2d(speed(random), speed(random));
    const Vector2d relative = agent.velocity - other.velocity;
    const Vector2d chosen = orca_velocity(agent, {&other, 1}, {.horizon = 5.0});
    if (!hits(other.position, relative, 0.6, 5.0)) continue;
    ++avoided;
    const Vector2d border = nearest_border(other.position, relative, 0.6, 5.0);
    EXPECT_LT((chosen - agent.velocity - 0.5 * (border - relative)).norm(), 0.03) << i;
  }
  EXPECT_GT(avoided, 3);
}

TEST(Orca, IsTheNearestVelocityThatAllNeighboursAllow) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  std::uniform_real_distribution<double> speed(-1.0, 1.0);
  for (int i = 0; i < 50; ++i) {
    OrcaAgent agent{.velocity = {speed(random), speed(random)},
                    .preferred = {speed(random), speed(random)}};
    std::vector<OrcaNeighbour> others(4);
    for (OrcaNeighbour& other : others)
      other = {.position = {place(random), place(random)},
               .velocity = {speed(random), speed(random)}};
    const Vector2d chosen = orca_velocity(agent, others, {});
    EXPECT_LE(chosen.norm(), 1.0 + 1e-9);
    // Each neighbour alone gives its half-plane: the line through q along d.
    const auto allowed = [&](const Vector2d& velocity, double slack) {
      for (const OrcaNeighbour& other : others) {
        OrcaAgent probe = agent;
        probe.speed_max = 100.0;
        probe.preferred = velocity;
        if ((orca_velocity(probe, {&other, 1}, {}) - velocity).norm() > slack) return false;
      }
      return true;
    };
    if (!allowed(chosen, 1e-6)) continue;  // crowded: no velocity is allowed by all
    const double distance = (chosen - agent.preferred).norm();
    for (int k = 0; k < 200; ++k) {
      const Vector2d other(speed(random), speed(random));
      if (other.norm() > 1.0 || (other - agent.preferred).norm() > distance - 1e-6) continue;
      EXPECT_FALSE(allowed(other, 0.0)) << i;
    }
  }
}

TEST(Orca, ViolatesLeastWhereNothingIsAllowed) {
  // Enclosed by four people who close in: the best is to stay in the middle.
  OrcaAgent agent{.preferred = {1.0, 0.0}};
  std::vector<OrcaNeighbour> others;
  for (const Vector2d& side : {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1)})
    others.push_back({.position = 0.65 * side, .velocity = -0.5 * side});
  const Vector2d chosen = orca_velocity(agent, others, {});
  EXPECT_LT(chosen.norm(), 1e-6);
  EXPECT_TRUE(std::isfinite(chosen.x()));
}

TEST(Orca, IsFiniteAtTheSamePlace) {
  const OrcaNeighbour same{};
  const Vector2d chosen = orca_velocity({.preferred = {1.0, 0.0}}, {&same, 1}, {});
  EXPECT_TRUE(std::isfinite(chosen.x()) && std::isfinite(chosen.y()));
  EXPECT_GE(cross(chosen, chosen), 0.0);
}

TEST(UniformRandom, DrawsTheNumbersOfNumpy) {
  UniformRandom random(1000);  // numpy.random.seed(1000); numpy.random.random()
  EXPECT_DOUBLE_EQ(random.unit(), 0.6535895854646095);
  EXPECT_DOUBLE_EQ(random.unit(), 0.11500694312440574);
}

}  // namespace
}  // namespace fairway
