// SPDX-License-Identifier: Apache-2.0
#include "playground/stepped_world.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

#include "experiments/clocks.hpp"

namespace fairway::app {

namespace {

constexpr double kFarBehind = 0.5;  // then it does not try to catch up [s]

}  // namespace

SteppedWorld::Run::Run(LiveWorld& world) : scenario(world.begin_run()), recorded(*world.messages_) {
  observers.add(world.stream_);
  observers.add(recorded);
  episode.emplace(scenario, EpisodeHooks{.clock = steady_seconds,
                                         .on_cycle = {},
                                         .physics = {},
                                         .solver = nullptr,
                                         .observer = &observers,
                                         .play = [](EpisodeControl&) { return true; }});
}

void SteppedWorld::begin() {
  const std::uint32_t next_channel = world_.messages_ ? world_.messages_->next_channel() : 0;
  world_.messages_ = std::make_unique<LiveMessages>(next_channel);
  run_ = std::make_unique<Run>(world_);
  compute_cycle();
}

void SteppedWorld::compute_cycle() {
  run_->episode->cycle();
  world_.failures_ = 0;
  world_.good_settings_ = world_.scenario_.settings;
  world_.publish();
  world_.tell_beginning(run_->episode->world().time());
  const double period = world_.scenario_.settings.navigation.control_period;
  world_.due_ = std::max(world_.due_ + period / world_.state_.speed, steady_seconds() - kFarBehind);
}

bool SteppedWorld::serve() {
  while (!world_.requests_.empty()) {
    LiveWorld::Request request = std::move(world_.requests_.front());
    world_.requests_.pop_front();
    EpisodeControl& control = *run_->episode;
    world_.carry_out(control, request);
    if (world_.holds()) {
      control.take_plans();
      const bool asked = std::holds_alternative<LiveWorld::Asked>(request);
      if (asked && !world_.again_ && !world_.step_) world_.stream_.tell_paused_world(control);
    }
    world_.stream_.tell_true_map(control.world().time(), control.world().obstacles());
    world_.publish();
    world_.tell_beginning(control.world().time());
    if (world_.again_) return true;
    if (std::exchange(world_.step_, false)) return true;
  }
  return !world_.holds() && steady_seconds() >= world_.due_;
}

double SteppedWorld::wait() const {
  if (world_.holds()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, world_.due_ - steady_seconds());
}

double SteppedWorld::advance() {
  if (stuck_) {
    if (world_.requests_.empty()) return std::numeric_limits<double>::infinity();
    world_.requests_.clear();
    stuck_ = false;
  }
  try {
    if (!run_) {
      begin();
    } else if (serve()) {
      if (world_.again_) {
        run_.reset();
        begin();
      } else {
        compute_cycle();
      }
    }
    return wait();
  } catch (const std::exception& error) {
    run_.reset();
    stuck_ = world_.failures_ >= 2;  // LiveWorld::recover would wait
    if (stuck_) {
      world_.listener_.on_notice(std::string("The run has ended: ") + error.what());
    } else {
      world_.recover(error.what());
    }
    return 0.0;
  }
}

}  // namespace fairway::app
