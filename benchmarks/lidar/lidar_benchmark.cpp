// SPDX-License-Identifier: Apache-2.0
// Measures what a robot makes of its scans, against the truth of the simulator.
//
//   lidar_benchmark tracking [--runs N] [--seed S] [--noise FACTOR] [--odometry]
//   lidar_benchmark drift    [--runs N] [--seed S] [--noise FACTOR]
//
// `tracking` drives a robot through halls of posts and walls, without and with moving discs, and
// among pairs that pass each other closely. It prints precision, recall, velocity errors and false
// tracks. A disc counts as visible if five beams hit it, for 0.7 s and while it moves. `drift`
// prints errors of the pose per metre driven, by the wheels alone and corrected by scans. --noise
// multiplies the standard errors of lidar and wheels; --odometry leaves the poses as they are.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "experiments/clocks.hpp"
#include "fairway/geometry/angle.hpp"
#include "fairway/perception/perception.hpp"
#include "fairway/simulation/sensors/lidar.hpp"
#include "fairway/simulation/sensors/odometry.hpp"
#include "lidar_scenes.hpp"

namespace {

using namespace fairway;
using namespace fairway::lidar_scenes;
using Eigen::Vector2d;

constexpr double kPeriod = 0.05;  // [s] from scan to scan

struct Options {
  std::string command;
  int runs = 20;
  unsigned long seed = 1;
  double noise = 1.0;
  bool match = true;
};

// Counts of scans and discs.
struct Tally {
  double metres = 0.0;
  double seconds = 0.0;
  long due = 0;       // visible moving discs
  long found = 0;     // of these, those with a track
  long reported = 0;  // tracks
  long correct = 0;   // of these, those of a moving disc
  double velocity_square = 0.0;
  double position_square = 0.0;
  long identities = 0;   // changes of the track of a disc
  int false_tracks = 0;  // that lasted 0.5 s
  double longest_false = 0.0;
  std::vector<double> cpu;
};

// One run of 20 s.
class Run {
 public:
  Run(const Options& options, Scene scene, unsigned long seed, Tally& tally)
      : options_(options),
        noise_(seed),
        world_(make_world(scene, noise_)),
        odometry_({.most_scale_error = 0.01 * options.noise,
                   .most_drift = 0.2 * options.noise * std::numbers::pi / 180.0},
                  robot_at(0.0),
                  noise_),
        perception_(settings(options), robot_at(0.0).position),
        tally_(tally),
        visible_(world_.discs.size(), 0.0),
        identity_(world_.discs.size(), -1) {
    lidar_.range_sigma = 0.01 * options.noise;
    lidar_.dropout = 0.01 * options.noise;
  }

  static PerceptionSettings settings(const Options& options) {
    return {.match_scans = options.match};
  }

  void drive() {
    for (int n = 0; n < 400; ++n)
      scan(n * kPeriod);
    for (const auto& [id, since] : false_)
      note_false(since, 400 * kPeriod);
  }

  [[nodiscard]] double position_error() const {
    return (perception_.corrected(odometry_.pose()).position - truth_.position).norm();
  }
  [[nodiscard]] double heading_error() const {
    return std::abs(shortest_turn(perception_.corrected(odometry_.pose()).heading, truth_.heading));
  }

 private:
  void scan(double time) {
    const Pose2 truth = robot_at(time);
    if (time > 0.0) tally_.metres += (truth.position - truth_.position).norm();
    truth_ = truth;
    odometry_.move_to(truth);
    std::vector<MovingObstacle> discs;
    for (const Disc& disc : world_.discs)
      discs.push_back(disc.at(time));
    const auto sensor = [&](const Pose2& robot) {
      return Pose2{.position = transform(robot, lidar_.mount), .heading = robot.heading};
    };
    scan_surroundings(lidar_, world_.obstacles, discs, sensor(truth), noise_, ranges_);
    const double before = thread_cpu_seconds();
    perception_.observe({.time = time,
                         .first_pose = sensor(odometry_.pose()),
                         .last_pose = sensor(odometry_.pose()),
                         .first_angle = -0.5 * lidar_.field_of_view,
                         .angle_step = lidar_.field_of_view / (lidar_.beams - 1),
                         .min_range = lidar_.min_range,
                         .max_range = lidar_.max_range,
                         .ranges = ranges_},
                        odometry_.pose().position, 0.3);
    tally_.cpu.push_back(thread_cpu_seconds() - before);
    judge(time, discs, sensor(truth));
  }

  // Position of a point of the world in the frame of the perception.
  [[nodiscard]] Vector2d seen_at(const Vector2d& point) const {
    return transform(perception_.corrected(odometry_.pose()), inverse_transform(truth_, point));
  }

