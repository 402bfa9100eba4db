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
#include "server/editing/edit_history.hpp"
#include "server/live_command.hpp"
#include "server/live_maps.hpp"
#include "server/live_messages.hpp"

namespace fairway::app {

/// State of a live world that all viewers need besides the run itself.
struct LiveState {
  bool paused = false;
  double speed = 1.0;
  std::size_t map = 0;  ///< among the names
  std::vector<std::string> maps;
  Sensing sensing = Sensing::Map;
  SensorNoise noise = SensorNoise::None;
  bool halted = false;   ///< emergency stop
  bool waiting = false;  ///< the world begins with its first viewer
  bool edited = false;   ///< `RevertCommand` would change the map or the robots
  std::string undo;      ///< what `UndoCommand` would undo; empty: nothing
  std::string redo;
};

/// Why a command was refused, for the client that sent it.
struct Refusal {
  std::uint64_t client = 0;
  std::string text;
  std::optional<Eigen::Vector2d> at{};  ///< the place on the map, if there is one
  std::vector<std::string> settings{};  ///< of these settings, group.name
};

/// Receives the events of a live world, in the world's own thread. Records are those of RunStream.
struct LiveListener {
  std::function<void(std::string records)> on_run;      ///< a new run begins with these
  std::function<void(std::string records)> on_records;  ///< what is new
  /// Records that begin the run in its present state, for viewers that join later and do not need
  /// all of it.
  std::function<void(std::string records)> on_beginning;
  std::function<void(LiveMessages::Batch batch)> on_messages;
  std::function<void(const LiveState& state)> on_state;
  std::function<void(const std::string& notice)> on_notice;  ///< for people
  std::function<void(const Refusal& refusal)> on_refusal = [](const Refusal&) {};
};

/// A simulated world that runs in a thread of its own, in real time or a multiple of it. It
/// executes requests between two control cycles.
class LiveWorld {
 public:
  /// Downloads. Each returns the bytes of a file, in the world's thread.
  enum class Download : std::uint8_t { Recording, Scenario, Report };

  /// When the world begins to run. Stepped: a SteppedWorld advances it, for programs without
  /// threads.
  enum class Begin : std::uint8_t { AtOnce, WithViewer, Stepped };

  /// @param choices  At least one; the first is begun with.
  LiveWorld(std::vector<MapChoice> choices, LiveListener listener, Begin begin = Begin::AtOnce);
  ~LiveWorld();
  LiveWorld(const LiveWorld&) = delete;
  LiveWorld& operator=(const LiveWorld&) = delete;

  /// Queues a request; safe from any thread. If too many are waiting already, it is dropped.
  /// @param client  Receives the refusal, if there is one.
  void ask(ClientCommand command, std::uint64_t client = 0);

  /// Notes that a viewer has connected: a world that waits for one begins. Safe from any thread.
  void welcome();

  /// Adds a scenario to the choices and begins it; false if too many requests are waiting already.
  [[nodiscard]] bool use_map(Scenario scenario);

  void download(Download what, std::function<void(std::string)> done);

 private:
  friend class SteppedWorld;

  struct UseMap {
    Scenario scenario;
  };
  struct Save {
    Download what;
    std::function<void(std::string)> done;
  };
  struct Asked {
    ClientCommand command;
    std::uint64_t client = 0;
  };
  using Request = std::variant<Asked, UseMap, Save>;

  bool enqueue(Request request, std::size_t most_waiting);
  void run();
  Scenario begin_run();
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
  void apply(EpisodeControl& control, const CancelCommand& command);
  void apply(EpisodeControl& control, const PoseCommand& command);
  void apply(EpisodeControl& control, const ResetRobotCommand& command);
  void apply(EpisodeControl& control, const HaltCommand& command);
  void apply(EpisodeControl& control, const UndoCommand& command);
  void apply(EpisodeControl& control, const RevertCommand& command);
  void apply(EpisodeControl& control, const AddRobotCommand& command);
  void apply(EpisodeControl& control, const RemoveRobotCommand& command);
  void apply(EpisodeControl& control, const PaintCommand& command);
  void apply(EpisodeControl& control, const WalkCommand& command);
  void apply(EpisodeControl& control, const RemoveBodyCommand& command);
  void apply(EpisodeControl& control, const ZoneCommand& command);
  void apply(EpisodeControl& control, const RemoveZoneCommand& command);
  void apply(EpisodeControl& control, const SettingCommand& command);
  void apply(EpisodeControl& control, const SenseCommand& command);
  void apply(EpisodeControl& control, const ChooseMapCommand& command);
  void save(const Save& request) const;
  [[nodiscard]] bool has_robot(std::size_t robot) const;
  void refuse(std::string text, std::optional<Eigen::Vector2d> at = {});
  void edited(Edit edit);
  void set_goal(EpisodeControl& control, std::size_t robot, const std::optional<Goal>& goal);
  void place(EpisodeControl& control, std::size_t robot, const Pose2& pose, const Pose2& start);
  void set_present(EpisodeControl& control, std::size_t robot, bool present);
  void set_cells(EpisodeControl& control,
                 const std::vector<CellIndex>& cells,
                 const std::vector<CellState>& states);
  void set_zones(EpisodeControl& control, const Zones& zones);
  void change_zones(EpisodeControl& control, std::string label, const Zones& zones);
  void use_settings(EpisodeControl& control, const Settings& settings);
  void set_body(EpisodeControl& control, std::size_t index, const std::optional<MovingBody>& body);
  [[nodiscard]] Scenario as_saved() const;
  void begin_with(std::size_t choice, Scenario scenario);
  [[nodiscard]] bool holds() const;
  [[nodiscard]] bool waits_on();

  std::vector<MapChoice> choices_;  // those given, then uploads
  std::size_t num_given_;
  LiveListener listener_;
  LiveState state_;
  // The scenario with all edits. During a run, robots that were removed from it are kept so that
  // indices do not change; `as_saved` leaves them out.
  Scenario scenario_;
  std::vector<bool> removed_;                  // robots of scenario_
  std::vector<std::optional<Scenario>> left_;  // edited choices, for when they are chosen again
  EditHistory history_;
  std::uint64_t client_ = 0;  // whose command is carried out
  Settings good_settings_;    // a run has begun with these
  int failures_ = 0;          // runs in a row that ended in their first cycle
  bool again_ = false;        // begin a new run
  bool step_ = false;         // one cycle although paused
  double due_ = 0.0;          // when the next cycle is [s]
  double told_beginning_ = 0.0;
  std::size_t told_since_ = 0;  // then [bytes]
  bool fresh_ = true;           // no record of this run has been sent
  bool full_told_ = false;
  std::string records_;  // of this run, for a report
  io::RunStream stream_;
  std::unique_ptr<LiveMessages> messages_;

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Request> requests_;  // guarded by mutex_
  bool stopping_ = false;         // guarded by mutex_
  bool welcomed_ = true;          // guarded by mutex_: a viewer has come, or none is needed
  std::jthread thread_;
};

}  // namespace fairway::app
