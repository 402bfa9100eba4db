// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/paper/studies/study_options.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/metrics.hpp"

namespace fairway::reproduction {

/// The controllers of the robots in Case 3.
enum class ExchangeKind : std::uint8_t {
  Ismpc,  ///< the paper's settings: R_o = 0.8 m between centres, gamma = 5
  Ours,   ///< our default settings; robots publish their intended motions
};
inline constexpr std::size_t kExchangeKinds = 2;
inline constexpr std::array kComparedExchanges = {ExchangeKind::Ismpc, ExchangeKind::Ours};
inline constexpr std::size_t kExchangeRobots = 4;
inline constexpr double kExchangeRadius = 4.0;  ///< of the circle of starts [m]

[[nodiscard]] const char* to_text(ExchangeKind kind) noexcept;

/// Distance between centres that the controller keeps: both radii and its margin [m].
[[nodiscard]] double keep_out_distance(const Settings& settings) noexcept;

/// All robots at one moment.
struct ExchangeMoment {
  double time = 0.0;
  std::array<Pose2, kExchangeRobots> poses;
  std::array<std::vector<Eigen::Vector2d>, kExchangeRobots> plans;  ///< predicted trajectories;
                                                                    ///< empty without a plan
};

/// One run.
struct Exchange {
  Settings settings;
  std::array<Eigen::Vector2d, kExchangeRobots> goals;
  bool all_reached = false;
  int contacts = 0;             ///< robots that touched an obstacle or a robot
  double time = 0.0;            ///< until the last robot arrived, or the limit [s]
  double min_separation = 0.0;  ///< between bodies [m]
  double bound = 0.0;           ///< time of the longest straight path at full speed [s]
  Quantiles cycle;              ///< per control cycle [s]
  std::vector<ExchangeMoment> moments;

  /// The distance from one centre to the nearest other at a moment [m].
  [[nodiscard]] static double nearest(const ExchangeMoment& moment, std::size_t robot);
};

/// The runs of one seed with every kind.
using ExchangeComparison = std::array<Exchange, kExchangeKinds>;

/// Four robots on a circle in open space, each with its goal on the opposite side. Starts are
/// shifted by up to 0.05 m in x and y and turned by up to 0.1 rad, so that nothing is exactly
/// symmetric.
[[nodiscard]] Scenario exchange_scenario(std::uint64_t seed,
                                         ExchangeKind kind,
                                         const Settings& ours = {});

[[nodiscard]] Exchange exchange(const Scenario& scenario, const StudyOptions& options);

/// Compares `runs` runs, starting at `options.seed`. @pre runs > 0.
[[nodiscard]] std::vector<ExchangeComparison> compare_exchanges(int runs,
                                                                const StudyOptions& options);

}  // namespace fairway::reproduction
