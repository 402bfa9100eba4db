// SPDX-License-Identifier: Apache-2.0
#include "server/live_world.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "experiments/clocks.hpp"
#include "fairway/base/utf8_text.hpp"
#include "fairway/io/recording/exact/scenario_archive.hpp"
#include "fairway/io/web_report/report.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "server/live_maps.hpp"

namespace fairway::app {

namespace {

constexpr std::size_t kMostWaitingCommands = 256;       // commands of clients
constexpr std::size_t kMostMapsWaiting = 16;            // maps are large
constexpr std::size_t kMostWaitingWithDownloads = 300;  // commands and downloads
constexpr std::size_t kMostUploads = 8;                 // maps; the oldest makes room
constexpr std::size_t kMostRecords = 64U << 20U;        // for a report [bytes]
constexpr double kBeginningPeriod = 60.0;  // who joins late sees at least as much of the past [s]
constexpr std::size_t kBeginningBytes = 8U << 20U;    // or so much of it
constexpr std::chrono::milliseconds kPlansTaken{40};  // how often, in a world that is paused
constexpr double kServing = 0.05;                     // of a cycle, however late it is [s]
constexpr double kFarBehind = 0.5;                    // then it does not try to catch up [s]

}  // namespace

LiveWorld::LiveWorld(std::vector<MapChoice> choices, LiveListener listener, Begin begin)
    : choices_(std::move(choices)),
      num_given_(choices_.size()),
      listener_(std::move(listener)) {
  for (const MapChoice& choice : choices_)
    state_.maps.push_back(choice.name);
  left_.resize(choices_.size());
  begin_with(0, choices_.front().make());
  good_settings_ = scenario_.settings;
  welcomed_ = begin != Begin::WithViewer;
  state_.waiting = !welcomed_;
  if (begin != Begin::Stepped) thread_ = std::jthread([this] { run(); });
}

LiveWorld::~LiveWorld() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
}

void LiveWorld::ask(ClientCommand command, std::uint64_t client) {
  enqueue(Asked{.command = std::move(command), .client = client}, kMostWaitingCommands);
}

void LiveWorld::welcome() {
  {
    const std::lock_guard lock(mutex_);
    if (welcomed_) return;
    welcomed_ = true;
  }
  wake_.notify_all();
}

bool LiveWorld::use_map(Scenario scenario) {
  return enqueue(UseMap{.scenario = std::move(scenario)}, kMostMapsWaiting);
}

void LiveWorld::download(Download what, std::function<void(std::string)> done) {
  enqueue(Save{.what = what, .done = std::move(done)}, kMostWaitingWithDownloads);
}

bool LiveWorld::enqueue(Request request, std::size_t most_waiting) {
  {
    const std::lock_guard lock(mutex_);
    if (requests_.size() >= most_waiting) return false;
    requests_.push_back(std::move(request));
  }
  wake_.notify_all();
  return true;
}

void LiveWorld::run() {
  std::uint32_t next_channel = 0;
  for (bool stopping = false; !stopping;) {
    messages_ = std::make_unique<LiveMessages>(next_channel);
    try {
      run_once();
    } catch (const std::exception& error) {
      recover(error.what());
    }
    next_channel = messages_->next_channel();
    const std::lock_guard lock(mutex_);
    stopping = stopping_;
  }
}

// @return the scenario of the new run.
Scenario LiveWorld::begin_run() {
  again_ = false;
  fresh_ = true;
  full_told_ = false;
  told_beginning_ = 0.0;
  told_since_ = 0;
  due_ = steady_seconds();
  records_.clear();
  scenario_ = as_saved();
  removed_.assign(scenario_.robots.size(), false);
  state_.halted = false;
  Scenario scenario = scenario_;
  scenario.settings.planning.background = true;  // so that no cycle waits for a plan
  tell_state();
  return scenario;
}

void LiveWorld::run_once() {
  const Scenario scenario = begin_run();
  io::RunMessages recorded(*messages_);
  ObserverList observers;
  observers.add(stream_);
  observers.add(recorded);
  static_cast<void>(
      run_episode(scenario, {.clock = steady_seconds,
                             .on_cycle = {},
                             .solver = nullptr,
                             .observer = &observers,
                             .play = [this](EpisodeControl& control) { return play(control); }}));
}

// The world continues however a run ended. It tries the settings of the last run that began, then
// the first choice, and then waits for a request.
void LiveWorld::recover(const std::string& reason) {
  listener_.on_notice("The run has ended: " + one_line(reason));
  ++failures_;
  if (failures_ == 1) scenario_.settings = good_settings_;
  if (failures_ == 2) begin_with(0, choices_.front().make());
  if (failures_ <= 2) return;
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return stopping_ || !requests_.empty(); });
  requests_.clear();
}

