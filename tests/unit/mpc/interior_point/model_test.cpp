// SPDX-License-Identifier: Apache-2.0
// Compares the solver's own, fast expressions with evaluation.hpp and with differences.
#include <cmath>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "fairway/mpc/derivatives.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/initial_point.hpp"
#include "fairway/mpc/interior_point/kernels.hpp"
#include "fairway/mpc/interior_point/line_search.hpp"
#include "fairway/mpc/interior_point/newton/newton.hpp"
#include "fairway/mpc/interior_point/setup.hpp"
#include "support/oracles/central_difference.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway::interior_point {
namespace {

using Eigen::VectorXd;
using Lanes = Lanes128;

constexpr double kMu = 0.7;

std::size_t size_of(const ControlProblem& problem) {
  return static_cast<std::size_t>(problem.horizon);
}

VectorXd flat(const Workspace& w, const std::array<PoseArray, 2>& commands) {
  const auto n = static_cast<Eigen::Index>(w.horizon);
  VectorXd v(2 * n);
  v << Eigen::Map<const VectorXd>(commands[kLinear].data() + 1, n),
      Eigen::Map<const VectorXd>(commands[kAngular].data() + 1, n);
  return v;
}

void set_commands(const Workspace& w, const VectorXd& v, Point& point) {
  for (std::size_t k = 0; k < w.horizon; ++k) {
    point.commands[kLinear][k + 1] = v[static_cast<Eigen::Index>(k)];
    point.commands[kAngular][k + 1] = v[static_cast<Eigen::Index>(k + w.horizon)];
  }
}

/// Calls visit(i) for every soft constraint that is not only watched.
template <typename Visit>
void for_near_constraints(const Workspace& w, Visit&& visit) {
  for (std::size_t b = 0; b < w.num_blocks; ++b) {
    const ConstraintRange& range = w.constraint_ranges[b];
    for (std::size_t i = range.corridor; i < range.watched_corridor; ++i)
      visit(i);
    for (std::size_t i = range.barrier; i < range.watched_barrier; ++i)
      visit(i);
  }
}

double stationarity_of(Workspace& w) {
  ConstraintErrors<Lanes> errors;
  linearise_bounds(w, kMu, errors);
  linearise_soft_constraints(w, kMu, errors);
  return linearise_trajectory<Lanes>(w);
}

/// The first iterate, with duals far from the central path.
double begin(const ControlProblem& problem, test::Random& random, Workspace& w) {
  load_problem(problem, w);
  InitialGuess guess;
  guess.count = problem.horizon;
  for (Twist2& command : guess.commands)
    command = test::random_command(random, problem);
  load_guess(kernels_128(), guess, w, *w.now);
  w.first_slack = 0.05;
  evaluate<Lanes>(w, *w.now);
  start_bounds<Lanes>(w, kMu);
  admit_near_constraints<Lanes>(w, kMu);
  for_near_constraints(w, [&](std::size_t i) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      w.soft_constraints[i].dual[lane] *= random.uniform(0.5, 2.0);
      w.soft_constraints[i].violation_dual[lane] =
          problem.violation_weight - w.soft_constraints[i].dual[lane];
      w.now->constraints[i].violation_slack[lane] *= random.uniform(0.5, 2.0);
    }
  });
  for (std::size_t k = 0; k < w.horizon; ++k)
    w.bounds[kLinear].blocks[k / kLanes].dual_low[k % kLanes] *= random.uniform(0.5, 2.0);
  return stationarity_of(w);
}

template <typename Check>
void for_random_problems(std::uint64_t seed, int count, Check&& check) {
  const auto w = std::make_unique<Workspace>();
  test::Random random(seed);
  for (int trial = 0; trial < count; ++trial) {
    SCOPED_TRACE(trial);
    const ControlProblem problem = test::random_control_problem(random);
    const double stationarity = begin(problem, random, *w);
    check(problem, stationarity, *w);
  }
}

