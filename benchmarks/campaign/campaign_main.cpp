// SPDX-License-Identifier: Apache-2.0
// Drives random robots through random worlds and counts the contacts, as the simulator judges them.
//
// Each run is drawn from its number and the seed: limits, footprint, period and jitter, map and
// people. How contacts are classified is written in contacts.hpp.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/number_option.hpp"
#include "cli/output.hpp"
#include "cli/provenance.hpp"
#include "cli/shard_option.hpp"
#include "run.hpp"
#ifdef FAIRWAY_WITH_MUJOCO
#include "fairway/simulation/physics/mujoco_physics.hpp"
#endif

namespace {

using namespace fairway;
using namespace fairway::app;
using namespace fairway::campaign;

constexpr int kMostRuns = 100000000;

struct CampaignOptions {
  DrawOptions draw;
  bool guard = false;
};

// As the command line has them.
struct Words {
  int runs = 1000;
  int seed = 1;
  std::string shard;
  std::string sensing = "map";
  std::optional<double> mujoco;
  std::optional<double> bodies;
  std::optional<double> late;
  std::string pose = "exact";
  std::optional<double> noise;
  std::optional<int> run;
  bool guard = false;
  std::string json;
};

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
  std::uint64_t too_near = 0;
  std::uint64_t reduced = 0;
  double seconds = 0.0;
  double clearance = std::numeric_limits<double>::infinity();
  double separation = std::numeric_limits<double>::infinity();
  std::array<std::uint64_t, 5> contacts{};
  std::vector<std::pair<std::uint64_t, ContactKind>> list;
  PoseErrors poses;

  void add(std::uint64_t index, const Outcome& outcome) {
    ++runs;
    reached += outcome.reached ? 1 : 0;
    cycles += static_cast<std::uint64_t>(outcome.cycles);
    bad_commands += static_cast<std::uint64_t>(outcome.bad_commands);
    too_near += static_cast<std::uint64_t>(outcome.too_near);
    reduced += static_cast<std::uint64_t>(outcome.reduced);
    seconds += outcome.time;
    poses.add(index, outcome.pose);
    clearance = std::min(clearance, outcome.clearance);
    if (outcome.contact == ContactKind::None) separation = std::min(separation, outcome.separation);
    ++contacts[static_cast<std::size_t>(outcome.contact)];
    if (outcome.contact != ContactKind::None || outcome.bad_commands > 0 || outcome.too_near > 0)
      list.emplace_back(index, outcome.contact);
  }

  [[nodiscard]] std::uint64_t count(ContactKind contact) const {
    return contacts[static_cast<std::size_t>(contact)];
  }
  [[nodiscard]] bool good() const {
    return count(ContactKind::Static) + count(ContactKind::DroveInto) + bad_commands + too_near ==
           0;
  }
};

// JSON has no infinity: no obstacle was ever near.
double finite(double distance) { return std::min(distance, 1e9); }

// Counts in `totals`, and the runs with a contact in `runs`: `fairway merge` joins shards.
Json json_of(const Words& words, const Tally& tally) {
  Json result;
  if (!words.shard.empty()) result["shard"] = words.shard;
  result["sensing"] = words.sensing;
  Json& totals = result["totals"];
  totals["runs"] = tally.runs;
  totals["refused"] = tally.refused;
  totals["reached"] = tally.reached;
  totals["simulated_seconds"] = tally.seconds;
  totals["cycles"] = tally.cycles;
  totals["bad_commands"] = tally.bad_commands;
  totals["cycles_too_near"] = tally.too_near;
  totals["reduced_commands"] = tally.reduced;
  totals["least_clearance"] = finite(tally.clearance);
  totals["least_separation"] = finite(tally.separation);
  for (const ContactKind contact : {ContactKind::Static, ContactKind::DroveInto,
                                    ContactKind::RunInto, ContactKind::Unpredictable})
    totals["contacts"][to_text(contact)] = tally.count(contact);
  if (words.pose == "scans") {
    result["pose"] = {{"metres", tally.poses.sum.driven},
                      {"error_rms", tally.poses.root_mean_square()},
                      {"error_most", tally.poses.sum.greatest},
                      {"diverged", tally.poses.diverged}};
  }
  result["runs"] = Json::array();
  for (const auto& [run, contact] : tally.list)
    result["runs"].push_back({{"run", run}, {"contact", to_text(contact)}});
  add_provenance(
      result,
      {.schema = "campaign.v1", .files = {}, .seed = static_cast<std::uint64_t>(words.seed)});
  return result;
}

