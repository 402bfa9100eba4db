// SPDX-License-Identifier: Apache-2.0
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

#include "node/node_options.hpp"
#include "node/robot_session.hpp"
#include "page/page_data.hpp"
#include "page/page_server.hpp"

namespace {

using namespace fairway;
using namespace fairway::vda5050;

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

int run(const NodeOptions& options) {
  const Settings& settings = options.scenario.settings;
  const BitGrid map(options.scenario.map, unknown_cells(settings.map));
  SimulatedFleet fleet(options.scenario, options.physics);
  const MqttLibrary library;
  Wakeup wakeup;
  const SessionContext context{.broker = options.broker,
                               .settings = settings,
                               .map = map,
                               .map_id = options.map_id,
                               .fleet = fleet,
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
  while (exits_wanted == 0) {
    for (const auto& session : sessions)
      session->handle_events(wall_clock());
    const double now = steady_clock();
    if (now < next) {
      constexpr double kLongest = 0.1;  // [s], until a signal is noticed
      constexpr double kOwing = 0.005;  // [s], while a state is owed
      const bool owes = std::any_of(sessions.begin(), sessions.end(), [](const auto& session) {
        return session->vehicle().owes_state();
      });
      wakeup.wait(std::min(next - now, owes ? kOwing : kLongest));
      continue;
    }
    for (const auto& session : sessions) {
      session->cycle(wall_clock());
      for (const auto& other : sessions)
        other->handle_events(wall_clock());
    }
    fleet.advance(period);
    if (page) page->show(sessions);
    next += period / options.speed;
    constexpr double kLate = 1.0;  // [s]
    if (steady_clock() - next > kLate) next = steady_clock();
  }
  constexpr double kPatience = 1.5;  // for all robots [s]
  const double end = steady_clock() + kPatience;
  for (const auto& session : sessions)
    session->finish(wall_clock(), std::max(0.05, end - steady_clock()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto count = [](int /*signal*/) { ++exits_wanted; };
  std::signal(SIGINT, count);
  std::signal(SIGTERM, count);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const Expected<ParsedOptions> parsed = parse_options(argc, argv);
    if (parsed) return parsed->only_help ? 0 : run(parsed->options);
    std::fprintf(stderr, "fairway: %s\n", parsed.error().message.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fairway: %s\n", error.what());
  }
  return kBadInput;
}
