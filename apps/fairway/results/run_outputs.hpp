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

/// Writes the files of --log and --report during a run.
///
///     RunOutputs outputs;  add_run_options(options, outputs);
///     if (auto opened = outputs.open(); !opened) ...
///     run_episode(scenario, {.observer = outputs.observer()});
///     if (auto closed = outputs.close(); !closed) ...
class RunOutputs {
 public:
  std::string log;     ///< FILE.mcap; empty: none
  std::string report;  ///< FILE.html; empty: none

  /// Opens the requested files, so that an unwritable one is reported before the run. It can be
  /// called again after `close`, for the next run.
  /// @param run  Name of one of several runs, inserted before the files' suffixes.
  [[nodiscard]] Expected<void> open(const std::string& run = {});

  /// The observer that the run needs; null if no file was requested.
  [[nodiscard]] EpisodeObserver* observer() noexcept;

  /// Finishes the files.
  [[nodiscard]] Expected<void> close();

  /// Collects the page of a run even without --report, so that the caller can store it later. Call
  /// it before `open`.
  void keep_page() noexcept { keep_page_ = true; }

  /// The page that replays the run. @pre after keep_page, open was called and close was not.
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
