// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/drive_figures.hpp"

#include <algorithm>
#include <array>

#include "experiments/paper/figures/drive_style.hpp"
#include "experiments/paper/figures/panels.hpp"
#include "experiments/paper/tables/text_format.hpp"
#include "fairway/io/drawing/map_raster.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;
using Kind = io::LegendEntry::Kind;

constexpr std::array kShownDrivers = {DriverKind::Ismpc, DriverKind::Smpc, DriverKind::Ours};

// The driver's successive targets: seeds, or centroids of overlaps.
std::vector<Vector2d> targets_of(const Drive& drive, DriverKind kind) {
  std::vector<Vector2d> targets;
  const Corridor& corridor = drive.plan.corridor;
  for (std::size_t i = 1; i < corridor.rectangles.size(); ++i) {
    if (kind != DriverKind::Smpc) {
      targets.push_back(corridor.rectangles[i].seed);
      continue;
    }
    const OverlapPatch patch = overlap(corridor.admissible(i - 1), corridor.admissible(i));
    if (patch.count > 0) targets.push_back(patch.centroid());
  }
  return targets;
}

void draw_ends(io::Canvas& canvas, const io::PlotAxes& axes, const Drive& drive) {
  const io::Stroke rim{.color = io::palette::kBlack, .width = 1.0};
  canvas.circle(axes.at(drive.rows.front().pose.position), 3.0, io::palette::kWhite, &rim);
  canvas.cross(axes.at(drive.plan.goal.position), 3.5, {.width = 1.4});
}

const io::Stroke kCorridorSide{.color = io::palette::kGrey, .width = 0.6};

void draw_corridor(io::Canvas& canvas, const io::PlotAxes& axes, const Corridor& corridor) {
  for (const OrientedRectangle& rectangle : corridor.rectangles)
    canvas.polygon(axes.at(rectangle.corners()), io::palette::kGrey.faded(0.06), &kCorridorSide);
}

Panel drive_panel(const std::shared_ptr<const DriveRuns>& runs,
                  const std::shared_ptr<const OccupancyGrid>& grid,
                  DriverKind kind,
                  const char* letter) {
  const Drive& shown = runs->maps.front().of(kind);
  return {.title = fmt::format("{} {}: {} m, {} s", letter, to_text(kind), fixed(shown.length, 1),
                               fixed(shown.time, 1)),
          .data = bounds_of(*grid),
          .draw = [runs, grid, kind](io::Canvas& canvas, const io::PlotAxes& axes) {
            const Drive& drive = runs->maps.front().of(kind);
            draw_map_within(canvas, axes, *grid);
            draw_corridor(canvas, axes, drive.plan.corridor);
            canvas.line(axes.at(track_of(drive)), track_stroke(kind));
            const io::Stroke rim{.color = io::palette::kBlack, .width = 0.4};
            for (const Vector2d& target : targets_of(drive, kind))
              canvas.circle(axes.at(target), 1.9, io::palette::kYellow, &rim);
            draw_ends(canvas, axes, drive);
          }};
}

std::vector<io::LegendEntry> track_legend() {
  std::vector<io::LegendEntry> entries;
  for (const DriverKind kind : kShownDrivers)
    entries.push_back({.kind = Kind::Line, .text = to_text(kind), .stroke = track_stroke(kind)});
  return entries;
}

// One speed of one driver over time, as a staircase because a command is constant during its cycle.
std::vector<Vector2d> speed_curve(const Drive& drive, double Twist2::*speed) {
  std::vector<Vector2d> curve;
  for (const TraceRow& row : drive.rows) {
    if (!curve.empty()) curve.emplace_back(row.time, curve.back().y());
    curve.emplace_back(row.time, row.command.*speed);
  }
  return curve;
}