TEST(InteriorPointModel, PosesCostAndConstraintsAreThoseOfTheEvaluation) {
  for_random_problems(111, 300, [](const ControlProblem& problem, double, Workspace& w) {
    std::vector<Twist2> commands(size_of(problem));
    for (std::size_t k = 0; k < commands.size(); ++k)
      commands[k] = {.linear = w.now->commands[kLinear][k + 1],
                     .angular = w.now->commands[kAngular][k + 1]};
    std::vector<Pose2> poses(commands.size() + 1);
    rollout(problem, commands, poses);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const Eigen::Vector2d position(w.now->x[k], w.now->y[k]);
      EXPECT_LT((position + problem.start.position - poses[k].position).norm(), 1e-13);
    }
    EXPECT_NEAR(w.now->cost, cost(problem, commands, poses), 1e-11);

    // This includes the watched constraints, which the iteration skips.
    evaluate_soft_constraints<Lanes>(w, *w.now);
    // Every constraint is either listed with its value, or omitted because it is far from being
    // violated.
    visit_soft_constraints(problem, [&](const ConstraintName& name) {
      const double margin = soft_constraint(problem, poses, name).margin;
      bool found = false;
      for (std::size_t i = 0; i < w.num_soft_constraints; ++i) {
        const SoftConstraintBlock& constraint = w.soft_constraints[i];
        if (constraint.kind != name.kind || constraint.index != name.index ||
            name.step < constraint.first_step ||
            name.step >= constraint.first_step + static_cast<int>(kLanes))
          continue;
        found = true;
        const auto lane = static_cast<std::size_t>(name.step - constraint.first_step);
        EXPECT_NEAR(w.now->constraints[i].value[lane], margin, 1e-12);
      }
      if (!found) {
        EXPECT_GT(margin, 0.0);
      }
    });
    // Watched constraints are satisfied, and so are the unused lanes of a constraint block.
    for (std::size_t b = 0; b < w.num_blocks; ++b) {
      const ConstraintRange& range = w.constraint_ranges[b];
      for (std::size_t i = range.corridor; i < range.end; ++i) {
        const bool watched =
            (i >= range.watched_corridor && i < range.barrier) || i >= range.watched_barrier;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          const bool beyond =
              w.soft_constraints[i].first_step + static_cast<int>(lane) > problem.horizon;
          if (watched || beyond) {
            EXPECT_GE(w.now->constraints[i].value[lane], 0.0);
          }
        }
      }
    }
  });
}

// The Lagrangian with the workspace's duals, as a function of the commands.
double lagrangian(Workspace& w, const VectorXd& v) {
  Point& point = *w.trial;
  set_commands(w, v, point);
  evaluate<Lanes>(w, point);
  double value = point.cost;
  for_near_constraints(w, [&](std::size_t i) {
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      value -= w.soft_constraints[i].dual[lane] * point.constraints[i].value[lane];
  });
  for (std::size_t kind = 0; kind < w.num_bounds; ++kind) {
    const PoseArray& c = point.commands[kind % 2];
    for (std::size_t k = 0; k < w.horizon; ++k) {
      const Bounds::Block& block = w.bounds[kind].blocks[k / kLanes];
      const double dual = block.dual_high[k % kLanes] - block.dual_low[k % kLanes];
      value += dual * (kind >= 2 ? c[k + 1] - c[k] : c[k + 1]);
    }
  }
  return value;
}

// The step balances rounding, which second differences amplify, against the third derivative.
VectorXd lagrangian_gradient(Workspace& w, const VectorXd& v) {
  return test::central_difference(
             [&](const VectorXd& x) { return VectorXd::Constant(1, lagrangian(w, x)); }, v, 2e-5)
      .row(0);
}

TEST(InteriorPointModel, StationarityIsTheDerivativeOfTheLagrangian) {
  for_random_problems(
      112, 60, [](const ControlProblem& problem, double stationarity, Workspace& w) {
        VectorXd gradient = lagrangian_gradient(w, flat(w, w.now->commands));
        for (std::size_t j = 0; j < 2; ++j) {
          for (std::size_t k = 0; k < size_of(problem); ++k) {
            if (w.limits[j].fixed[k]) gradient[static_cast<Eigen::Index>(j * w.horizon + k)] = 0.0;
          }
        }
        EXPECT_NEAR(stationarity, gradient.cwiseAbs().maxCoeff(), 1e-5 * (1.0 + stationarity));
      });
}

