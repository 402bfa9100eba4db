// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/stuck_figure.hpp"

#include "experiments/paper/figures/drive_style.hpp"
#include "experiments/paper/figures/panels.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;
using Kind = io::LegendEntry::Kind;

// The targets that attract a robot that is stuck.
struct Pull {
  Vector2d first;  // both targets
  Vector2d second;
  Vector2d mean;  // their weighted mean
};

Pull pull_on(const Drive& drive, const MpcSettings& mpc) {
  const Corridor& corridor = drive.plan.corridor;
  const std::size_t current = drive.rows.back().rectangle;
  const auto seed = [&](std::size_t i) {
    return i < corridor.rectangles.size() ? corridor.rectangles[i].seed : drive.plan.goal.position;
  };
  const double total = mpc.weight_position + mpc.weight_next_position;
  Pull pull{.first = seed(current + 1), .second = seed(current + 2), .mean = {}};
  pull.mean = (mpc.weight_position * pull.first + mpc.weight_next_position * pull.second) / total;
  return pull;
}

io::Box around(const Drive& drive, const Pull& pull) {
  const Corridor& corridor = drive.plan.corridor;
  const std::size_t current = drive.rows.back().rectangle;
  Vector2d low = drive.rows.back().pose.position;
  Vector2d high = low;
  const auto add = [&](const Vector2d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  for (const Vector2d& p : {pull.first, pull.second, pull.mean})
    add(p);
  for (const Vector2d& p : corridor.admissible(current).corners())
    add(p);
  const Vector2d half = Vector2d::Constant(0.5 * (high - low).maxCoeff() + 0.6);
  return {.min = 0.5 * (low + high) - half, .max = 0.5 * (low + high) + half};
}

// A run of ISMPC that did not arrive.
struct Stuck {
  std::shared_ptr<const DriveRuns> runs;
  const DriveComparison* map = nullptr;
};

Panel stuck_panel(const Stuck& stuck) {
  const Drive& shown = stuck.map->of(DriverKind::Ismpc);
  const Settings settings = driver_settings(stuck.runs->course, DriverKind::Ismpc);
  const Pull pull = pull_on(shown, settings.mpc);
  const auto grid = std::make_shared<const OccupancyGrid>(
      generate_map(map_kind(stuck.runs->course), stuck.map->seed));
  return {.title = fmt::format("{} (seed {})", to_text(stuck.runs->course), stuck.map->seed),
          .data = around(shown, pull),
          .draw = [stuck, pull, grid](io::Canvas& canvas, const io::PlotAxes& axes) {
            const Drive& drive = stuck.map->of(DriverKind::Ismpc);
            const Corridor& corridor = drive.plan.corridor;
            const std::size_t current = drive.rows.back().rectangle;
            draw_map_within(canvas, axes, *grid);
            const auto draw = [&](std::size_t i, const io::Color& color) {
              if (i >= corridor.rectangles.size()) return;
              const io::Stroke side{.color = color, .width = 1.4};
              canvas.polygon(axes.at(corridor.admissible(i).corners()), color.faded(0.12), &side);
            };
            draw(current + 1, kFsrcColor);
            draw(current, kMdsrcColor);
            const Drive& ours = stuck.map->of(DriverKind::Ours);
            canvas.line(axes.at(track_of(ours)), track_stroke(DriverKind::Ours));
            canvas.line(axes.at(track_of(drive)), track_stroke(DriverKind::Ismpc));
            const Vector2d robot = drive.rows.back().pose.position;
            canvas.line(axes.at(robot), axes.at(pull.mean), {.width = 0.8, .dash = {1.5, 1.5}});
            const io::Stroke rim{.width = 0.6};
            canvas.circle(axes.at(pull.first), 3.4, io::palette::kYellow, &rim);
            canvas.circle(axes.at(pull.second), 3.4, io::palette::kWhite, &rim);
            canvas.cross(axes.at(pull.mean), 3.4, {.color = io::palette::kVermilion, .width = 1.8});
            canvas.circle(axes.at(robot), 3.4, kMdsrcColor, &rim);
          }};
}

std::vector<io::LegendEntry> stuck_legend() {
  const auto area = [](const char* text, const io::Color& color) {
    return io::LegendEntry{.kind = Kind::Area,
                           .text = text,
                           .stroke = {.color = color, .width = 1.4},
                           .fill = color.faded(0.12)};
  };
  const io::Stroke rim{.width = 0.6};
  return {{.kind = Kind::Dot, .text = "ISMPC after 120 s", .stroke = rim, .fill = kMdsrcColor},
          {.kind = Kind::Dot, .text = "first target", .stroke = rim, .fill = io::palette::kYellow},
          {.kind = Kind::Dot, .text = "second target", .stroke = rim, .fill = io::palette::kWhite},
          {.kind = Kind::Cross,
           .text = "their weighted mean",
           .stroke = {.color = io::palette::kVermilion, .width = 1.8}},
          area("current corridor, contracted", kMdsrcColor),
          area("next corridor, contracted", kFsrcColor),
          {.kind = Kind::Line, .text = "ISMPC", .stroke = track_stroke(DriverKind::Ismpc)},
          {.kind = Kind::Line, .text = "Fairway", .stroke = track_stroke(DriverKind::Ours)}};
}

}  // namespace

std::optional<Figure> stuck_figure(const std::vector<std::shared_ptr<const DriveRuns>>& courses) {
  std::vector<Stuck> found;
  for (const auto& runs : courses) {
    for (const DriveComparison& map : runs->maps) {
      const Drive& drive = map.of(DriverKind::Ismpc);
      if (drive.reached || drive.collided) continue;
      found.push_back({.runs = runs, .map = &map});
      break;
    }
  }
  if (found.empty()) return std::nullopt;
  return Figure{.name = "case1_dual_targets_stuck",
                .caption =
                    "Where the claim of progress fails: two quadratic targets amount to one at "
                    "their weighted mean, 0.8 of the first and 0.2 of the second. Where that "
                    "lies outside the overlap with the next corridor, the robot reaches the edge "
                    "of the current one beside the overlap and never switches; since its least "
                    "speed is 0.05 m/s it cannot even wait there. Shown at 120 s: the first such "
                    "map of each course.",
                .draw = [found](io::PictureFormat format) {
                  PanelPicture picture{.columns = 2, .legend = stuck_legend(), .panels = {}};
                  for (const Stuck& stuck : found)
                    picture.panels.push_back(stuck_panel(stuck));
                  return draw_panels(picture, format);
                }};
}

}  // namespace fairway::reproduction