Panel speed_panel(const std::shared_ptr<const DriveRuns>& runs,
                  DriverKind kind,
                  double Twist2::*speed,
                  double end) {
  const bool linear = speed == &Twist2::linear;
  const RobotSettings limits = runs->maps.front().of(kind).robot;
  const double most = linear ? limits.linear_max : limits.angular_max;
  const double least = linear ? limits.linear_min : -limits.angular_max;
  const double room = linear ? 0.12 : 0.25;
  return {.title = to_text(kind),
          .data = {.min = {0.0, std::min(0.0, least) - room}, .max = {end, most + room}},
          .x_name = "time [s]",
          .y_name = linear ? "linear speed [m/s]" : "angular speed [rad/s]",
          .grid = true,
          .draw = [runs, kind, speed, most, least](io::Canvas& canvas, const io::PlotAxes& axes) {
            const io::Stroke bound{.width = 1.0, .dash = {5.0, 3.0}};
            for (const double limit : {least, most}) {
              canvas.line(axes.at(Vector2d(axes.data().min.x(), limit)),
                          axes.at(Vector2d(axes.data().max.x(), limit)), bound);
            }
            canvas.line(axes.at(speed_curve(runs->maps.front().of(kind), speed)),
                        {.color = color_of(kind), .width = 0.9});
          }};
}

Panel change_panel(const std::shared_ptr<const DriveRuns>& runs, DriveMeasure measure) {
  constexpr std::array kAgainst = {DriverKind::Ismpc, DriverKind::Ours};
  double low = 0.0;
  double high = 0.0;
  const auto changes = [runs, measure](DriverKind kind) {
    return percent_over(values(*runs, kind, measure), values(*runs, DriverKind::Smpc, measure));
  };
  for (const DriverKind kind : kAgainst) {
    for (const double one : changes(kind)) {
      low = std::min(low, one);
      high = std::max(high, one);
    }
  }
  const auto count = static_cast<double>(runs->comparable().size());
  const double room = 0.08 * (high - low) + 1e-6;
  return {.title = to_text(measure),
          .data = {.min = {0.0, low - room}, .max = {count + 1.0, high + room}},
          .x_name = "map",
          .y_name = "change against SMPC [%]",
          .grid = true,
          .draw = [changes, kAgainst](io::Canvas& canvas, const io::PlotAxes& axes) {
            const double right = axes.data().max.x();
            canvas.line(axes.at(Vector2d(0.0, 0.0)), axes.at(Vector2d(right, 0.0)), {.width = 0.8});
            for (const DriverKind kind : kAgainst) {
              const std::vector<double> sample = changes(kind);
              const Estimate e = estimate(sample);
              const std::array band = {Vector2d(0.0, e.low), Vector2d(right, e.low),
                                       Vector2d(right, e.high), Vector2d(0.0, e.high)};
              canvas.polygon(axes.at(band), color_of(kind).faded(0.25), nullptr);
              canvas.line(axes.at(Vector2d(0.0, e.mean)), axes.at(Vector2d(right, e.mean)),
                          {.color = color_of(kind), .width = 1.0});
              for (std::size_t i = 0; i < sample.size(); ++i) {
                const Vector2d at = axes.at(Vector2d(static_cast<double>(i) + 1.0, sample[i]));
                if (kind == DriverKind::Ours) {
                  canvas.cross(at, 2.2, {.color = color_of(kind), .width = 1.1});
                } else {
                  canvas.circle(at, 2.2, color_of(kind), nullptr);
                }
              }
            }
          }};
}

}  // namespace