// Model gradient at the commands: that of cost, barrier and target duals.
VectorXd model_gradient(Workspace& w, const VectorXd& v) {
  const std::array<SoftConstraintBlock, kMaxSoftConstraints> saved_constraints = w.soft_constraints;
  const std::array<Bounds, 4> saved_bounds = w.bounds;
  for_near_constraints(w, [&](std::size_t i) {
    SoftConstraintBlock& constraint = w.soft_constraints[i];
    const SoftConstraintState& state = w.now->constraints[i];
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      constraint.dual[lane] += kMu * constraint.dual_by_mu[lane] -
                               constraint.curvature[lane] * state.value[lane];  // y hat
  });
  for (Bounds& bounds : w.bounds) {
    for (Bounds::Block& block : bounds.blocks) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        block.dual_low[lane] = kMu * block.inverse_below[lane];
        block.dual_high[lane] = kMu * block.inverse_above[lane];
      }
    }
  }
  VectorXd gradient = lagrangian_gradient(w, v);
  w.soft_constraints = saved_constraints;
  w.bounds = saved_bounds;
  return gradient;
}

TEST(InteriorPointModel, RiccatiStepSolvesTheNewtonSystem) {
  int solved = 0;
  for_random_problems(113, 60, [&](const ControlProblem& problem, double, Workspace& w) {
    build_stages<Lanes>(w, kMu, true);
    if (!riccati_backward<Lanes>(w, 0.0)) return;
    ++solved;
    riccati_forward(w);
    const VectorXd at = flat(w, w.now->commands);
    const VectorXd step = flat(w, w.step.commands);
    const VectorXd gradient = model_gradient(w, at);
    const auto n = static_cast<Eigen::Index>(w.horizon);

    // Hessian of the Lagrangian times the step, by differences of its gradient along the step ...
    const double h = 1e-3 / std::max(1e-3, step.cwiseAbs().maxCoeff());
    VectorXd residual =
        (lagrangian_gradient(w, at + h * step) - lagrangian_gradient(w, at - h * step)) / (2.0 * h);
    residual += gradient;
    // ... plus the terms sigma grad c (grad c . step) of all constraints.
    const auto values = [&](const VectorXd& v) {
      set_commands(w, v, *w.trial);
      evaluate<Lanes>(w, *w.trial);
      std::vector<double> all;
      for_near_constraints(w, [&](std::size_t i) {
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          all.push_back(w.trial->constraints[i].value[lane]);
      });
      return all;
    };
    const auto value_changes = [&](const VectorXd& direction) -> VectorXd {
      const std::vector<double> ahead = values(at + 1e-5 * direction);
      const std::vector<double> behind = values(at - 1e-5 * direction);
      const auto count = static_cast<Eigen::Index>(ahead.size());
      return (Eigen::Map<const VectorXd>(ahead.data(), count) -
              Eigen::Map<const VectorXd>(behind.data(), count)) /
             2e-5;
    };
    std::vector<double> curvature;
    for_near_constraints(w, [&](std::size_t i) {
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        curvature.push_back(w.soft_constraints[i].curvature[lane]);
    });
    const VectorXd along = value_changes(step);
    for (Eigen::Index c = 0; c < at.size(); ++c) {
      const VectorXd by_command = value_changes(VectorXd::Unit(at.size(), c));
      for (std::size_t i = 0; i < curvature.size(); ++i) {
        const auto constraint = static_cast<Eigen::Index>(i);
        residual[c] += curvature[i] * by_command[constraint] * along[constraint];
      }
      const auto j = static_cast<std::size_t>(c / n);
      const auto k = static_cast<std::size_t>(c % n);
      residual[c] += w.bounds[j].curvature[k] * step[c];
      if (w.num_bounds > 2) {
        const PoseArray& changes = w.bounds[2 + j].curvature;
        if (k > 0) residual[c] += changes[k] * (step[c] - step[c - 1]);
        if (k + 1 < w.horizon) residual[c] -= changes[k + 1] * (step[c + 1] - step[c]);
      }
      if (w.limits[j].fixed[k]) residual[c] = step[c];
    }
    const double scale = 1.0 + gradient.cwiseAbs().maxCoeff();
    EXPECT_LT(residual.cwiseAbs().maxCoeff(), 2e-4 * scale) << "horizon " << problem.horizon;

    // The slope is that of the model, in which fixed commands do not change.
    double slope = 0.0;
    for (Eigen::Index c = 0; c < at.size(); ++c)
      slope += gradient[c] * step[c];
    EXPECT_NEAR(w.step.slope, slope, 1e-4 * (1.0 + std::abs(slope)));
  });
  EXPECT_GT(solved, 20);
}

}  // namespace
}  // namespace fairway::interior_point
