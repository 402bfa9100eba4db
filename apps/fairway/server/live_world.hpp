// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/run_stream.hpp"
#include "fairway/simulation/episode.hpp"
#include "server/live_command.hpp"
#include "server/live_maps.hpp"
#include "server/live_messages.hpp"

namespace fairway::app {

/// What everybody who looks at a live world should know besides the run itself.
struct LiveState {
  bool paused = false;
  double speed = 1.0;
  std::size_t map = 0;  ///< among the names
  std::vector<std::string> maps;
  Sensing sensing = Sensing::Map;
  SensorNoise noise = SensorNoise::None;
};

/// Told from the world's own thread. Records are those of RunStream.
struct LiveListener {
  std::function<void(std::string records)> on_run;      ///< a new run begins with these
  std::function<void(std::string records)> on_records;  ///< what is new
  /// Records that begin the run as it is now, for those who join later and need not see all of it.
  std::function<void(std::string records)> on_beginning;
  std::function<void(LiveMessages::Batch batch)> on_messages;
  std::function<void(const LiveState& state)> on_state;
  std::function<void(const std::string& notice)> on_notice;  ///< for people
};

/// A simulated world that runs in a thread of its own, in (a multiple of) real time, and does what
/// is asked of it between two control cycles.
class LiveWorld {
 public:
  /// What can be downloaded; each gives the bytes of a file, from the world's thread.
  enum class Download : std::uint8_t { Recording, Scenario, Report };

  /// @param choices  At least one; the first is begun with.
  LiveWorld(std::vector<MapChoice> choices, LiveListener listener);
  ~LiveWorld();
  LiveWorld(const LiveWorld&) = delete;
  LiveWorld& operator=(const LiveWorld&) = delete;

  /// Asks for something; safe from any thread. Where too much is waiting already, it is dropped.
  void ask(ClientCommand command);

  /// Adds a scenario to the choices and begins with it; false where too much is waiting already.
  [[nodiscard]] bool use_map(Scenario scenario);

  void download(Download what, std::function<void(std::string)> done);

 private:
  struct UseMap {
    Scenario scenario;
  };
  struct Save {
    Download what;
    std::function<void(std::string)> done;
  };
  using Request = std::variant<ClientCommand, UseMap, Save>;

  bool enqueue(Request request, std::size_t most_waiting);
  void run();
  void run_once();
  void recover(const std::string& reason);
  void serve_requests(EpisodeControl& control);
  bool play(EpisodeControl& control);
  [[nodiscard]] std::optional<Request> next_request(double until);
  void publish();
  void tell_beginning(double time);
  void tell_state();
  void carry_out(EpisodeControl& control, Request& request);

  void apply(EpisodeControl& control, const PauseCommand& command);
  void apply(EpisodeControl& control, const StepCommand& command);
  void apply(EpisodeControl& control, const SpeedCommand& command);
  void apply(EpisodeControl& control, const RestartCommand& command);
  void apply(EpisodeControl& control, const GoalCommand& command);
  void apply(EpisodeControl& control, const StartCommand& command);
  void apply(EpisodeControl& control, const AddRobotCommand& command);
  void apply(EpisodeControl& control, const RemoveRobotCommand& command);
  void apply(EpisodeControl& control, const PaintCommand& command);
  void apply(EpisodeControl& control, const WalkCommand& command);
  void apply(EpisodeControl& control, const RemoveBodyCommand& command);
  void apply(EpisodeControl& control, const SettingCommand& command);
  void apply(EpisodeControl& control, const SenseCommand& command);
  void apply(EpisodeControl& control, const ChooseMapCommand& command);
  void save(const Save& request) const;
  [[nodiscard]] bool has_robot(std::size_t robot) const;
  [[nodiscard]] bool on_map(const Eigen::Vector2d& point) const;

  std::vector<MapChoice> choices_;  // those given, then uploads
  std::size_t num_given_;
  LiveListener listener_;
  LiveState state_;
  Scenario scenario_;       // as it would be saved: with everything that was changed
  Settings good_settings_;  // a run has begun with these
  int failures_ = 0;        // runs in a row that ended in their first cycle
  bool again_ = false;      // begin a new run
  bool step_ = false;       // one cycle although paused
  double due_ = 0.0;        // when the next cycle is [s]
  double told_beginning_ = 0.0;
  std::size_t told_since_ = 0;  // then [bytes]
  bool fresh_ = true;           // nothing of this run has been told
  bool full_told_ = false;
  std::string records_;  // of this run, for a report
  io::RunStream stream_;
  std::unique_ptr<LiveMessages> messages_;

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Request> requests_;  // guarded by mutex_
  bool stopping_ = false;         // guarded by mutex_
  std::jthread thread_;
};

}  // namespace fairway::app
