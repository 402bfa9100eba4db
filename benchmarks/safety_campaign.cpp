// SPDX-License-Identifier: Apache-2.0
// Drives random robots through random worlds and counts the contacts, as the simulator judges them.
//
//   safety_campaign [--runs N] [--seed S] [--shard I/N] [--sensing map|lidar] [--mujoco SHARE]
//                   [--bodies SHARE] [--pose exact|scans] [--noise FACTOR] [--json FILE] [--run K]
//
// With --pose scans, robots that know the map have their pose from lidar scans and odometry, with
// FACTOR times the standard noise; the errors of the pose are printed.
//
// Each run is drawn from its number and the seed: limits, footprint, period and jitter, map and
// people. --run K repeats one of them and prints its cycles. How contacts are classified is written
// in safety_campaign_run.hpp. Exit code 1 if a robot touched the map or drove into something that
// moved as predicted, or if a command was outside the limits.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "safety_campaign_run.hpp"
#ifdef FAIRWAY_WITH_MUJOCO
#include "fairway/simulation/physics/mujoco_physics.hpp"
#endif

namespace {

using namespace fairway;
using namespace fairway::campaign;

struct Options {
  DrawOptions draw;
  std::uint64_t runs = 1000;
  std::uint64_t shard = 1;
  std::uint64_t shards = 1;
  std::uint64_t only = 0;
  bool single = false;
  std::string json;
};

[[noreturn]] void bad_usage(const std::string& what) {
  std::fprintf(stderr, "safety_campaign: %s\n", what.c_str());
  std::exit(2);
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const std::string value = ++i < argc ? argv[i] : "";
    const auto number = [&] { return std::strtoull(value.c_str(), nullptr, 10); };
    if (value.empty()) bad_usage(name + ": expected a value, found none");
    if (name == "--runs") {
      options.runs = number();
    } else if (name == "--seed") {
      options.draw.seed = number();
    } else if (name == "--shard") {
      unsigned long long shard = 0;
      unsigned long long shards = 0;
      if (std::sscanf(value.c_str(), "%llu/%llu", &shard, &shards) != 2 || shard < 1 ||
          shard > shards) {
        bad_usage("--shard: expected I/N with I from 1 to N, found " + value);
      }
      options.shard = shard;
      options.shards = shards;
    } else if (name == "--sensing") {
      if (value != "map" && value != "lidar") bad_usage("--sensing: expected map or lidar");
      options.draw.sensing = value == "lidar" ? Sensing::Lidar : Sensing::Map;
    } else if (name == "--pose") {
      if (value != "exact" && value != "scans") bad_usage("--pose: expected exact or scans");
      options.draw.pose = value == "scans" ? PoseSource::Scans : PoseSource::Exact;
    } else if (name == "--noise") {
      options.draw.noise = std::atof(value.c_str());
    } else if (name == "--mujoco") {
      options.draw.mujoco_share = std::atof(value.c_str());
#ifndef FAIRWAY_WITH_MUJOCO
      bad_usage("--mujoco: this build has no MuJoCo");
#endif
    } else if (name == "--bodies") {
      options.draw.body_share = std::atof(value.c_str());
    } else if (name == "--json") {
      options.json = value;
    } else if (name == "--run") {
      options.single = true;
      options.only = number();
    } else {
      bad_usage(name + ": no such option");
    }
  }
  return options;
}

std::unique_ptr<Physics> physics_of(const Scenario& scenario) {
#ifdef FAIRWAY_WITH_MUJOCO
  if (scenario.engine == Engine::Mujoco) return make_mujoco_physics(scenario);
#endif
  (void)scenario;
  return nullptr;
}

struct Tally {
  std::uint64_t runs = 0;
  std::uint64_t refused = 0;
  std::uint64_t reached = 0;
  std::uint64_t cycles = 0;
  std::uint64_t bad_commands = 0;
  double seconds = 0.0;
  double clearance = std::numeric_limits<double>::infinity();
  double separation = std::numeric_limits<double>::infinity();
  std::array<std::uint64_t, 5> contacts{};
  std::vector<std::pair<std::uint64_t, ContactKind>> list;
  double metres = 0.0;       // driven
  double pose_square = 0.0;  // sum over the cycles [m^2]
  double pose_error = 0.0;   // greatest [m]
  std::vector<std::uint64_t> diverged;

