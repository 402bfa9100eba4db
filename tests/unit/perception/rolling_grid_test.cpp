// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/rolling_grid.hpp"

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "small_window.hpp"
#include "support/oracles/cell_oracle.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using test::beam;
using test::small_window;

std::vector<Beam> random_scan(test::Random& random, const Vector2d& from) {
  std::vector<Beam> beams;
  for (int i = 0; i < 60; ++i) {
    Beam b = beam(from, from + random.uniform(0.1, 4.5) * direction(random.uniform(-3, 3)));
    if (random.chance(0.2)) b.end = BeamEnd::Open;
    if (random.chance(0.1)) b.end = BeamEnd::Nothing;
    b.moving = random.chance(0.1);
    beams.push_back(b);
  }
  return beams;
}

// Counts the evidence of every cell of an unbounded world, one cell and beam at a time.
class SlowGrid {
 public:
  explicit SlowGrid(const PerceptionSettings& settings) : settings_(settings) {}

  void insert(const std::vector<Beam>& beams) {
    std::set<std::pair<int, int>> hit;
    std::set<std::pair<int, int>> passed;
    for (const Beam& b : beams) {
      if (b.end == BeamEnd::Hit && !b.moving) hit.insert(cell_at(b.to));
    }
    for (const Beam& b : beams) {
      if (b.end == BeamEnd::Nothing) continue;
      const Vector2d from = b.from / settings_.resolution;
      const Vector2d to = b.to / settings_.resolution;
      const Vector2d low = from.cwiseMin(to).array().floor();
      const Vector2d high = from.cwiseMax(to).array().floor();
      for (int y = static_cast<int>(low.y()); y <= static_cast<int>(high.y()); ++y) {
        for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x) {
          const bool covered = b.moving && b.end == BeamEnd::Hit && cell_at(b.to) == Cell(x, y) &&
                               evidence_.count({x, y}) == 0;
          if (!covered && test::cross_cell(from, to, {.x = x, .y = y}) && hit.count({x, y}) == 0) {
            passed.insert({x, y});
          }
        }
      }
    }
    for (const auto& cell : hit)
      add(cell, settings_.hit_evidence);
    for (const auto& cell : passed)
      add(cell, -settings_.miss_evidence);
  }

  // Forgets everything outside the window.
  void keep(const GridFrame& window) {
    std::erase_if(evidence_, [&](const auto& item) {
      return !window.contains(window.cell_at(center(item.first)));
    });
  }

  [[nodiscard]] CellState at(const Vector2d& point) const {
    const auto found = evidence_.find(cell_at(point));
    if (found == evidence_.end()) return CellState::Unknown;
    return found->second > 0 ? CellState::Occupied : CellState::Free;
  }

 private:
  using Cell = std::pair<int, int>;

  [[nodiscard]] Cell cell_at(const Vector2d& p) const {
    return {static_cast<int>(std::floor(p.x() / settings_.resolution)),
            static_cast<int>(std::floor(p.y() / settings_.resolution))};
  }
  [[nodiscard]] Vector2d center(const Cell& cell) const {
    return Vector2d(cell.first + 0.5, cell.second + 0.5) * settings_.resolution;
  }
  void add(const Cell& cell, int amount) {
    int& e = evidence_[cell];
    e = std::clamp(e + amount, settings_.least_evidence, settings_.most_evidence);
  }

  PerceptionSettings settings_;
  std::map<Cell, int> evidence_;
};

