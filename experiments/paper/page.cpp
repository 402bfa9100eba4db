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
:root {{ color-scheme: light dark; --page: #fff; --ink: #1a1a1a; --faint: #444; --line: #d4d8dc;
  --soft: #f4f6f8; --accent: #3949ab; --yes: #00694c; --no: #9a3c00; }}
@media screen and (prefers-color-scheme: dark) {{
  :root {{ --page: #171c21; --ink: #e6ebf0; --faint: #b4bfc9; --line: #3a444d; --soft: #232b32;
    --accent: #a5b4ff; --yes: #4fd0a0; --no: #ff9d57; }}
}}
* {{ box-sizing: border-box; }}
body {{ font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--page);
  margin: 0 auto; max-width: 1180px; padding: 1rem 1.5rem 3rem; }}
a {{ color: var(--accent); }}
nav {{ position: sticky; top: 0; display: flex; flex-wrap: wrap; gap: 0 .4rem; padding: .3rem 0;
  background: var(--page); border-bottom: 1px solid var(--line); z-index: 1; }}
nav a {{ display: inline-flex; align-items: center; min-height: 44px; padding: 0 .6rem;
  border-radius: 6px; }}
nav a[aria-current] {{ background: var(--soft); color: var(--ink); text-decoration: none; }}
h1 {{ font-size: 1.6rem; line-height: 1.2; margin: 1rem 0 .5rem; }}
h2 {{ font-size: 1.25rem; margin: 1.6rem 0 .4rem; scroll-margin-top: 60px; }}
.verdict {{ font-size: 1.35rem; font-weight: 600; margin: .4rem 0; }}
.columns {{ display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 1rem; }}
.columns section {{ border: 1px solid var(--line); border-radius: 8px; padding: .6rem .9rem; }}
.columns h2 {{ margin-top: 0; font-size: 1.05rem; }}
.columns ul {{ list-style: none; margin: 0; padding: 0; font-size: .88rem; line-height: 1.35; }}
.columns li {{ padding: .15rem 0; display: flex; gap: .5rem; }}
.columns li b {{ flex: none; width: 2.2rem; }}
table {{ border-collapse: collapse; font-size: 0.82rem; font-variant-numeric: tabular-nums; }}
.scroll {{ overflow-x: auto; margin: 1rem 0 2rem; }}
.scroll:focus-visible {{ outline: 2px solid var(--accent); }}
caption {{ text-align: left; padding-bottom: 0.5rem; color: var(--faint); }}
th, td {{ padding: 0.3rem 0.5rem; text-align: right; border-bottom: 1px solid var(--line);
  overflow-wrap: break-word; }}
th {{ vertical-align: bottom; background: var(--soft); }}
th[scope="row"], th:first-child, .words td, .words th {{ text-align: left; }}
td {{ white-space: nowrap; }}
.words td {{ white-space: normal; }}
figure {{ margin: 2rem 0; }}
figure img {{ width: 100%; height: auto; border: 1px solid var(--line); background: #fff; }}
figcaption {{ font-size: 0.9rem; color: var(--faint); }}
code {{ background: var(--soft); padding: 0.1rem 0.3rem; overflow-wrap: anywhere; }}
.holds {{ color: var(--yes); font-weight: 600; }}
.fails {{ color: var(--no); font-weight: 600; }}
@media (max-width: 700px) {{ body {{ padding: .5rem .8rem 2rem; }} }}
@media print {{ nav {{ display: none; }} figure, tr {{ break-inside: avoid; }} }}
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

// A table that is wider than a page is high: its columns become rows.
Table upright(const Table& table) {
  constexpr std::size_t kMostColumns = 8;
  const std::size_t columns = table.header.size();
  if (columns <= kMostColumns || table.rows.size() + 1 >= columns || table.rows.empty())
    return table;
  Table turned{.caption = table.caption, .header = {table.header.front()}, .rows = {}};
  for (const auto& row : table.rows)
    turned.header.push_back(row.front());
  for (std::size_t i = 1; i < columns; ++i) {
    turned.rows.push_back({table.header[i]});
    for (const auto& row : table.rows)
      turned.rows.back().push_back(i < row.size() ? row[i] : "");
  }
  return turned;
}

std::string table_html(const Table& given) {
  const Table table = upright(given);
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Table\"><table>\n<caption>" +
      escaped(table.caption) + "</caption>\n<thead><tr>";
  for (const std::string& name : table.header)
    html += "<th scope=\"col\">" + escaped(name) + "</th>";
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool first = i == 0 && row.size() > 1;
      html += first ? "<th scope=\"row\">" + escaped(row[i]) + "</th>"
                    : "<td>" + escaped(row[i]) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string findings_html(const Chapter& chapter) {
  std::string html =
      "<div class=\"scroll\"><table class=\"words\">\n<thead><tr><th scope=\"col\">Claim of the "
      "paper</th><th scope=\"col\">Our result</th><th "
      "scope=\"col\">Confirmed?</th></tr></thead>\n"
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

std::string case_file(const Chapter& chapter) { return chapter.id + ".html"; }

// Links to all pages; `here` is the file that contains them.
std::string contents(const std::vector<PageChapter>& chapters, const std::string& here) {
  std::string html = "<nav aria-label=\"Contents\">";
  const auto link = [&](const std::string& file, const std::string& text) {
    html += fmt::format("<a href=\"{}\"{}>{}</a>", file,
                        file == here ? " aria-current=\"page\"" : "", escaped(text));
  };
  link("index.html", "Verdict");
  for (const PageChapter& page : chapters)
    link(case_file(*page.chapter), page.chapter->title);
  link("timing.html", "Measured times");
  return html + "</nav>\n";
}

// Links to the parts of one page.
std::string parts_of(const PageChapter& page) {
  std::string html = "<nav aria-label=\"On this page\"><a href=\"#claims\">Claims</a>";
  if (!page.chapter->tables.empty()) html += "<a href=\"#tables\">Tables</a>";
  for (std::size_t i = 0; i < page.figures.size(); ++i)
    html += fmt::format("<a href=\"#{}\">Figure {}</a>", page.figures[i].name, i + 1);
  return html + "</nav>\n";
}

// The claims of one case in short, with a link to its page.
std::string verdict_html(const Chapter& chapter) {
  std::string html = fmt::format("<section><h2><a href=\"{}\">{}</a></h2>\n<ul>\n",
                                 case_file(chapter), escaped(chapter.title));
  for (const Finding& finding : chapter.findings) {
    html += fmt::format("<li><b class=\"{}\">{}</b><span>{}</span></li>\n",
                        finding.holds ? "holds" : "fails", finding.holds ? "yes" : "no",
                        escaped(finding.claim));
  }
  return html + "</ul></section>\n";
}

}  // namespace

std::string index_html(const std::vector<PageChapter>& chapters, const std::string& command) {
  std::size_t claims = 0;
  std::size_t confirmed = 0;
  for (const PageChapter& page : chapters) {
    claims += page.chapter->findings.size();
    for (const Finding& finding : page.chapter->findings)
      confirmed += finding.holds ? 1 : 0;
  }
  std::string html =
      fmt::format(fmt::runtime(kHead), "The paper, reproduced: Fairway") +
      contents(chapters, "index.html") +
      "<h1>The paper\u2019s tables and figures, beside Fairway\u2019s</h1>\n" +
      fmt::format("<p class=\"verdict\">{} of {} claims confirmed.</p>\n", confirmed, claims) +
      "<div class=\"columns\">\n";
  for (const PageChapter& page : chapters)
    html += verdict_html(*page.chapter);
  return html +
         "</div>\n<p>Qu, Li and Zhong, <cite>Multi-directional Safe Rectangle Corridor-Based MPC "
         "for Nonholonomic Robots Navigation in Cluttered Environments</cite> (arXiv 2512.13215), "
         "reproduced by <code>" +
         escaped(command) +
         "</code>. The paper\u2019s maps are not public: all maps here are made by this project in "
         "their manner, so shapes and orders of magnitude can be compared, single numbers cannot. "
         "The same seed gives the same pages byte for byte; every number is in <a "
         "href=\"results.json\">results.json</a>. Times differ from run to run; they are in <a "
         "href=\"timing.html\">timing.html</a>.</p>\n</body>\n</html>\n";
}

std::string case_html(const std::vector<PageChapter>& chapters, std::size_t index) {
  const PageChapter& page = chapters.at(index);
  const Chapter& chapter = *page.chapter;
  std::string html = fmt::format(fmt::runtime(kHead), escaped(chapter.title) + ": Fairway") +
                     contents(chapters, case_file(chapter)) +
                     fmt::format("<h1 id=\"{}\">{}</h1>\n", chapter.id, escaped(chapter.title)) +
                     parts_of(page) + "<p>" + escaped(chapter.setup) + "</p>\n" +
                     "<h2 id=\"claims\">Claims</h2>\n" + findings_html(chapter);
  if (!chapter.tables.empty()) html += "<h2 id=\"tables\">Tables</h2>\n";
  for (const Table& table : chapter.tables)
    html += table_html(table);
  for (const DrawnFigure& figure : page.figures)
    html += figure_html(figure);
  return html + "</body>\n</html>\n";
}

std::string timing_html(const std::vector<PageChapter>& chapters) {
  std::string html = fmt::format(fmt::runtime(kHead), "Measured times: Fairway") +
                     contents(chapters, "timing.html") + "<h1>Measured times</h1>\n";
  html += "<p>Measured in the run that wrote these pages; another run measures others.</p>\n";
  for (const PageChapter& page : chapters) {
    for (const Table& table : page.chapter->timing_tables)
      html += table_html(table);
  }
  return html + "</body>\n</html>\n";
}

}  // namespace fairway::reproduction