  void add(std::uint64_t index, const Outcome& outcome) {
    ++runs;
    reached += outcome.reached ? 1 : 0;
    cycles += static_cast<std::uint64_t>(outcome.cycles);
    bad_commands += static_cast<std::uint64_t>(outcome.bad_commands);
    seconds += outcome.time;
    clearance = std::min(clearance, outcome.clearance);
    if (outcome.contact == ContactKind::None) separation = std::min(separation, outcome.separation);
    constexpr double kDiverged = 0.3;  // [m]
    metres += outcome.driven;
    pose_square += outcome.pose_square;
    pose_error = std::max(pose_error, outcome.pose_error);
    if (outcome.pose_error > kDiverged) diverged.push_back(index);
    ++contacts[static_cast<std::size_t>(outcome.contact)];
    if (outcome.contact != ContactKind::None || outcome.bad_commands > 0)
      list.emplace_back(index, outcome.contact);
  }

  [[nodiscard]] std::uint64_t count(ContactKind contact) const {
    return contacts[static_cast<std::size_t>(contact)];
  }
  [[nodiscard]] bool good() const {
    return count(ContactKind::Static) + count(ContactKind::DroveInto) + bad_commands == 0;
  }
};

// Prints the errors of poses by scans.
void print_poses(const Tally& tally) {
  std::printf(
      "pose: %.1f m driven, error %.1f mm rms, %.1f mm at most; %zu of %llu runs beyond 0.3 m:",
      tally.metres,
      1e3 * std::sqrt(tally.pose_square /
                      static_cast<double>(std::max<std::uint64_t>(1, tally.cycles))),
      1e3 * tally.pose_error, tally.diverged.size(), static_cast<unsigned long long>(tally.runs));
  for (const std::uint64_t run : tally.diverged)
    std::printf(" %llu", static_cast<unsigned long long>(run));
  std::printf("\n");
}

// JSON has no infinity: no obstacle was ever near.
double finite(double distance) { return std::min(distance, 1e9); }

// Counts in `totals`, and the runs with a contact in `runs`: `fairway merge` joins shards.
void write(std::FILE* file, const Options& options, const Tally& tally) {
  std::fprintf(file,
               "{\"seed\": %llu, \"shard\": \"%llu/%llu\", \"sensing\": \"%s\", "
               "\"totals\": {\"runs\": %llu, \"refused\": %llu, \"reached\": %llu, "
               "\"simulated_seconds\": %.0f, \"cycles\": "
               "%llu, \"bad_commands\": %llu, \"least_clearance\": %.6f, \"least_separation\": "
               "%.6f, \"contacts\": {",
               static_cast<unsigned long long>(options.draw.seed),
               static_cast<unsigned long long>(options.shard),
               static_cast<unsigned long long>(options.shards),
               options.draw.sensing == Sensing::Lidar ? "lidar" : "map",
               static_cast<unsigned long long>(tally.runs),
               static_cast<unsigned long long>(tally.refused),
               static_cast<unsigned long long>(tally.reached), tally.seconds,
               static_cast<unsigned long long>(tally.cycles),
               static_cast<unsigned long long>(tally.bad_commands), finite(tally.clearance),
               finite(tally.separation));
  for (const ContactKind contact : {ContactKind::Static, ContactKind::DroveInto,
                                    ContactKind::RunInto, ContactKind::Unpredictable}) {
    std::fprintf(file, "\"%s\": %llu%s", to_text(contact),
                 static_cast<unsigned long long>(tally.count(contact)),
                 contact == ContactKind::Unpredictable ? "}}" : ", ");
  }
  std::fprintf(file, ", \"runs\": [");
  for (std::size_t i = 0; i < tally.list.size(); ++i) {
    std::fprintf(file, "%s{\"run\": %llu, \"contact\": \"%s\"}", i == 0 ? "" : ", ",
                 static_cast<unsigned long long>(tally.list[i].first),
                 to_text(tally.list[i].second));
  }
  std::fprintf(file, "]}\n");
}