TEST(RollingGrid, AgreesWithASlowGridWhileItRolls) {
  test::Random random(3);
  const PerceptionSettings settings = small_window();
  for (int trial = 0; trial < 2; ++trial) {
    Vector2d robot(random.uniform(-20, 20), random.uniform(-20, 20));
    RollingGrid grid(settings, robot);
    SlowGrid slow(settings);
    int rolls = 0;
    const Vector2d way = 0.35 * direction(random.uniform(-3, 3));
    for (int n = 0; n < 25; ++n) {
      robot += way;
      const std::vector<Beam> beams = random_scan(random, robot);
      grid.insert(beams, robot, 0.0);
      rolls += grid.rolled() ? 1 : 0;
      slow.keep(grid.frame());
      slow.insert(beams);
      slow.keep(grid.frame());
      int different = 0;
      for (int y = 0; y < grid.frame().height; ++y) {
        for (int x = 0; x < grid.frame().width; ++x) {
          const Vector2d center = grid.frame().center({.x = x, .y = y});
          // The cells under the robot are set to free.
          if ((center - robot).norm() < 0.1 || slow.at(center) == grid.at({.x = x, .y = y}))
            continue;
          // A cell that was set to free a while ago.
          if (slow.at(center) == CellState::Unknown &&
              grid.at({.x = x, .y = y}) == CellState::Free) {
            continue;
          }
          ++different;
        }
      }
      // One method may count a beam that only touches a corner, and the other not.
      EXPECT_LE(different, 2);
    }
    EXPECT_GT(rolls, 1);
  }
}

TEST(RollingGrid, DenseBeamsClearTheSameCellsAsSingleOnes) {
  test::Random random(4);
  const PerceptionSettings settings = small_window();
  const Vector2d robot(0.37, -0.81);
  RollingGrid grid(settings, robot);
  SlowGrid slow(settings);
  double range = 2.0;
  for (int n = 0; n < 6; ++n) {
    std::vector<Beam> beams;
    for (int i = 0; i < 500; ++i) {  // posts in front of walls, where ranges jump
      if (random.chance(0.08)) range = random.uniform(0.2, 4.0);
      beams.push_back(beam(robot, robot + range * direction(-2.3 + 0.009 * i)));
      if (random.chance(0.02)) beams.back().end = BeamEnd::Nothing;
    }
    grid.insert(beams, robot, 0.0);
    slow.insert(beams);
  }
  int different = 0;
  for (int y = 0; y < grid.frame().height; ++y) {
    for (int x = 0; x < grid.frame().width; ++x) {
      const Vector2d center = grid.frame().center({.x = x, .y = y});
      if ((center - robot).norm() < 0.1) continue;
      different += slow.at(center) == grid.at({.x = x, .y = y}) ? 0 : 1;
    }
  }
  EXPECT_LE(different, 2);
}

TEST(RollingGrid, ItsBitsAgreeWithItsCells) {
  test::Random random(4);
  Vector2d robot(3, -7);
  RollingGrid grid(small_window(), robot);
  for (int n = 0; n < 30; ++n) {
    robot += Vector2d(0.4, 0.3);
    grid.insert(random_scan(random, robot), robot, 0.3);
    for (int y = 0; y < grid.frame().height; ++y) {
      for (int x = 0; x < grid.frame().width; ++x) {
        const CellState state = grid.at({.x = x, .y = y});
        ASSERT_EQ(grid.occupied().blocked({.x = x, .y = y}), state == CellState::Occupied);
        ASSERT_EQ(grid.not_seen_free().blocked({.x = x, .y = y}), state != CellState::Free);
      }
    }
  }
}

TEST(RollingGrid, ReportsWhereItChanged) {
  test::Random random(5);
  const Vector2d robot(0, 0);
  RollingGrid grid(small_window(), robot);
  for (int n = 0; n < 30; ++n) {
    const BitGrid before = grid.occupied();
    grid.insert(random_scan(random, robot), robot, 0.3);
    ASSERT_FALSE(grid.rolled());
    const CellWindow& window = grid.changed();
    for (int y = 0; y < grid.frame().height; ++y) {
      for (int x = 0; x < grid.frame().width; ++x) {
        const bool inside =
            x >= window.first.x && x <= window.last.x && y >= window.first.y && y <= window.last.y;
        if (!inside) {
          ASSERT_EQ(before.blocked({.x = x, .y = y}), grid.occupied().blocked({.x = x, .y = y}));
        }
      }
    }
  }
}

