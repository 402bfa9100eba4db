// SPDX-License-Identifier: Apache-2.0
// A robot drives through recorded people, who do not see it, on many paths and from many times of
// the recording. Prints arrivals, contacts, and times relative to the same path without people.
//
//   pedestrian_runs TRACKS [--runs N] [--seed S] [--radius M] [--speed M/S] [--margin M]
//                   [--growth M/S] [--growth-max M] [--remember] [--verbose]
//
// --radius is that of a person; the last four are settings of the robot (robot.linear_max,
// navigation.obstacle_*). The format of TRACKS is in fairway/io/scenario/tracks_file.hpp, with 25
// frames per second. Every run leads from outside the scene through its middle to the other side,
// in a random direction. Each run is made twice, with and without the prediction.
// With --remember the robot knows where people appeared earlier in the recording.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "experiments/clocks.hpp"
#include "fairway/io/scenario/tracks_file.hpp"
#include "fairway/prediction/entrances.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/metrics.hpp"

namespace {

using namespace fairway;
using Eigen::Vector2d;

struct Options {
  std::string tracks;
  int runs = 200;
  unsigned long seed = 1;
  Settings settings;
  io::TracksFormat format;
  bool remember = false;
  bool verbose = false;
};

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&] { return ++i < argc ? argv[i] : ""; };
    if (name == "--runs") {
      options.runs = std::atoi(value());
    } else if (name == "--seed") {
      options.seed = std::strtoul(value(), nullptr, 10);
    } else if (name == "--radius") {
      options.format.radius = std::atof(value());
    } else if (name == "--speed") {
      options.settings.robot.linear_max = std::atof(value());
    } else if (name == "--margin") {
      options.settings.prediction.obstacle_margin = std::atof(value());
    } else if (name == "--growth") {
      options.settings.prediction.obstacle_growth = std::atof(value());
    } else if (name == "--growth-max") {
      options.settings.prediction.obstacle_growth_max = std::atof(value());
    } else if (name == "--remember") {
      options.remember = true;
    } else if (name == "--verbose") {
      options.verbose = true;
    } else {
      options.tracks = name;
    }
  }
  return options;
}

// The area and duration of the recording.
struct Recording {
  std::vector<MovingBody> people;
  Vector2d center;
  double reach;  // from the centre to outside the scene [m]
  double end;    // [s]
};

Recording recording_of(std::vector<MovingBody> people) {
  Vector2d low = people.front().key_frames.front().position;
  Vector2d high = low;
  double end = 0.0;
  for (const MovingBody& person : people) {
    for (const MovingBody::KeyFrame& frame : person.key_frames) {
      low = low.cwiseMin(frame.position);
      high = high.cwiseMax(frame.position);
      end = std::max(end, frame.time);
    }
  }
  constexpr double kOutside = 1.0;  // [m]
  return {.people = std::move(people),
          .center = 0.5 * (low + high),
          .reach = 0.5 * (high - low).maxCoeff() + kOutside,
          .end = end};
}

// @param from  Receives the time of the recording at which the run begins [s].
Scenario draw(const Recording& recording, const Options& options, Noise& noise, double& from) {
  constexpr double kAround = 3.0;  // [m] of open space around the paths
  constexpr double kResolution = 0.1;
  Scenario scenario;
  scenario.name = "pedestrians";
  scenario.time_limit = 60.0;
  const double half = recording.reach + kAround;
  const int cells = static_cast<int>(2.0 * half / kResolution);
  scenario.map = OccupancyGrid(
      {.width = cells,
       .height = cells,
       .resolution = kResolution,
       .origin = {.position = recording.center - Vector2d(half, half), .heading = 0.0}});
  scenario.settings = options.settings;
  const double heading = noise.uniform(-std::numbers::pi, std::numbers::pi);
  const double aside = noise.uniform(-0.3, 0.3);
  from = noise.uniform(0.0, recording.end - scenario.time_limit);
  scenario.robots = {
      {.name = "robot",
       .start = {.position = recording.center - recording.reach * direction(heading),
                 .heading = heading},
       .goal = {.position = recording.center + recording.reach * direction(heading + aside),
                .heading = {}}}};
  scenario.bodies = replayed(recording.people, from, scenario.time_limit);
  return scenario;
}

// Where people appeared before the run begins. Those of the first moment were there already.
EntranceMap entrances_before(const Recording& recording, double begin) {
  const Vector2d around = Vector2d::Constant(recording.reach + 1.0);
  EntranceMap entrances(recording.center - around, recording.center + around);
  double first = recording.end;
  for (const MovingBody& person : recording.people)
    first = std::min(first, person.key_frames.front().time);
  for (const MovingBody& person : recording.people) {
    const MovingBody::KeyFrame& frame = person.key_frames.front();
    if (frame.time > first && frame.time <= begin) entrances.note(frame.position);
  }
  entrances.observe(std::max(0.0, begin - first));
  return entrances;
}

