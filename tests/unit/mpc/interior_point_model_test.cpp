// SPDX-License-Identifier: Apache-2.0
// The solver's own, fast expressions against evaluation.hpp and against differences.
#include <cmath>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "fairway/mpc/derivatives.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point_elastic_rows.hpp"
#include "fairway/mpc/interior_point_hard_rows.hpp"
#include "fairway/mpc/interior_point_line_search.hpp"
#include "fairway/mpc/interior_point_setup.hpp"
#include "fairway/mpc/interior_point_trajectory.hpp"
#include "fairway/mpc/riccati.hpp"
#include "support/central_difference.hpp"
#include "support/random_control_problem.hpp"

namespace fairway::interior_point {
namespace {

using Eigen::VectorXd;

constexpr double kMu = 0.7;

std::size_t size_of(const ControlProblem& problem) {
  return static_cast<std::size_t>(problem.horizon);
}

VectorXd commands_of(const Workspace& w, const Point& point) {
  const auto n = static_cast<Eigen::Index>(w.horizon);
  VectorXd v(2 * n);
  v << Eigen::Map<const VectorXd>(point.linear.data(), n),
      Eigen::Map<const VectorXd>(point.angular.data(), n);
  return v;
}

void set_commands(const Workspace& w, const VectorXd& v, Point& point) {
  for (std::size_t k = 0; k < w.horizon; ++k) {
    point.linear[k] = v[static_cast<Eigen::Index>(k)];
    point.angular[k] = v[static_cast<Eigen::Index>(k + w.horizon)];
  }
}

/// The iteration at its beginning, with duals that are anything but central.
void begin(const ControlProblem& problem, test::Random& random, Workspace& w) {
  load_problem(problem, w);
  InitialGuess guess;
  guess.count = problem.horizon;
  for (Twist2& command : guess.commands)
    command = test::random_command(random, problem);
  load_guess(guess, w, *w.now);
  evaluate(w, *w.now);
  measure_room(w.hard, w.horizon, *w.now);
  start_hard_rows(*w.now, kMu, w.hard);
  start_elastic_rows(w, kMu);
  for (std::size_t i = 0; i < w.elastic.count; ++i) {
    w.elastic.dual[i] *= random.uniform(0.5, 2.0);
    w.elastic.excess_dual[i] = problem.violation_weight - w.elastic.dual[i];
    w.now->excess[i] *= random.uniform(0.5, 2.0);
  }
  for (std::size_t i = 0; i < w.hard.count; ++i)
    w.hard.dual_low[i] *= random.uniform(0.5, 2.0);
  linearise_hard_rows(*w.now, kMu, w.hard);
  linearise_elastic_rows(w);
  linearise_trajectory(w);
}

template <typename Check>
void for_random_problems(std::uint64_t seed, int count, Check&& check) {
  const auto w = std::make_unique<Workspace>();
  test::Random random(seed);
  for (int trial = 0; trial < count; ++trial) {
    SCOPED_TRACE(trial);
    const ControlProblem problem = test::random_control_problem(random);
    begin(problem, random, *w);
    check(problem, random, *w);
  }
}

TEST(InteriorPointModel, PosesCostAndRowsAreThoseOfTheEvaluation) {
  for_random_problems(111, 300, [](const ControlProblem& problem, auto&, Workspace& w) {
    std::vector<Twist2> commands(size_of(problem));
    for (std::size_t k = 0; k < commands.size(); ++k)
      commands[k] = {.linear = w.now->linear[k], .angular = w.now->angular[k]};
    std::vector<Pose2> poses(commands.size() + 1);
    rollout(problem, commands, poses);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const Eigen::Vector2d position(w.now->x[k], w.now->y[k]);
      EXPECT_LT((position + problem.start.position - poses[k].position).norm(), 1e-13);
    }
    EXPECT_NEAR(w.now->cost, cost(problem, commands, poses), 1e-11);

    // Every row is either listed with its value, or left out and then far from being violated.
    int listed = 0;
    visit_elastic_rows(problem, [&](const RowName& name) {
      const double margin = elastic_row(problem, poses, name).margin;
      bool found = false;
      for (std::size_t s = 0; s < w.elastic.num_segments; ++s) {
        const Segment& segment = w.elastic.segments[s];
        const auto k = static_cast<std::size_t>(name.step);
        if (segment.kind != name.kind || static_cast<int>(segment.index) != name.index ||
            k < segment.first_step || k >= segment.first_step + segment.count)
          continue;
        found = true;
        ++listed;
        EXPECT_NEAR(w.now->value[segment.row + k - segment.first_step], margin, 1e-12);
      }
      if (!found) {
        EXPECT_GT(margin, 0.0);
      }
    });
    EXPECT_EQ(listed, static_cast<int>(w.elastic.count));
  });
}

// The Lagrangian with the duals that the workspace holds, as a function of the commands.
double lagrangian(Workspace& w, const VectorXd& v) {
  Point& point = *w.trial;
  set_commands(w, v, point);
  evaluate(w, point);
  double value = point.cost;
  for (std::size_t i = 0; i < w.elastic.count; ++i)
    value -= w.elastic.dual[i] * point.value[i];
  for (std::size_t i = 0; i < w.hard.count; ++i) {
    const std::size_t k = i % w.horizon;
    const CommandArray& c = (i / w.horizon) % 2 == 0 ? point.linear : point.angular;
    const bool change = i >= 2 * w.horizon;
    if (change && k == 0) continue;
    value += dual_gradient(w.hard, i) * (change ? c[k] - c[k - 1] : c[k]);
  }
  return value;
}

// The step balances rounding, which second differences magnify, against the third derivative.
VectorXd lagrangian_gradient(Workspace& w, const VectorXd& v) {
  return test::central_difference(
             [&](const VectorXd& x) { return VectorXd::Constant(1, lagrangian(w, x)); }, v, 2e-5)
      .row(0);
}

TEST(InteriorPointModel, StationarityIsTheDerivativeOfTheLagrangian) {
  for_random_problems(112, 60, [](const ControlProblem& problem, auto&, Workspace& w) {
    VectorXd gradient = lagrangian_gradient(w, commands_of(w, *w.now));
    for (std::size_t j = 0; j < 2; ++j) {
      for (std::size_t k = 0; k < size_of(problem); ++k) {
        if (w.limits[j].fixed[k]) gradient[static_cast<Eigen::Index>(j * w.horizon + k)] = 0.0;
      }
    }
    EXPECT_NEAR(w.model.stationarity, gradient.cwiseAbs().maxCoeff(),
                1e-5 * (1.0 + w.model.stationarity));
  });
}

// Model gradient at the commands: that of cost, barrier and aimed-at duals.
VectorXd model_gradient(Workspace& w, const VectorXd& v) {
  const ElasticArray duals = w.elastic.dual;
  const HardArray low = w.hard.dual_low;
  const HardArray high = w.hard.dual_high;
  w.elastic.dual = w.elastic.target_dual;
  for (std::size_t i = 0; i < w.hard.count; ++i) {
    w.hard.dual_low[i] = kMu * w.hard.inverse_below[i];
    w.hard.dual_high[i] = kMu * w.hard.inverse_above[i];
  }
  VectorXd gradient = lagrangian_gradient(w, v);
  w.elastic.dual = duals;
  w.hard.dual_low = low;
  w.hard.dual_high = high;
  return gradient;
}

TEST(InteriorPointModel, RiccatiStepSolvesTheNewtonSystem) {
  int solved = 0;
  for_random_problems(113, 60, [&](const ControlProblem& problem, auto&, Workspace& w) {
    aim_elastic_rows(w, kMu);
    aim_hard_rows(w, kMu);
    if (!riccati_backward(w, 1.0, 0.0)) return;
    ++solved;
    riccati_forward(w);
    const VectorXd at = commands_of(w, *w.now);
    VectorXd step(at.size());
    const auto n = static_cast<Eigen::Index>(w.horizon);
    step << Eigen::Map<const VectorXd>(w.model.step[0].data(), n),
        Eigen::Map<const VectorXd>(w.model.step[1].data(), n);

    // Hessian of the Lagrangian times the step, by differences of its gradient along the step ...
    const double h = 1e-3 / std::max(1e-3, step.cwiseAbs().maxCoeff());
    VectorXd residual =
        (lagrangian_gradient(w, at + h * step) - lagrangian_gradient(w, at - h * step)) / (2.0 * h);
    residual += model_gradient(w, at);
    // ... and the terms sigma grad c (grad c . step) of all rows.
    const auto value_changes = [&](const VectorXd& direction) {
      set_commands(w, at + 1e-5 * direction, *w.trial);
      evaluate(w, *w.trial);
      const ElasticArray ahead = w.trial->value;
      set_commands(w, at - 1e-5 * direction, *w.trial);
      evaluate(w, *w.trial);
      VectorXd change(static_cast<Eigen::Index>(w.elastic.count));
      for (std::size_t i = 0; i < w.elastic.count; ++i)
        change[static_cast<Eigen::Index>(i)] = (ahead[i] - w.trial->value[i]) / 2e-5;
      return change;
    };
    const VectorXd along = value_changes(step);
    for (Eigen::Index c = 0; c < at.size(); ++c) {
      const VectorXd by_command = value_changes(VectorXd::Unit(at.size(), c));
      for (std::size_t i = 0; i < w.elastic.count; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        residual[c] += w.elastic.curvature[i] * by_command[row] * along[row];
      }
      const auto j = static_cast<std::size_t>(c / n);
      const auto k = static_cast<std::size_t>(c % n);
      residual[c] += w.hard.curvature[j * w.horizon + k] * step[c];
      if (w.hard.count > 2 * w.horizon) {
        const std::size_t i = (2 + j) * w.horizon + k;
        if (k > 0) residual[c] += w.hard.curvature[i] * (step[c] - step[c - 1]);
        if (k + 1 < w.horizon) residual[c] -= w.hard.curvature[i + 1] * (step[c + 1] - step[c]);
      }
      if (w.limits[j].fixed[k]) residual[c] = step[c];
    }
    const double scale = 1.0 + model_gradient(w, at).cwiseAbs().maxCoeff();
    EXPECT_LT(residual.cwiseAbs().maxCoeff(), 2e-4 * scale) << "horizon " << problem.horizon;
  });
  EXPECT_GT(solved, 20);
}

}  // namespace
}  // namespace fairway::interior_point
