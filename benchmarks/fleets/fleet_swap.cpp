// SPDX-License-Identifier: Apache-2.0
// Robots on a circle exchange places, for many perturbed starts. Prints arrivals, least
// separations, and times relative to the straight path.
//
//   fleet_swap [--seeds FIRST,LAST] [--delay S] [--loss SHARE] [--radio on|off] [--predict on|off]
//   N...
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "experiments/clocks.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/metrics.hpp"
#include "fairway/simulation/scenarios/swap_scenario.hpp"

namespace {

using namespace fairway;

struct Options {
  unsigned long first_seed = 1;
  unsigned long last_seed = 100;
  RadioModel radio;
  bool predict = true;
  bool verbose = false;
  std::vector<int> robots;
};

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&] { return ++i < argc ? argv[i] : ""; };
    if (name == "--seeds") {
      char* rest = nullptr;
      options.first_seed = std::strtoul(value(), &rest, 10);
      options.last_seed = *rest == ',' ? std::strtoul(rest + 1, nullptr, 10) : options.first_seed;
    } else if (name == "--delay") {
      options.radio.delay = std::atof(value());
    } else if (name == "--loss") {
      options.radio.loss = std::atof(value());
    } else if (name == "--radio") {
      options.radio.on = std::strcmp(value(), "off") != 0;
    } else if (name == "--predict") {
      options.predict = std::strcmp(value(), "off") != 0;
    } else if (name == "--verbose") {
      options.verbose = true;
    } else {
      options.robots.push_back(std::atoi(name.c_str()));
    }
  }
  return options;
}

// The time to drive straight on without other robots: from standstill to full speed and back.
double straight_time(double length, const RobotSettings& robot) {
  return length / robot.linear_max + robot.linear_max / robot.linear_acceleration_max;
}

void run(int robots, const Options& options) {
  std::vector<double> ratios;
  std::vector<double> cycles;
  int arrived = 0;
  int contacts = 0;
  double separation = 1e9;
  for (unsigned long seed = options.first_seed; seed <= options.last_seed; ++seed) {
    Scenario scenario = swap_scenario(robots, swap_radius(robots), {}, seed);
    scenario.radio = options.radio;
    scenario.settings.prediction.predict_motion = options.predict;
    EpisodeHooks hooks;
    hooks.clock = thread_cpu_seconds;
    const EpisodeResult result = run_episode(scenario, hooks);
    bool all = true;
    bool touched = false;
    double last = 0.0;
    for (const RobotResult& robot : result.robots) {
      all = all && robot.reached;
      touched = touched || robot.collided;
      last = std::max(last, robot.time);
      separation = std::min(separation, robot.min_separation);
      cycles.insert(cycles.end(), robot.cycle_seconds.begin(), robot.cycle_seconds.end());
    }
    arrived += all ? 1 : 0;
    contacts += touched ? 1 : 0;
    const double ratio = last / straight_time(2.0 * swap_radius(robots), scenario.settings.robot);
    if (all) ratios.push_back(ratio);
    if (options.verbose) {
      std::printf("  seed %lu: %s%s, last after %.1f s (x %.2f)\n", seed,
                  all ? "all arrived" : "stuck", touched ? ", contact" : "", last, ratio);
    }
  }
  const unsigned long runs = options.last_seed - options.first_seed + 1;
  std::sort(ratios.begin(), ratios.end());
  const Quantiles cycle = quantiles(cycles);
  std::printf(
      "%4d robots: %lu runs, all arrived %d, contact %d, least separation %.3f m, time x %.2f "
      "median, x %.2f worst, cycle %.0f/%.0f us\n",
      robots, runs, arrived, contacts, separation, ratios.empty() ? 0.0 : ratios[ratios.size() / 2],
      ratios.empty() ? 0.0 : ratios.back(), 1e6 * cycle.median, 1e6 * cycle.p99);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  for (const int robots : options.robots)
    run(robots, options);
  return 0;
}
