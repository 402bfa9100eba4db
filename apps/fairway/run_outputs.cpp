// SPDX-License-Identifier: Apache-2.0
#include "run_outputs.hpp"

#include <utility>

#include "output.hpp"

namespace fairway::app {

Expected<void> RunOutputs::open() {
  if (const auto possible = check_output(report); !possible) return possible;
  if (!report.empty()) observers_.add(page_.observer());
  if (log.empty()) return {};
  auto file = io::RecordingFile::create(log);
  if (!file) return tl::unexpected(file.error());
  recording_ = *std::move(file);
  observers_.add(recording_->observer());
  return {};
}

EpisodeObserver* RunOutputs::observer() noexcept {
  return log.empty() && report.empty() ? nullptr : &observers_;
}

Expected<void> RunOutputs::close() {
  if (recording_) {
    if (const auto closed = recording_->close(); !closed) return closed;
  }
  return report.empty() ? Expected<void>{} : write_output(report, page_.page());
}

void add_run_options(CLI::App& command, RunOutputs& outputs) {
  command.add_option("--log", outputs.log, "Record all of the run, for Foxglove and `replay`")
      ->type_name("FILE.mcap");
  command.add_option("--report", outputs.report, "Write a page that plays the run")
      ->type_name("FILE.html");
}

}  // namespace fairway::app
