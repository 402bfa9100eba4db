// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/report.hpp"

#include <array>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "cli/output.hpp"
#include "cli/provenance.hpp"
#include "experiments/paper/page.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::reproduction {

namespace {

constexpr std::array kFormats = {std::pair{io::PictureFormat::Svg, "svg"},
                                 std::pair{io::PictureFormat::Png, "png"},
                                 std::pair{io::PictureFormat::Pdf, "pdf"}};

// Writes a figure's three files, and keeps the SVG for the page.
Expected<DrawnFigure> write_figure(const std::string& folder, const Figure& figure) {
  DrawnFigure drawn{.name = figure.name, .caption = figure.caption, .svg = {}};
  for (const auto& [format, ending] : kFormats) {
    Expected<std::string> bytes = figure.draw(format);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string path = fmt::format("{}/figures/{}.{}", folder, figure.name, ending);
    if (const auto done = io::write_file_atomically(path, *bytes); !done) {
      return tl::unexpected(done.error());
    }
    if (format == io::PictureFormat::Svg) drawn.svg = std::move(*bytes);
  }
  return drawn;
}

Json chapter_json(const Chapter& chapter) {
  Json findings = Json::array();
  for (const Finding& finding : chapter.findings) {
    findings.push_back(
        {{"claim", finding.claim}, {"outcome", finding.outcome}, {"holds", finding.holds}});
  }
  Json figures = Json::array();
  for (const Figure& figure : chapter.figures)
    figures.push_back({{"name", figure.name}, {"caption", figure.caption}});
  return {{"title", chapter.title},          {"setup", chapter.setup},
          {"findings", std::move(findings)}, {"faults", chapter.faults},
          {"figures", std::move(figures)},   {"numbers", chapter.numbers}};
}

Json results_json(const std::vector<Chapter>& chapters, const ReportInfo& info) {
  Json all = {
      {"paper", "arXiv 2512.13215"},
      {"command", info.command},
      {"version", info.version},
      {"solver", info.solver},
      {"seed", info.seed},
      {"note",
       "Everything but `timing` is the same for the same seed, solver and build. The maps are "
       "this project's own, made in the manner of the paper's, which are not public."}};
  Json timing = {{"note", "measured in this run; differs from run to run"}};
  for (const Chapter& chapter : chapters) {
    all[chapter.id] = chapter_json(chapter);
    timing[chapter.id] = chapter.timing;
  }
  all["timing"] = std::move(timing);
  app::add_provenance(
      all, {.schema = "reproduce.v1", .files = {}, .seed = info.seed, .settings = &info.settings});
  return all;
}

}  // namespace

Expected<void> make_report_folder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder + "/figures", failed);
  if (failed) return fail("--out: expected a folder that can be created, found " + folder);
  for (const char* file : {"results.json", "index.html", "timing.html", "figures/probe"}) {
    if (auto writable = io::check_writable(folder + "/" + file); !writable) return writable;
  }
  return {};
}

Expected<void> write_report(const std::string& folder,
                            const std::vector<Chapter>& chapters,
                            const ReportInfo& info) {
  if (auto made = make_report_folder(folder); !made) return made;
  std::vector<PageChapter> pages;
  for (const Chapter& chapter : chapters) {
    PageChapter page{.chapter = &chapter, .figures = {}};
    for (const Figure& figure : chapter.figures) {
      Expected<DrawnFigure> drawn = write_figure(folder, figure);
      if (!drawn) return tl::unexpected(drawn.error());
      page.figures.push_back(std::move(*drawn));
    }
    pages.push_back(std::move(page));
  }
  std::vector<std::pair<std::string, std::string>> files = {
      {"/results.json", app::json_text(results_json(chapters, info))},
      {"/timing.html", timing_html(pages)}};
  for (std::size_t i = 0; i < pages.size(); ++i)
    files.emplace_back("/" + chapters[i].id + ".html", case_html(pages, i));
  files.emplace_back("/index.html", index_html(pages, info.command));
  for (const auto& [name, text] : files) {
    if (auto done = io::write_file_atomically(folder + name, text); !done) return done;
  }
  return {};
}

std::string report_summary(const std::string& folder, const std::vector<Chapter>& chapters) {
  std::string text;
  for (const Chapter& chapter : chapters) {
    text += chapter.title + "\n";
    for (const Finding& finding : chapter.findings) {
      text += fmt::format("  {:<4} {}: {}\n", finding.holds ? "yes" : "NO", finding.claim,
                          finding.outcome);
    }
  }
  return text + "See " + folder + "/index.html\n";
}

}  // namespace fairway::reproduction
