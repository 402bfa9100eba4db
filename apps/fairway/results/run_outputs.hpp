// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cli/command_line.hpp"
#include "fairway/base/error.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/report.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"

namespace fairway::app {

/// What --log and --report ask for: files that are made while a run goes on.
///
///     RunOutputs outputs;  add_run_options(options, outputs);
///     if (auto opened = outputs.open(); !opened) ...
///     run_episode(scenario, {.observer = outputs.observer()});
///     if (auto closed = outputs.close(); !closed) ...
class RunOutputs {
 public:
  std::string log;     ///< FILE.mcap; empty: none
  std::string report;  ///< FILE.html; empty: none

  /// Begins the files that are asked for, so that one that cannot be written is told at once. After
  /// `close` it can be called again, for the next run.
  /// @param run  Of several: what tells it from the others, put before the files' endings.
  [[nodiscard]] Expected<void> open(const std::string& run = {});

  /// Who has to watch the run; null when nothing was asked for.
  [[nodiscard]] EpisodeObserver* observer() noexcept;

  /// Finishes the files.
  [[nodiscard]] Expected<void> close();

  /// Collects the page of a run even if it is not asked for, to be taken where the run turns out to
  /// be worth it. To be called before `open`.
  void keep_page() noexcept { keep_page_ = true; }

  /// The page that plays the run. @pre keep_page was called, and since then open, not close.
  [[nodiscard]] const std::string& page();

 private:
  [[nodiscard]] bool has_page() const noexcept { return keep_page_ || !report.empty(); }

  std::string run_;
  std::optional<std::string> made_page_;
  bool keep_page_ = false;
  std::unique_ptr<io::RecordingFile> recording_;
  std::optional<io::Report> page_;
  std::optional<ObserverList> observers_;
};

/// Adds --log and --report to a command.
void add_run_options(const Options& options, RunOutputs& outputs);

}  // namespace fairway::app
