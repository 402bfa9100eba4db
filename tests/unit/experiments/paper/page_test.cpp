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

TEST(CasePage, ShowsAllPartsWithTextEscaped) {
  const Chapter chapter = small_chapter();
  const std::string html = case_html(
      {{.chapter = &chapter, .figures = {{.name = "figure", .caption = "seen", .svg = "<svg/>"}}}},
      0);
  for (const char* part : {"A &lt;title&gt; &amp; more", "set up", "claimed",
                           "&quot;came&quot; out", "a table", "<td>52</td>", "id=\"figure\"",
                           "href=\"#figure\"", "seen", "PHN2Zy8+", "figures/figure.pdf"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
}

TEST(CasePage, LoadsNoOtherFilesAndContainsNoTimes) {
  const Chapter chapter = small_chapter();
  for (const std::string& html : {case_html({{.chapter = &chapter, .figures = {}}}, 0),
                                  index_html({{.chapter = &chapter, .figures = {}}}, "command")}) {
    EXPECT_EQ(html.find("http"), std::string::npos);
    EXPECT_EQ(html.find("12.5 us"), std::string::npos);
  }
  EXPECT_NE(timing_html({{.chapter = &chapter, .figures = {}}}).find("12.5 us"), std::string::npos);
}

TEST(IndexPage, CountsConfirmedClaimsAndLinksEachCase) {
  Chapter one = small_chapter();
  one.findings.push_back({.claim = "also claimed", .outcome = "so", .holds = true});
  const std::string html = index_html({{.chapter = &one, .figures = {}}}, "command");
  EXPECT_NE(html.find("1 of 2 claims confirmed."), std::string::npos);
  EXPECT_NE(html.find("href=\"case9.html\""), std::string::npos);
  EXPECT_NE(html.find("prefers-color-scheme: dark"), std::string::npos);
}

TEST(CasePage, TurnsTablesThatAreTooWide) {
  Chapter chapter = small_chapter();
  Table wide{.caption = "wide", .header = {"method"}, .rows = {{"SRC"}}};
  for (int i = 0; i < 12; ++i) {
    wide.header.push_back("column " + std::to_string(i));
    wide.rows.front().push_back(std::to_string(100 + i));
  }
  chapter.tables = {wide};
  const std::string html = case_html({{.chapter = &chapter, .figures = {}}}, 0);
  EXPECT_NE(html.find("<th scope=\"row\">column 11</th><td>111</td>"), std::string::npos);
  EXPECT_NE(html.find("<th scope=\"col\">SRC</th>"), std::string::npos);
}

}  // namespace
}  // namespace fairway::reproduction
