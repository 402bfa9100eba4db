// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "fairway/base/error.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/recording/report.hpp"
#include "fairway/simulation/observer_list.hpp"

namespace fairway::app {

/// What --log and --report ask for: files that are made while a run goes on.
///
///     RunOutputs outputs;  add_run_options(*sub, outputs);
///     if (auto opened = outputs.open(); !opened) ...
///     run_episode(scenario, {.observer = outputs.observer()});
///     if (auto closed = outputs.close(); !closed) ...
class RunOutputs {
 public:
  std::string log;     ///< FILE.mcap; empty: none
  std::string report;  ///< FILE.html; empty: none

  /// Begins the files that are asked for, so that one that cannot be written is told at once.
  [[nodiscard]] Expected<void> open();

  /// Who has to watch the run; null when nothing was asked for.
  [[nodiscard]] EpisodeObserver* observer() noexcept;

  /// Finishes the files.
  [[nodiscard]] Expected<void> close();

 private:
  std::unique_ptr<io::RecordingFile> recording_;
  io::Report page_;
  ObserverList observers_;
};

/// Adds --log and --report to a command.
void add_run_options(CLI::App& command, RunOutputs& outputs);

}  // namespace fairway::app