// For how long the person nearest to the robot's last place had been in the recording [s]; those of
// the first moment for the whole run.
double seen_for(const Scenario& scenario, const EpisodeResult& result) {
  const Vector2d robot = result.trace.rows.back().pose.position;
  double nearest = 1e9;
  double seen = 0.0;
  for (const MovingBody& person : scenario.bodies) {
    if (!person.is_there(result.time)) continue;
    const double distance = (person.at(result.time).position - robot).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    seen = result.time - std::max(0.0, person.key_frames.front().time);
  }
  return seen;
}

struct Tally {
  int arrived = 0;
  int ran_into = 0;   // contacts while the robot went towards the person
  int appeared = 0;   // of these, with a person who appeared within the time of a stop
  int at_once = 0;    // of these, with a person who touched the robot within a cycle of appearing
  int run_over = 0;   // contacts while the robot was at standstill or moved away
  int not_there = 0;  // without contact, but too late
  double separation = 1e9;
  std::vector<double> ratios;
  std::vector<double> cycles;

  // The time of a stop is that of the safety campaign, without its second for a reaction.
  void add(const RobotResult& robot, double lone, double seen, const Settings& settings) {
    const double cycle = settings.navigation.control_period;
    const double stop = settings.robot.linear_max / linear_actuation(settings.robot).braking +
                        dead_time(settings.robot) + (1.0 + settings.safety.longest_hold) * cycle;
    if (robot.collided) {
      ++(robot.approach > 0.0 ? ran_into : run_over);
      if (robot.approach > 0.0 && seen < stop) ++appeared;
      if (robot.approach > 0.0 && seen < cycle) ++at_once;
    } else {
      separation = std::min(separation, robot.min_separation);
      ++(robot.reached ? arrived : not_there);
      if (robot.reached) ratios.push_back(robot.time / lone);
    }
    cycles.insert(cycles.end(), robot.cycle_seconds.begin(), robot.cycle_seconds.end());
  }

  void print(const char* name, int runs) {
    std::sort(ratios.begin(), ratios.end());
    const auto at = [&](double share) {
      return ratios.empty()
                 ? 0.0
                 : ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))];
    };
    const Quantiles cycle = quantiles(cycles);
    std::printf(
        "prediction %-3s: %d runs, arrived %d, ran into a person %d (%d who appeared within the "
        "time "
        "of a stop, %d of these at the robot), run over %d, too late %d, "
        "least separation without contact %.3f m, time x %.2f median, x %.2f at 90 %%, x %.2f "
        "worst, cycle %.0f/%.0f us\n",
        name, runs, arrived, ran_into, appeared, at_once, run_over, not_there, separation, at(0.5),
        at(0.9), at(1.0), 1e6 * cycle.median, 1e6 * cycle.p99);
  }
};

void run(const Recording& recording, const Options& options) {
  Noise noise(options.seed);
  EpisodeHooks hooks;
  hooks.clock = thread_cpu_seconds;
  Tally with;
  Tally without;
  for (int i = 0; i < options.runs; ++i) {
    double from = 0.0;
    Scenario scenario = draw(recording, options, noise, from);
    const EntranceMap entrances = entrances_before(recording, from);
    if (options.remember) hooks.entrances = &entrances;
    Scenario alone = scenario;
    alone.bodies.clear();
    const double lone = run_episode(alone).robots.front().time;
    for (Tally* tally : {&with, &without}) {
      scenario.settings.prediction.predict_motion = tally == &with;
      const EpisodeResult result = run_episode(scenario, hooks);
      const RobotResult& robot = result.robots.front();
      const double seen = seen_for(scenario, result);
      tally->add(robot, lone, seen, scenario.settings);
      if (options.verbose) {
        std::printf("  run %d, prediction %s: %s after %.1f s, %.2f m/s towards, seen for %.2f s\n",
                    i, tally == &with ? "on" : "off",
                    robot.collided ? "contact" : (robot.reached ? "arrived" : "too late"),
                    robot.time, robot.approach, seen);
      }
    }
  }
  with.print("on", options.runs);
  without.print("off", options.runs);
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  const Expected<std::vector<MovingBody>> people = io::read_tracks(options.tracks, options.format);
  if (!people) {
    std::fprintf(stderr, "pedestrian_runs: %s\n", people.error().message.c_str());
    return 2;
  }
  if (const Expected<void> valid = validate(options.settings); !valid) {
    std::fprintf(stderr, "pedestrian_runs: %s\n", valid.error().message.c_str());
    return 2;
  }
  run(recording_of(*people), options);
  return 0;
}