TEST(RollingGrid, AHitIsNotClearedByItsNeighboursInTheSameScan) {
  RollingGrid grid(small_window(), {0, 0});
  // Two beams along a wall: the second passes through the cell where the first ends.
  const std::vector<Beam> beams = {beam({0, 0.01}, {1.0, 0.01}), beam({0, 0.02}, {2.0, 0.02})};
  for (int n = 0; n < 20; ++n)
    grid.insert(beams, {0, 0}, 0.2);
  EXPECT_EQ(grid.at(grid.frame().cell_at({1.0, 0.01})), CellState::Occupied);
}

TEST(RollingGrid, ARemovedObstacleIsClearedAfterAFewScans) {
  RollingGrid grid(small_window(), {0, 0});
  for (int n = 0; n < 50; ++n)
    grid.insert(std::vector<Beam>{beam({0, 0}, {1.01, 0.0})}, {0, 0}, 0.2);
  int scans = 0;
  while (grid.at(grid.frame().cell_at({1.01, 0.0})) == CellState::Occupied && scans < 100) {
    grid.insert(std::vector<Beam>{beam({0, 0}, {3.01, 0.0})}, {0, 0}, 0.2);
    ++scans;
  }
  EXPECT_EQ(scans, small_window().most_evidence);
}

TEST(RollingGrid, AHitIsMarkedByTheHitDepthFurther) {
  PerceptionSettings settings = small_window();
  settings.hit_depth = 0.02;
  RollingGrid grid(settings, {0, 0});
  // A wall at 1.0 m with a slightly short range: the cell before it must stay free.
  grid.insert(std::vector<Beam>{beam({0, 0.01}, {0.99, 0.01})}, {0, 0}, 0.1);
  EXPECT_EQ(grid.at(grid.frame().cell_at({1.01, 0.01})), CellState::Occupied);
  EXPECT_EQ(grid.at(grid.frame().cell_at({0.99, 0.01})), CellState::Free);
}

TEST(RollingGrid, ALostBeamChangesNothing) {
  RollingGrid grid(small_window(), {0, 0});
  grid.insert(std::vector<Beam>{beam({0, 0}, {1, 0}, BeamEnd::Nothing)}, {0, 0}, 0.1);
  EXPECT_EQ(grid.at(grid.frame().cell_at({0.8, 0.0})), CellState::Unknown);
  EXPECT_TRUE(grid.not_seen_free().blocked(grid.frame().cell_at({0.8, 0.0})));
  EXPECT_FALSE(grid.occupied().blocked(grid.frame().cell_at({0.8, 0.0})));
}

TEST(RollingGrid, CellsUnderTheRobotAreFree) {
  RollingGrid grid(small_window(), {1, 1});
  grid.insert({}, {1, 1}, 0.3);
  for (int i = 0; i < 100; ++i) {
    const Vector2d p = Vector2d(1, 1) + 0.3 * direction(0.0628 * i);
    EXPECT_EQ(grid.at(grid.frame().cell_at(p)), CellState::Free);
  }
  EXPECT_EQ(grid.at(grid.frame().cell_at({1.5, 1.0})), CellState::Unknown);
}

TEST(RollingGrid, SameScansGiveTheSameBits) {
  const auto run = [] {
    test::Random random(6);
    Vector2d robot(0, 0);
    RollingGrid grid(small_window(), robot);
    for (int n = 0; n < 300; ++n) {
      robot += Vector2d(0.02, 0.01);
      grid.insert(random_scan(random, robot), robot, 0.3);
    }
    std::vector<std::uint64_t> words;
    for (int y = 0; y < grid.frame().height; ++y) {
      const auto row = grid.not_seen_free().row(y);
      words.insert(words.end(), row.begin(), row.end());
    }
    return words;
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace fairway