  void judge(double time, const std::vector<MovingObstacle>& discs, const Pose2& sensor) {
    tally_.seconds += kPeriod;
    const double turn = perception_.corrected(odometry_.pose()).heading - truth_.heading;
    std::vector<const MovingTrack*> moving;
    for (const MovingTrack& track : perception_.tracker().tracks()) {
      if (track.moving) moving.push_back(&track);
    }
    std::vector<bool> correct(moving.size(), false);
    for (std::size_t d = 0; d < discs.size(); ++d) {
      int beams = 0;
      for (std::size_t i = 0; i < ranges_.size(); ++i) {
        const double angle =
            sensor.heading +
            lidar_.field_of_view *
                (static_cast<double>(i) / static_cast<double>(ranges_.size() - 1) - 0.5);
        const Vector2d end = sensor.position + static_cast<double>(ranges_[i]) * direction(angle);
        const bool near = static_cast<double>(ranges_[i]) < 12.0;
        if (near && std::abs((end - discs[d].position).norm() - discs[d].radius) < 0.06) ++beams;
      }
      const bool moves = discs[d].velocity.norm() > 0.25;
      visible_[d] = beams >= 5 && moves ? visible_[d] + kPeriod : 0.0;
      const MovingTrack* nearest = nullptr;
      double least = 0.3 + discs[d].radius;
      for (std::size_t t = 0; t < moving.size(); ++t) {
        const double away = (moving[t]->position() - seen_at(discs[d].position)).norm();
        if (away < 0.5 + discs[d].radius) correct[t] = true;
        if (away >= least) continue;
        least = away;
        nearest = moving[t];
      }
      if (visible_[d] < 0.7) continue;
      ++tally_.due;
      if (nearest == nullptr) continue;
      ++tally_.found;
      tally_.position_square += least * least;
      tally_.velocity_square +=
          (nearest->velocity() - rotated(discs[d].velocity, turn)).squaredNorm();
      if (identity_[d] >= 0 && identity_[d] != nearest->id) ++tally_.identities;
      identity_[d] = nearest->id;
    }
    tally_.reported += static_cast<long>(moving.size());
    for (std::size_t t = 0; t < moving.size(); ++t) {
      if (correct[t]) ++tally_.correct;
      note(time, moving[t]->id, !correct[t]);
    }
    // False tracks that have ended.
    for (auto it = false_.begin(); it != false_.end();) {
      const bool lasts = std::any_of(moving.begin(), moving.end(),
                                     [&](const MovingTrack* t) { return t->id == it->first; });
      if (lasts) {
        ++it;
        continue;
      }
      note_false(it->second, time);
      it = false_.erase(it);
    }
  }

  void note(double time, int id, bool wrong) {
    const auto known = std::find_if(false_.begin(), false_.end(),
                                    [&](const auto& item) { return item.first == id; });
    if (wrong && known == false_.end()) false_.emplace_back(id, time);
    if (wrong || known == false_.end()) return;
    note_false(known->second, time);
    false_.erase(known);
  }

  void note_false(double since, double until) {
    tally_.longest_false = std::max(tally_.longest_false, until - since);
    if (until - since >= 0.5) ++tally_.false_tracks;
  }

  Options options_;
  Noise noise_;
  World world_;
  LidarModel lidar_;
  Odometry odometry_;
  Perception perception_;
  Tally& tally_;
  Pose2 truth_;
  std::vector<float> ranges_;
  std::vector<double> visible_;  // for how long each disc has been visible [s]
  std::vector<int> identity_;    // track of each disc
  std::vector<std::pair<int, double>> false_;
};

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

void run_tracking(const Options& options) {
  std::printf(
      "scene     precision  recall  velocity  position  switches  false>0.5s  longest  "
      "scan us median/p99/max\n");
  for (const Scene scene : {Scene::Posts, Scene::Walls, Scene::Crossing, Scene::Passing}) {
    Tally tally;
    for (int n = 0; n < options.runs; ++n)
      Run(options, scene, options.seed + static_cast<unsigned long>(n), tally).drive();
    const auto share = [](long part, long all) {
      return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 1.0;
    };
    const auto root = [&](double square) {
      return tally.found > 0 ? std::sqrt(square / static_cast<double>(tally.found)) : 0.0;
    };
    std::printf("%-9s %8.1f %% %6.1f %% %5.2f m/s %6.2f m %8ld %10d %8.2f s  %.0f / %.0f / %.0f\n",
                kSceneNames[static_cast<std::size_t>(scene)],
                100.0 * share(tally.correct, tally.reported), 100.0 * share(tally.found, tally.due),
                root(tally.velocity_square), root(tally.position_square), tally.identities,
                tally.false_tracks, tally.longest_false, 1e6 * percentile(tally.cpu, 0.5),
                1e6 * percentile(tally.cpu, 0.99), 1e6 * percentile(tally.cpu, 1.0));
  }
}

void run_drift(const Options& given) {
  std::printf("scene     poses    position mm/m  heading mrad/m  worst run mm/m\n");
  for (const Scene scene : {Scene::Posts, Scene::Walls, Scene::Crossing}) {
    for (const bool match : {false, true}) {
      Options options = given;
      options.match = match;
      Tally tally;
      double position = 0.0;
      double heading = 0.0;
      double worst = 0.0;
      for (int n = 0; n < options.runs; ++n) {
        const double before = tally.metres;
        Run run(options, scene, options.seed + static_cast<unsigned long>(n), tally);
        run.drive();
        position += run.position_error();
        heading += run.heading_error();
        worst = std::max(worst, run.position_error() / (tally.metres - before));
      }
      std::printf("%-9s %-8s %12.2f %15.2f %15.2f\n", kSceneNames[static_cast<std::size_t>(scene)],
                  match ? "scans" : "wheels", 1e3 * position / tally.metres,
                  1e3 * heading / tally.metres, 1e3 * worst);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&] { return ++i < argc ? argv[i] : "0"; };
    if (name == "--runs") {
      options.runs = std::atoi(value());
    } else if (name == "--seed") {
      options.seed = std::strtoul(value(), nullptr, 10);
    } else if (name == "--noise") {
      options.noise = std::atof(value());
    } else if (name == "--odometry") {
      options.match = false;
    } else {
      options.command = name;
    }
  }
  if (options.command == "tracking") {
    run_tracking(options);
  } else if (options.command == "drift") {
    run_drift(options);
  } else {
    std::fprintf(stderr,
                 "usage: lidar_benchmark tracking|drift [--runs N] [--seed S] "
                 "[--noise FACTOR] [--odometry]\n");
    return 2;
  }
  return 0;
}