// Between two cycles: publishes new records, serves requests, and waits until the next cycle is
// due.
bool LiveWorld::play(EpisodeControl& control) {
  failures_ = 0;
  good_settings_ = scenario_.settings;
  publish();
  tell_beginning(control.world().time());
  due_ = std::max(due_ + scenario_.settings.navigation.control_period / state_.speed,
                  steady_seconds() - kFarBehind);
  serve_requests(control);
  if (again_) return false;
  const std::lock_guard lock(mutex_);
  return !stopping_;
}

// Requests are served in every cycle, however late the world is. The world advances, however many
// requests there are.
void LiveWorld::serve_requests(EpisodeControl& control) {
  const double least = steady_seconds() + kServing;
  while (true) {
    std::optional<Request> request = next_request(std::max(due_, least));
    if (!request && !waits_on()) return;
    if (request) {
      carry_out(control, *request);
      const bool asked = std::holds_alternative<Asked>(*request);
      if (asked && holds() && !again_ && !step_) stream_.tell_paused_world(control);
    } else {
      control.take_plans();
    }
    stream_.tell_true_map(control.world().time(), control.world().obstacles());
    publish();
    tell_beginning(control.world().time());
    if (again_ || std::exchange(step_, false)) return;
  }
}

bool LiveWorld::holds() const { return state_.paused || state_.waiting; }

// Returns whether the world does not change without a request.
bool LiveWorld::waits_on() {
  const std::lock_guard lock(mutex_);
  return !stopping_ && holds();
}

// Bounds the past that new viewers receive, also while a paused world is painted.
void LiveWorld::tell_beginning(double time) {
  if (time < told_beginning_ + kBeginningPeriod && told_since_ < kBeginningBytes) return;
  told_beginning_ = time;
  told_since_ = 0;
  listener_.on_beginning(stream_.beginning(time));
}

// Waits for a request. Returns none when the next cycle is due, at the end, or when serving has
// lasted `until` [s].
std::optional<LiveWorld::Request> LiveWorld::next_request(double until) {
  std::unique_lock lock(mutex_);
  const auto asked = [this] { return stopping_ || !requests_.empty(); };
  if (state_.waiting && welcomed_) {
    state_.waiting = false;
    due_ = steady_seconds();
    lock.unlock();
    tell_state();
    lock.lock();
  }
  if (state_.paused || state_.waiting) {
    wake_.wait_for(lock, kPlansTaken, [&] { return asked() || state_.waiting == welcomed_; });
  } else {
    wake_.wait_for(lock, std::chrono::duration<double>(due_ - steady_seconds()), asked);
  }
  const bool enough = !holds() && steady_seconds() > until;
  if (stopping_ || requests_.empty() || enough) return std::nullopt;
  Request request = std::move(requests_.front());
  requests_.pop_front();
  return request;
}

void LiveWorld::publish() {
  if (std::string records = stream_.take(); !records.empty()) {
    told_since_ += records.size();
    if (records_.size() < kMostRecords) records_ += records;
    const auto& tell = fresh_ ? listener_.on_run : listener_.on_records;
    tell(std::move(records));
    fresh_ = false;
  }
  if (!full_told_ && (messages_->full() || records_.size() >= kMostRecords)) {
    full_told_ = true;
    listener_.on_notice(
        "The recording is full: from now on nothing is saved. Reset run begins a new one.");
  }
  listener_.on_messages(messages_->take());
}

void LiveWorld::tell_state() {
  state_.sensing = scenario_.sensing.sensing;
  state_.noise = noise_of(scenario_.sensing);
  state_.undo = history_.undo_label();
  state_.redo = history_.redo_label();
  listener_.on_state(state_);
}

void LiveWorld::carry_out(EpisodeControl& control, Request& request) {
  if (auto* asked = std::get_if<Asked>(&request)) {
    client_ = asked->client;
    std::visit([&](const auto& what) { apply(control, what); }, asked->command);
  } else if (auto* save_request = std::get_if<Save>(&request)) {
    save(*save_request);
  } else if (auto* map = std::get_if<UseMap>(&request)) {
    if (choices_.size() == num_given_ + kMostUploads) {
      const auto oldest = static_cast<std::ptrdiff_t>(num_given_);
      choices_.erase(choices_.begin() + oldest);
      state_.maps.erase(state_.maps.begin() + oldest);
      left_.erase(left_.begin() + oldest);
      if (state_.map == num_given_) state_.edited = false;  // it is dropped with its edits
      if (state_.map > num_given_) --state_.map;
    }
    const std::string name = map->scenario.name;
    choices_.push_back(
        {.name = name, .make = [scenario = std::move(map->scenario)] { return scenario; }});
    state_.maps.push_back(name);
    left_.emplace_back();
    apply(control, ChooseMapCommand{.index = choices_.size() - 1});
  }
}

void LiveWorld::save(const Save& request) const {
  switch (request.what) {
    case Download::Recording:
      request.done(messages_->recording());
      return;
    case Download::Scenario:
      request.done(io::zip_archive(io::scenario_files(as_saved())));
      return;
    case Download::Report:
      request.done(io::report_page(records_));
      return;
  }
}

}  // namespace fairway::app
