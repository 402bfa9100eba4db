// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/exchange_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/paper/figures/panels.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;
using Kind = io::LegendEntry::Kind;

constexpr std::array kShares = {0.2, 0.4, 0.6, 1.0};  // of the run's time

const Exchange& first_run(const ExchangeRuns& runs, ExchangeKind kind) {
  return runs.front().at(static_cast<std::size_t>(kind));
}

const io::Stroke kPlanStroke{.color = io::palette::kPurple, .width = 1.6};

// Line styles differ between robots, so that colour is not needed.
std::vector<double> dash_of(std::size_t robot) {
  constexpr std::array<double, kExchangeRobots> kLength = {0.0, 6.0, 3.0, 1.2};
  if (robot == 0) return {};
  return {kLength.at(robot), 1.5};
}

io::Color robot_color(std::size_t robot) {
  constexpr std::array kColors = {io::palette::kBlue, io::palette::kVermilion, io::palette::kBlack,
                                  io::palette::kOrange};
  return kColors.at(robot);
}

std::vector<io::LegendEntry> robot_legend() {
  std::vector<io::LegendEntry> entries;
  for (std::size_t i = 0; i < kExchangeRobots; ++i) {
    entries.push_back({.kind = Kind::Line,
                       .text = fmt::format("robot {}", i + 1),
                       .stroke = {.color = robot_color(i), .width = 1.6, .dash = dash_of(i)}});
  }
  return entries;
}

void draw_moment(io::Canvas& canvas,
                 const io::PlotAxes& axes,
                 const Exchange& run,
                 std::size_t at) {
  const ExchangeMoment& moment = run.moments[at];
  const io::Stroke keep_out{.color = kOursColor, .width = 0.8};
  for (const Pose2& pose : moment.poses) {
    canvas.circle(axes.at(pose.position), 0.5 * keep_out_distance(run.settings) * axes.scale(),
                  kOursColor.faded(0.2), &keep_out);
  }
  for (std::size_t i = 0; i < kExchangeRobots; ++i) {
    std::vector<Vector2d> track;
    for (std::size_t k = 0; k <= at; ++k)
      track.push_back(run.moments[k].poses.at(i).position);
    canvas.line(axes.at(track), {.color = robot_color(i), .width = 1.5, .dash = dash_of(i)});
  }
  for (std::size_t i = 0; i < kExchangeRobots; ++i) {
    canvas.cross(axes.at(run.goals.at(i)), 2.6, {.color = robot_color(i), .width = 1.2});
    canvas.line(axes.at(moment.plans.at(i)), kPlanStroke);
    const Pose2& pose = moment.poses.at(i);
    const io::Stroke body{.color = robot_color(i), .width = 1.2};
    const Vector2d center = axes.at(pose.position);
    const double radius = run.settings.robot.radius * axes.scale();
    canvas.circle(center, radius, io::palette::kWhite.faded(0.8), &body);
    canvas.line(center, center + radius * Vector2d(std::cos(pose.heading), -std::sin(pose.heading)),
                body);
  }
}

Panel separation_panel(const std::shared_ptr<const ExchangeRuns>& runs, ExchangeKind kind) {
  const Exchange& run = first_run(*runs, kind);
  return {.title = to_text(kind),
          .data = {.min = {0.0, 0.0}, .max = {std::max(1.0, run.time), 6.0}},
          .x_name = "time [s]",
          .y_name = "to the nearest centre [m]",
          .grid = true,
          .draw = [runs, kind](io::Canvas& canvas, const io::PlotAxes& axes) {
            const Exchange& shown = first_run(*runs, kind);
            const double right = axes.data().max.x();
            const double contact = 2.0 * shown.settings.robot.radius;
            const std::array touching = {Vector2d(0.0, 0.0), Vector2d(right, 0.0),
                                         Vector2d(right, contact), Vector2d(0.0, contact)};
            canvas.polygon(axes.at(touching), io::palette::kGrey.faded(0.35), nullptr);
            const double keep_out = keep_out_distance(shown.settings);
            canvas.line(axes.at(Vector2d(0.0, keep_out)), axes.at(Vector2d(right, keep_out)),
                        {.color = kOursColor, .width = 1.2});
            for (std::size_t i = 0; i < kExchangeRobots; ++i) {
              std::vector<Vector2d> curve;
              for (const ExchangeMoment& moment : shown.moments)
                curve.emplace_back(moment.time, Exchange::nearest(moment, i));
              canvas.line(axes.at(curve),
                          {.color = robot_color(i), .width = 1.3, .dash = dash_of(i)});
            }
          }};
}

}  // namespace

Figure snapshot_figure(const std::shared_ptr<const ExchangeRuns>& runs, ExchangeKind kind) {
  const bool paper = kind == ExchangeKind::Ismpc;
  return {
      .name = paper ? "case3_figure11_snapshots" : "case3_snapshots_ours",
      .caption = fmt::format(
          "{}four robots that exchange places, {} (run 1). Discs: half of the {} m that the "
          "controller keeps between centres, so that discs may touch but not overlap; "
          "purple: predicted trajectories.",
          paper ? "Figure 11: " : "As Figure 11: ", to_text(kind),
          fixed(keep_out_distance(first_run(*runs, kind).settings), 1)),
      .draw = [runs, kind](io::PictureFormat format) {
        const Exchange& run = first_run(*runs, kind);
        PanelPicture picture{.columns = 2, .legend = robot_legend(), .panels = {}};
        picture.legend.push_back(
            {.kind = Kind::Line, .text = "predicted trajectory", .stroke = kPlanStroke});
        picture.legend.push_back({.kind = Kind::Ring,
                                  .text = "half the keep-out distance",
                                  .stroke = {.color = kOursColor, .width = 0.8},
                                  .fill = kOursColor.faded(0.2)});
        picture.legend.push_back({.kind = Kind::Cross, .text = "goal", .stroke = {.width = 1.2}});
        for (const double share : kShares) {
          const auto last = static_cast<double>(run.moments.size() - 1);
          const auto at = static_cast<std::size_t>(std::lround(share * last));
          picture.panels.push_back(
              {.title = fmt::format("{} s", fixed(run.moments[at].time, 1)),
               .data = {.min = {-5.0, -5.0}, .max = {5.0, 5.0}},
               .draw = [runs, kind, at](io::Canvas& canvas, const io::PlotAxes& axes) {
                 draw_moment(canvas, axes, first_run(*runs, kind), at);
               }});
        }
        return draw_panels(picture, format);
      }};
}

Figure separation_figure(const std::shared_ptr<const ExchangeRuns>& runs) {
  return {.name = "case3_separation",
          .caption =
              "Case 3, run 1: distance from each robot's centre to the nearest other centre. In "
              "the grey band bodies would touch; the green line is the distance that the "
              "controller keeps.",
          .draw = [runs](io::PictureFormat format) {
            PanelPicture picture{
                .columns = 2, .ratio = 0.8, .legend = robot_legend(), .panels = {}};
            picture.legend.push_back({.kind = Kind::Line,
                                      .text = "keep-out distance",
                                      .stroke = {.color = kOursColor, .width = 1.2}});
            picture.legend.push_back({.kind = Kind::Area,
                                      .text = "contact",
                                      .stroke = {.color = io::palette::kGrey, .width = 0.5},
                                      .fill = io::palette::kGrey.faded(0.35)});
            for (const ExchangeKind kind : kComparedExchanges)
              picture.panels.push_back(separation_panel(runs, kind));
            return draw_panels(picture, format);
          }};
}

}  // namespace fairway::reproduction
