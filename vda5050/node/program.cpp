// SPDX-License-Identifier: Apache-2.0
#include "node/program.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "node/robot_session.hpp"
#include "page/page_data.hpp"
#include "page/page_server.hpp"

namespace fairway::vda5050 {

namespace {

constexpr int kBadInput = 2;

std::atomic<int> exits_wanted{0};
static_assert(std::atomic<int>::is_always_lock_free);  // signal handlers need this

double wall_clock() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

double steady_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

using Sessions = std::vector<std::unique_ptr<RobotSession>>;

// The live page with its own pace.
class Page {
 public:
  Page(int port, const BitGrid& map, double radius)
      : server_(port, page_map(map).dump()),
        radius_(radius) {
    std::fprintf(stderr, "page: http://127.0.0.1:%d\n", server_.port());
  }

  void show(const Sessions& sessions) {
    constexpr double kPeriod = 0.2;  // [s]
    if (steady_clock() < next_) return;
    next_ = steady_clock() + kPeriod;
    nlohmann::json robots = nlohmann::json::array();
    for (const auto& session : sessions)
      robots.push_back(page_robot(session->vehicle(), radius_));
    const nlohmann::json shown{{"robots", std::move(robots)}};
    server_.show(shown.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }

 private:
  PageServer server_;
  double radius_;
  double next_ = 0.0;
};

// Robots that are not simulated stop along the ramp of their base before the program ends.
void brake(const Sessions& sessions, RobotBases& bases, Wakeup& wakeup, double period) {
  constexpr double kLongest = 1.2;  // [s]
  const double end = steady_clock() + kLongest;
  for (bool stopped = false; !stopped && steady_clock() < end;) {
    bases.receive();
    stopped = true;
    for (const auto& session : sessions)
      stopped = session->brake() && stopped;
    for (const double next = steady_clock() + period; !stopped && steady_clock() < next;)
      wakeup.wait(std::max(0.0, next - steady_clock()));
  }
  for (std::size_t i = 0; i < sessions.size(); ++i)
    bases.leave(i);
}

int run(const NodeOptions& options, RobotBases& bases) {
  const Settings& settings = options.scenario.settings;
  const BitGrid map(options.scenario.map, unknown_cells(settings.map));
  const MqttLibrary library;
  Wakeup wakeup;
  const SessionContext context{.broker = options.broker,
                               .settings = settings,
                               .map = map,
                               .map_id = options.map_id,
                               .bases = bases,
                               .wakeup = wakeup,
                               .speed = options.speed};
  std::optional<Page> page;
  if (options.page) page.emplace(*options.page, map, settings.robot.radius);
  Sessions sessions;
  for (std::size_t i = 0; i < options.vehicles.size(); ++i)
    sessions.push_back(std::make_unique<RobotSession>(context, i, options.vehicles[i]));
  // A first cycle before any order: a vehicle must know where it is.
  for (const auto& session : sessions) {
    session->cycle(wall_clock());
    session->start();
  }
  const double period = settings.navigation.control_period;
  double next = steady_clock();
  while (exits_wanted == 0 && !bases.ended()) {
    bases.receive();
    for (const auto& session : sessions)
      session->handle_events(wall_clock());
    const double now = steady_clock();
    if (now < next) {
      constexpr double kOwing = 0.005;  // [s], while a state is owed
      const bool owes = std::any_of(sessions.begin(), sessions.end(), [](const auto& session) {
        return session->vehicle().owes_state();
      });
      wakeup.wait(std::min(next - now, owes ? kOwing : bases.longest_wait()));
      continue;
    }
    for (const auto& session : sessions) {
      session->cycle(wall_clock());
      for (const auto& other : sessions)
        other->handle_events(wall_clock());
    }
    bases.advance(period);
    if (page) page->show(sessions);
    next += period / options.speed;
    constexpr double kLate = 1.0;  // [s]
    if (steady_clock() - next > kLate) next = steady_clock();
  }
  if (bases.must_brake()) brake(sessions, bases, wakeup, period);
  // For all robots, so that the program ends within two seconds [s].
  const double patience = bases.must_brake() ? 0.5 : 1.5;
  const double end = steady_clock() + patience;
  for (const auto& session : sessions)
    session->finish(wall_clock(), std::max(0.05, end - steady_clock()));
  return 0;
}

}  // namespace

int run_program(int argc, char** argv, RobotKind kind, const BasesMaker& make_bases) {
  const auto count = [](int /*signal*/) { ++exits_wanted; };
  std::signal(SIGINT, count);
  std::signal(SIGTERM, count);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const Expected<ParsedOptions> parsed = parse_options(argc, argv, kind);
    if (parsed) {
      if (parsed->only_help) return 0;
      const std::unique_ptr<RobotBases> bases = make_bases(parsed->options);
      return run(parsed->options, *bases);
    }
    std::fprintf(stderr, "fairway: %s\n", parsed.error().message.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fairway: %s\n", error.what());
  }
  return kBadInput;
}

}  // namespace fairway::vda5050
