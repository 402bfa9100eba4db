// SPDX-License-Identifier: Apache-2.0
// Computing time of every control cycle of scenarios, and which cycles take longest.
//
//   cycle_times [REPEATS] SCENARIO.yaml...
//
// A scenario is run several times, and each cycle counts with the least CPU time of its thread: the
// runs are equal, so other programs on the machine explain what is more. Plans are not counted.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "experiments/clocks.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/simulation/episode.hpp"

namespace {

using namespace fairway;

struct Cycle {
  double time = 0.0;  // simulated [s]
  std::size_t robot = 0;
  NavigationStatus status{};
  LimitingFactor limit{};
  double seconds = 0.0;
};

class CycleList final : public EpisodeObserver {
 public:
  void on_start(const Scenario& /*scenario*/) override { count_ = 0; }
  void on_navigators(double /*time*/,
                     const Settings& /*settings*/,
                     std::span<const NavigatorStart> /*starts*/) override {}
  void on_plan(double /*time*/, std::size_t /*robot*/, const Plan& /*plan*/) override {}
  void on_world(const WorldView& /*world*/) override {}
  void on_cycle(const NavigationCycle& cycle) override {
    const bool first = count_ == cycles_.size();
    if (first) {
      cycles_.push_back({.time = cycle.input.time,
                         .robot = cycle.robot,
                         .status = cycle.step.status,
                         .limit = cycle.step.limit,
                         .seconds = cycle.seconds});
    }
    double& least = cycles_[count_++].seconds;
    least = std::min(least, cycle.seconds);
  }

  [[nodiscard]] std::vector<Cycle>& cycles() { return cycles_; }

 private:
  std::vector<Cycle> cycles_;
  std::size_t count_ = 0;
};

void print(const std::string& name, std::vector<Cycle>& cycles) {
  constexpr double kMicro = 1e6;
  constexpr std::size_t kWorst = 5;
  std::sort(cycles.begin(), cycles.end(),
            [](const Cycle& a, const Cycle& b) { return a.seconds > b.seconds; });
  if (cycles.empty()) return;
  const auto beyond = [&](double share) {
    const auto index = static_cast<std::size_t>(share * static_cast<double>(cycles.size()));
    return kMicro * cycles[std::min(index, cycles.size() - 1)].seconds;
  };
  std::printf("%s: %zu cycles, median %.0f us, p99 %.0f us, p99.9 %.0f us, greatest %.0f us\n",
              name.c_str(), cycles.size(), beyond(0.5), beyond(0.01), beyond(0.001), beyond(0.0));
  for (std::size_t i = 0; i < std::min(kWorst, cycles.size()); ++i) {
    std::printf("  %.0f us: robot %zu at %.2f s, %s, %s\n", kMicro * cycles[i].seconds,
                cycles[i].robot, cycles[i].time, to_text(cycles[i].status),
                to_text(cycles[i].limit));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int first = 1;
  int repeats = 5;
  if (argc > 1 && std::atoi(argv[1]) > 0) repeats = std::atoi(argv[first++]);
  for (int i = first; i < argc; ++i) {
    const Expected<Scenario> scenario = io::read_scenario(argv[i]);
    if (!scenario) {
      std::fprintf(stderr, "cycle_times: %s\n", scenario.error().message.c_str());
      return 2;
    }
    CycleList list;
    for (int k = 0; k < repeats; ++k) {
      EpisodeHooks hooks;
      hooks.clock = thread_cpu_seconds;
      hooks.observer = &list;
      (void)run_episode(*scenario, hooks);
    }
    print(scenario->name, list.cycles());
  }
  return first < argc ? 0 : 2;
}
