// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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

/// The first page: how many claims are confirmed, each claim in short, and links to the cases. It
/// contains no measured times, so that equal seeds give equal bytes.
[[nodiscard]] std::string index_html(const std::vector<PageChapter>& chapters,
                                     const std::string& command);

/// The self-contained page of one case, CASE.html, with its claims, tables and figures; no times.
[[nodiscard]] std::string case_html(const std::vector<PageChapter>& chapters, std::size_t index);

/// The measured times.
[[nodiscard]] std::string timing_html(const std::vector<PageChapter>& chapters);

}  // namespace fairway::reproduction
