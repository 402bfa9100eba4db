// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/paper/chapter.hpp"

namespace fairway::reproduction {

/// A figure with the bytes of its SVG file, for a page to hold.
struct DrawnFigure {
  std::string name;
  std::string caption;
  std::string svg;
};

/// A chapter as the page shows it.
struct PageChapter {
  const Chapter* chapter = nullptr;
  std::vector<DrawnFigure> figures;
};

/// The page: all figures and tables, self-contained. It holds no measured time, so that the same
/// seed gives the same bytes; it shows timing.html, which has the times, where that lies beside it.
[[nodiscard]] std::string page_html(const std::vector<PageChapter>& chapters,
                                    const std::string& command);

/// The measured times.
[[nodiscard]] std::string timing_html(const std::vector<PageChapter>& chapters);

}  // namespace fairway::reproduction
