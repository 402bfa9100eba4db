// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/paper/chapter.hpp"

namespace fairway::reproduction {

/// A figure with the bytes of its SVG file, for inclusion in a page.
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

/// The self-contained page with all figures and tables. It contains no measured times, so that
/// equal seeds give equal bytes; it displays timing.html from the same folder.
[[nodiscard]] std::string page_html(const std::vector<PageChapter>& chapters,
                                    const std::string& command);

/// The measured times.
[[nodiscard]] std::string timing_html(const std::vector<PageChapter>& chapters);

}  // namespace fairway::reproduction
