// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/geometry/robot_settings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/mpc_settings.hpp"
#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::io {

// Benchmark instances of Eq. (15) as text, one per line, with fields separated by spaces:
//   id class nobs  x0 y0 psi0  g1x g1y g1psi  g2x g2y g2psi  Px Py theta  xl yl xr yr
//   [ox oy vx vy] * nobs
// and results in the same form:  id status iterations time_us  u0 r0 ... u9 r9
// Empty lines are skipped.

/// One instance as written in its file; everything else comes from the paper's preset.
struct OcpInstance {
  int id = 0;
  std::string kind;                       ///< free, dyn, tight, infeas, or any other word
  Pose2 start;                            ///< eta_t
  Pose2 current_target;                   ///< eta_cg1, heading not wrapped
  Pose2 next_target;                      ///< eta_cg2, heading not wrapped
  OrientedRectangle rectangle;            ///< as grown, not yet moved inward
  std::vector<MovingObstacle> obstacles;  ///< at most kMaxObstacles, radius Ro
};

/// One line of a result file.
struct OcpResult {
  int id = 0;
  int status = 0;  ///< 0: converged and feasible; otherwise the number of a SolveStatus
  int iterations = 0;
  double time_us = 0.0;          ///< [us]
  std::vector<Twist2> commands;  ///< kOcpHorizon of them
};

inline constexpr int kOcpHorizon = 10;  ///< commands of a result

/// The problem of an instance: the paper's preset, Ro = 0.8 m, Delta_s = 0.3 m.
[[nodiscard]] ControlProblem control_problem(const OcpInstance& instance) noexcept;

/// The same with other weights and limits. @pre mpc.horizon is kOcpHorizon.
[[nodiscard]] ControlProblem control_problem(const OcpInstance& instance,
                                             const MpcSettings& mpc,
                                             const RobotSettings& robot) noexcept;

/// Parses instances; `name` is the file in error messages. A file without instances is an error.
[[nodiscard]] Expected<std::vector<OcpInstance>> parse_ocp_instances(std::string_view text,
                                                                     const std::string& name);
[[nodiscard]] Expected<std::vector<OcpInstance>> read_ocp_instances(const std::string& path);

[[nodiscard]] Expected<std::vector<OcpResult>> parse_ocp_results(std::string_view text,
                                                                 const std::string& name);
[[nodiscard]] Expected<std::vector<OcpResult>> read_ocp_results(const std::string& path);

/// Formats numbers so that reading gives the same bits, except times, which have three decimals.
[[nodiscard]] std::string format_ocp_results(std::span<const OcpResult> results);

/// Writes the file completely or not at all: a temporary file beside `path`, then a rename.
[[nodiscard]] Expected<void> write_ocp_results(const std::string& path,
                                               std::span<const OcpResult> results);

}  // namespace fairway::io
