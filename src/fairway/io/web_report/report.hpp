// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/base/error.hpp"
#include "fairway/io/web_report/run_stream.hpp"

namespace fairway::io {

/// The replay page of a run: one self-contained HTML file.
/// @param stream  All records of a RunStream.
[[nodiscard]] std::string report_page(std::string_view stream);

/// Collects a run for `--report FILE.html`:
///
///     Report report;
///     run_episode(scenario, {.observer = &report.observer()});
///     write_file_atomically(path, report.page());
class Report {
 public:
  [[nodiscard]] EpisodeObserver& observer() noexcept { return stream_; }
  [[nodiscard]] std::string page();  ///< call once

 private:
  RunStream stream_;
};

}  // namespace fairway::io
