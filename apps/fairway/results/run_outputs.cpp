// SPDX-License-Identifier: Apache-2.0
#include "results/run_outputs.hpp"

#include <filesystem>
#include <utility>

#include "cli/output.hpp"

namespace fairway::app {

namespace {

// Maps "films/run.html" and the run "world_000" to "films/run_world_000.html".
std::string name_of_run(const std::string& file, const std::string& run) {
  if (file.empty() || run.empty()) return file;
  std::filesystem::path path(file);
  path.replace_filename(path.stem().string() + "_" + run + path.extension().string());
  return path.string();
}

}  // namespace

Expected<void> RunOutputs::open(const std::string& run) {
  run_ = run;
  observers_.emplace();
  page_.emplace();
  recording_.reset();
  made_page_.reset();
  if (auto possible = check_output(name_of_run(report, run)); !possible) return possible;
  if (has_page()) observers_->add(page_->observer());
  if (log.empty()) return {};
  auto file = io::RecordingFile::create(name_of_run(log, run));
  if (!file) return tl::unexpected(file.error());
  recording_ = *std::move(file);
  observers_->add(recording_->observer());
  return {};
}

const std::string& RunOutputs::page() {
  if (!made_page_) made_page_ = page_->page();
  return *made_page_;
}

EpisodeObserver* RunOutputs::observer() noexcept {
  return log.empty() && !has_page() ? nullptr : &*observers_;
}

Expected<void> RunOutputs::close() {
  if (recording_) {
    if (auto closed = recording_->close(); !closed) return closed;
  }
  return report.empty() ? Expected<void>{} : write_output(name_of_run(report, run_), page());
}

void add_run_options(const Options& options, RunOutputs& outputs) {
  options.add("--log", outputs.log, "Record the whole run, for Foxglove and `replay`")
      .type_name("FILE.mcap");
  options.add("--report", outputs.report, "Write a page that replays the run")
      .type_name("FILE.html");
}

}  // namespace fairway::app