// Prints the cycles of one run.
int look_at(const CampaignOptions& options, std::uint64_t number) {
  const Run run = draw_run(options.draw, number);
  if (!run.valid) {
    std::printf("refused: %s\n", run.refused.c_str());
    return 0;
  }
  const RobotSettings& robot = run.scenario.settings.robot;
  std::printf("late %.3f, ", run.late_share);
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
  const Outcome outcome = drive(run, number, physics_of(run.scenario), options.guard, watch);
  std::printf("%s at %.3f s, contact: %s\n", outcome.reached ? "reached" : "not reached",
              outcome.time, to_text(outcome.contact));
  std::printf("%d commands outside the limits, %d cycles too near, %d commands reduced\n",
              outcome.bad_commands, outcome.too_near, outcome.reduced);
  return 0;
}

Expected<int> run_campaign(const Words& words) {
  CampaignOptions options{
      .draw = {.seed = static_cast<std::uint64_t>(words.seed),
               .sensing = words.sensing == "lidar" ? Sensing::Lidar : Sensing::Map,
               .pose = words.pose == "scans" ? PoseSource::Scans : PoseSource::Exact,
               .noise = words.noise.value_or(0.0),
               .mujoco_share = words.mujoco.value_or(0.0),
               .body_share = words.bodies.value_or(0.0),
               .late_share = words.late.value_or(0.0)},
      .guard = words.guard};
#ifndef FAIRWAY_WITH_MUJOCO
  if (words.mujoco) return fail("--mujoco: this build has no MuJoCo");
#endif
#ifndef FAIRWAY_WITH_GUARD
  if (words.guard) return fail("--guard: this build has no bridge of the nodes");
#endif
  if (words.run) return look_at(options, static_cast<std::uint64_t>(*words.run));
  if (const auto writable = check_output(words.json); !writable)
    return tl::unexpected(writable.error());
  const Shard shard = parse_shard(words.shard);
  Tally tally;
  const bool terminal = isatty(STDERR_FILENO) != 0;
  for (std::size_t i = shard.index - 1; i < static_cast<std::size_t>(words.runs);
       i += shard.count) {
    const Run run = draw_run(options.draw, i);
    if (!run.valid) {
      ++tally.refused;
      continue;
    }
    tally.add(i, drive(run, i, physics_of(run.scenario), options.guard));
    if (terminal && i % 16 == 0)
      std::fprintf(stderr, "\r%zu of %d runs, %zu contacts", i, words.runs, tally.list.size());
  }
  if (terminal) std::fprintf(stderr, "\n");
  const std::string text = json_text(json_of(words, tally));
  if (const auto printed = print(text); !printed) return tl::unexpected(printed.error());
  if (const auto written = write_output(words.json, text); !written)
    return tl::unexpected(written.error());
  return tally.good() ? kDone : kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  Words words;
  CommandLine tool;
  const Options options = tool.add_command(
      "campaign",
      "Drive random robots through random worlds. Exit code 1 after a contact of the classes "
      "static "
      "or drove into it, a command outside the limits, or a distance below the bound",
      [&words] { return run_campaign(words); });
  const Check share = number_between(0.0, 1.0);
  options.add("--runs", words.runs, "Number of runs").between(1, kMostRuns).shows_default();
  options.add("--seed", words.seed, "Seed of all runs").not_negative().shows_default();
  add_shard_option(options, words.shard);
  options.add("--sensing", words.sensing, "What the robots know")
      .one_of({"map", "lidar"})
      .shows_default();
  options.add("--mujoco", words.mujoco, "Share of runs with wheels in MuJoCo").check(share);
  options.add("--bodies", words.bodies, "Share of robots with their true outline").check(share);
  options.add("--late", words.late, "Share of runs with cycles a second late").check(share);
  options.add("--pose", words.pose, "Pose of robots that know the map: exact, or from lidar scans")
      .one_of({"exact", "scans"})
      .shows_default();
  options.add("--noise", words.noise, "Noise of lidar and odometry, in multiples of the standard")
      .check(number_between(0.0, 100.0));
  options.add_flag("--guard", words.guard, "Run the safety monitor of the nodes behind each robot");
  options.add("--run", words.run, "Repeat one run, and print its cycles").between(0, kMostRuns);
  options.add("--json", words.json, "Write the result to a file").type_name("FILE");
  std::vector<char*> arguments(argv, argv + argc);
  std::string command = "campaign";
  arguments.insert(arguments.begin() + 1, command.data());
  return tool.run(argc + 1, arguments.data());
}
