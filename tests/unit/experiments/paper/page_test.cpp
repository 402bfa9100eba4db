// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/page.hpp"

#include <gtest/gtest.h>

namespace fairway::reproduction {
namespace {

Chapter small_chapter() {
  Chapter chapter{.id = "case9", .title = "A <title> & more", .setup = "set up"};
  chapter.findings = {{.claim = "claimed", .outcome = "\"came\" out", .holds = false}};
  chapter.tables = {{.caption = "a table", .header = {"method", "NC"}, .rows = {{"SRC", "52"}}}};
  chapter.timing_tables = {{.caption = "times", .header = {"method"}, .rows = {{"12.5 us"}}}};
  return chapter;
}

TEST(Page, ShowsAllPartsWithTextEscaped) {
  const Chapter chapter = small_chapter();
  const std::string html = page_html(
      {{.chapter = &chapter, .figures = {{.name = "figure", .caption = "seen", .svg = "<svg/>"}}}},
      "fairway reproduce case9");
  for (const char* part :
       {"A &lt;title&gt; &amp; more", "set up", "claimed", "&quot;came&quot; out", "a table",
        "<td>52</td>", "id=\"figure\"", "seen", "PHN2Zy8+", "figures/figure.pdf"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
}

TEST(Page, LoadsNoOtherFilesAndContainsNoTimes) {
  const Chapter chapter = small_chapter();
  const std::string html = page_html({{.chapter = &chapter, .figures = {}}}, "command");
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html.find("12.5 us"), std::string::npos);
  EXPECT_NE(timing_html({{.chapter = &chapter, .figures = {}}}).find("12.5 us"), std::string::npos);
}

}  // namespace
}  // namespace fairway::reproduction