// Prints the cycles of one run.
int look_at(const Options& options) {
  const Run run = draw_run(options.draw, options.only);
  if (!run.valid) {
    std::printf("refused: %s\n", run.refused.c_str());
    return 0;
  }
  const RobotSettings& robot = run.scenario.settings.robot;
  std::printf("delay %.3f %.3f, lag %.3f %.3f, braking %.3f %.3f, lost %.3f, hold %.2f\n",
              robot.linear_delay, robot.angular_delay, robot.linear_lag, robot.angular_lag,
              robot.linear_braking_max, robot.angular_braking_max, run.lost_share,
              run.scenario.settings.safety.longest_hold);
  std::printf(
      "linear_max %.3f, acceleration %.3f, angular_max %.3f, acceleration %.3f, radius "
      "%.3f, length %.3f, discs %d, period %.3f, jitter %.2f\n",
      robot.linear_max, robot.linear_acceleration_max, robot.angular_max,
      robot.angular_acceleration_max, robot.radius, robot.length, robot.discs.count,
      run.scenario.settings.navigation.control_period, run.jitter);
  const auto watch = [](const World& world, const DrivenCycle& cycle, bool good) {
    const NavigationStep& step = cycle.step;
    const UnicycleRobot& r = world.robots().front();
    const Encounter& met = world.encounters().front();
    std::printf(
        "%7.3f pose %.4f %.4f %.4f twist %.6f %.6f command %.6f %.6f %s, %s; least %.4f "
        "%.4f",
        world.time(), r.pose.position.x(), r.pose.position.y(), r.pose.heading, r.twist.linear,
        r.twist.angular, step.command.linear, step.command.angular, to_text(step.status),
        to_text(step.limit), met.min_clearance, met.min_separation);
    const Pose2& pose = cycle.input.pose;  // by lidar in the frame of its map
    std::printf(" | estimated %.4f %.4f %.4f", pose.position.x(), pose.position.y(), pose.heading);
    for (std::size_t i = 0; i < world.num_bodies(); ++i) {
      const MovingObstacle body = world.body(i).at(world.time());
      std::printf(" | %.3f %.3f v %.3f %.3f", body.position.x(), body.position.y(),
                  body.velocity.x(), body.velocity.y());
    }
    // Where the robot estimates them to be: by lidar this differs.
    for (const MovingObstacle& seen : cycle.input.obstacles) {
      const Vector2d now = predicted_position(seen, cycle.input.time - cycle.input.obstacles_time);
      std::printf(" | seen %.3f %.3f v %.3f %.3f radius %.3f", now.x(), now.y(), seen.velocity.x(),
                  seen.velocity.y(), seen.radius);
    }
    std::printf("%s\n", good ? "" : " | OUTSIDE THE LIMITS");
  };
  const Outcome outcome = drive(run, options.only, physics_of(run.scenario), watch);
  std::printf("%s at %.3f s, contact: %s\n", outcome.reached ? "reached" : "not reached",
              outcome.time, to_text(outcome.contact));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  if (options.single) return look_at(options);
  Tally tally;
  const bool terminal = isatty(STDERR_FILENO) != 0;
  for (std::uint64_t i = options.shard - 1; i < options.runs; i += options.shards) {
    const Run run = draw_run(options.draw, i);
    if (!run.valid) {
      ++tally.refused;
      continue;
    }
    tally.add(i, drive(run, i, physics_of(run.scenario)));
    if (terminal && i % 16 == 0) {
      std::fprintf(stderr, "\r%llu of %llu runs, %zu contacts", static_cast<unsigned long long>(i),
                   static_cast<unsigned long long>(options.runs), tally.list.size());
    }
  }
  if (terminal) std::fprintf(stderr, "\n");
  write(stdout, options, tally);
  if (options.draw.pose == PoseSource::Scans) print_poses(tally);
  if (!options.json.empty()) {
    std::FILE* file = std::fopen(options.json.c_str(), "w");
    if (file == nullptr) bad_usage("--json: cannot write " + options.json);
    write(file, options, tally);
    std::fclose(file);
  }
  return tally.good() ? 0 : 1;
}