Figure trajectory_figure(const std::shared_ptr<const DriveRuns>& runs) {
  return {
      .name = "case1_figure5_trajectories",
      .caption = fmt::format(
          "Figure 5: corridors, targets and driven trajectories in a structured, obstacle-dense "
          "map (seed {}). (a) ISMPC with dual targets at the seeds; (b) SMPC with one target at "
          "the centroid of the next overlap; (c) our default, whose targets move along the "
          "reference path (rectangles for the robot's centre, seeds shown); (d) the three "
          "trajectories.",
          runs->maps.front().seed),
      .draw = [runs](io::PictureFormat format) {
        const auto grid = std::make_shared<const OccupancyGrid>(
            generate_map(map_kind(runs->course), runs->maps.front().seed));
        PanelPicture picture{.columns = 2, .legend = track_legend(), .panels = {}};
        picture.legend.push_back({.kind = Kind::Area,
                                  .text = "corridor",
                                  .stroke = kCorridorSide,
                                  .fill = io::palette::kGrey.faded(0.06)});
        picture.legend.push_back({.kind = Kind::Dot,
                                  .text = "target or seed",
                                  .stroke = {.width = 0.4},
                                  .fill = io::palette::kYellow});
        picture.legend.push_back({.kind = Kind::Ring, .text = "start"});
        picture.legend.push_back({.kind = Kind::Cross, .text = "goal", .stroke = {.width = 1.4}});
        picture.panels = {drive_panel(runs, grid, DriverKind::Ismpc, "(a)"),
                          drive_panel(runs, grid, DriverKind::Smpc, "(b)"),
                          drive_panel(runs, grid, DriverKind::Ours, "(c)"),
                          {.title = "(d) all three",
                           .data = bounds_of(*grid),
                           .draw = [runs, grid](io::Canvas& canvas, const io::PlotAxes& axes) {
                             draw_map_within(canvas, axes, *grid);
                             for (const DriverKind kind : kShownDrivers) {
                               canvas.line(axes.at(track_of(runs->maps.front().of(kind))),
                                           track_stroke(kind));
                             }
                             draw_ends(canvas, axes, runs->maps.front().of(DriverKind::Ours));
                           }}};
        return draw_panels(picture, format);
      }};
}

Figure speed_figure(const std::shared_ptr<const DriveRuns>& runs) {
  return {.name = "case1_figure6_velocities",
          .caption =
              "Figure 6: commanded speeds on the map of Figure 5, with their bounds (dashed): 1 "
              "m/s, from 0.05 m/s for the paper's two, and 1.5 rad/s.",
          .draw = [runs](io::PictureFormat format) {
            double end = 0.0;
            for (const DriverKind kind : kShownDrivers)
              end = std::max(end, runs->maps.front().of(kind).rows.back().time);
            PanelPicture picture{.columns = 2,
                                 .ratio = 0.52,
                                 .legend = {{.kind = Kind::Line,
                                             .text = "bound",
                                             .stroke = {.width = 1.0, .dash = {5.0, 3.0}}}},
                                 .panels = {}};
            for (const DriverKind kind : kShownDrivers) {
              picture.panels.push_back(speed_panel(runs, kind, &Twist2::linear, end));
              picture.panels.push_back(speed_panel(runs, kind, &Twist2::angular, end));
            }
            return draw_panels(picture, format);
          }};
}

Figure change_figure(const std::shared_ptr<const DriveRuns>& runs) {
  return {.name = "case1_changes_against_smpc",
          .caption = fmt::format(
              "Case 1 on {} maps: each map's change against SMPC; line and band: mean and its 95 "
              "% confidence interval. Below 0 is better in every panel.",
              runs->comparable().size()),
          .draw = [runs](io::PictureFormat format) {
            PanelPicture picture{.columns = 2,
                                 .ratio = 0.6,
                                 .legend = {{.kind = Kind::Dot,
                                             .text = to_text(DriverKind::Ismpc),
                                             .stroke = {.color = kMdsrcColor, .width = 0.5},
                                             .fill = kMdsrcColor},
                                            {.kind = Kind::Cross,
                                             .text = to_text(DriverKind::Ours),
                                             .stroke = {.color = kOursColor, .width = 1.2}}},
                                 .panels = {}};
            for (const DriveMeasure measure : kDriveMeasures)
              picture.panels.push_back(change_panel(runs, measure));
            return draw_panels(picture, format);
          }};
}

}  // namespace fairway::reproduction
