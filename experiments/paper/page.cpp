// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/page.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "fairway/io/base64.hpp"

namespace fairway::reproduction {

namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{}</title>
<style>
:root {{ color-scheme: light; }}
body {{ font: 16px/1.5 system-ui, sans-serif; color: #1a1a1a; background: #fff; margin: 0 auto;
  max-width: 1000px; padding: 1.5rem; }}
h1 {{ font-size: 1.7rem; line-height: 1.2; }}
h2 {{ font-size: 1.3rem; margin-top: 3rem; border-top: 2px solid #0072b2; padding-top: 1rem; }}
table {{ border-collapse: collapse; font-size: 0.85rem; font-variant-numeric: tabular-nums; }}
.scroll {{ overflow-x: auto; margin: 1rem 0 2rem; }}
caption {{ text-align: left; padding-bottom: 0.5rem; color: #444; }}
th, td {{ padding: 0.3rem 0.6rem; text-align: right; border-bottom: 1px solid #ddd; }}
th {{ vertical-align: bottom; background: #f4f6f8; }}
th:first-child, td:first-child, .words td, .words th {{ text-align: left; }}
td {{ white-space: nowrap; }}
.words td {{ white-space: normal; }}
figure {{ margin: 2rem 0; }}
figure img {{ width: 100%; height: auto; border: 1px solid #ddd; }}
figcaption {{ font-size: 0.9rem; color: #444; }}
code {{ background: #f4f6f8; padding: 0.1rem 0.3rem; }}
object {{ width: 100%; height: {}px; border: 1px solid #ddd; }}
.holds {{ color: #00694c; font-weight: 600; }}
.fails {{ color: #a34700; font-weight: 600; }}
</style>
</head>
<body>
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string table_html(const Table& table) {
  std::string html = "<div class=\"scroll\"><table>\n<caption>" + escaped(table.caption) +
                     "</caption>\n<thead><tr>";
  for (const std::string& name : table.header)
    html += "<th scope=\"col\">" + escaped(name) + "</th>";
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& cell : row)
      html += "<td>" + escaped(cell) + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string findings_html(const Chapter& chapter) {
  std::string html =
      "<div class=\"scroll\"><table class=\"words\">\n<thead><tr><th scope=\"col\">claim of the "
      "paper</th><th scope=\"col\">result here</th><th "
      "scope=\"col\">holds</th></tr></thead>\n"
      "<tbody>\n";
  for (const Finding& finding : chapter.findings) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"{}\">{}</td></tr>\n",
                        escaped(finding.claim), escaped(finding.outcome),
                        finding.holds ? "holds" : "fails", finding.holds ? "yes" : "no");
  }
  return html + "</tbody></table></div>\n";
}

std::string figure_html(const DrawnFigure& figure) {
  const std::string caption = escaped(figure.caption);
  return fmt::format(
      "<figure id=\"{0}\">\n<img alt=\"{1}\" src=\"data:image/svg+xml;base64,{2}\">\n"
      "<figcaption>{1} Files: <a href=\"figures/{0}.svg\">SVG</a>, <a "
      "href=\"figures/{0}.png\">PNG</a>, <a href=\"figures/{0}.pdf\">PDF</a>.</figcaption>\n"
      "</figure>\n",
      figure.name, caption, io::to_base64(figure.svg));
}

std::size_t timing_rows(const std::vector<PageChapter>& chapters) {
  std::size_t rows = 0;
  for (const PageChapter& page : chapters) {
    for (const Table& table : page.chapter->timing_tables)
      rows += table.rows.size() + 4;
  }
  return rows;
}

}  // namespace

std::string page_html(const std::vector<PageChapter>& chapters, const std::string& command) {
  constexpr std::size_t kRowHeight = 32;  // of the frame around the times [px]
  const std::size_t frame = 80 + kRowHeight * timing_rows(chapters);
  std::string html =
      fmt::format(fmt::runtime(kHead), "The paper, reproduced: Fairway", frame) +
      "<h1>The paper\u2019s tables and figures, beside ours</h1>\n"
      "<p>Qu, Li and Zhong, <cite>Multi-directional Safe Rectangle Corridor-Based MPC for "
      "Nonholonomic Robots Navigation in Cluttered Environments</cite> (arXiv 2512.13215), "
      "reproduced by <code>" +
      escaped(command) +
      "</code>. The paper\u2019s maps are not public: all maps here are made by this project in "
      "their manner, so shapes and orders of magnitude can be compared, single numbers cannot. The "
      "same seed gives the same page byte for byte; every number is in <a "
      "href=\"results.json\">results.json</a>.</p>\n";
  for (const PageChapter& page : chapters) {
    const Chapter& chapter = *page.chapter;
    html += fmt::format("<h2 id=\"{}\">{}</h2>\n<p>{}</p>\n", chapter.id, escaped(chapter.title),
                        escaped(chapter.setup));
    html += findings_html(chapter);
    for (const Table& table : chapter.tables)
      html += table_html(table);
    for (const DrawnFigure& figure : page.figures)
      html += figure_html(figure);
  }
  html +=
      "<h2 id=\"timing\">Measured times</h2>\n<p>Times differ from run to run; they are kept out "
      "of this page, in timing.html beside it.</p>\n<object type=\"text/html\" "
      "data=\"timing.html\">See <a href=\"timing.html\">timing.html</a>.</object>\n";
  return html + "</body>\n</html>\n";
}

std::string timing_html(const std::vector<PageChapter>& chapters) {
  std::string html = fmt::format(fmt::runtime(kHead), "Measured times: Fairway", 0);
  html += "<p>Measured in the run that wrote this page; another run measures others.</p>\n";
  for (const PageChapter& page : chapters) {
    for (const Table& table : page.chapter->timing_tables)
      html += table_html(table);
  }
  return html + "</body>\n</html>\n";
}

}  // namespace fairway::reproduction
