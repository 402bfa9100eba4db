// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/core.h>

#include "cli/corridor_choice.hpp"
#include "cli/map_bounds.hpp"
#include "cli/number_option.hpp"
#include "cli/output.hpp"
#include "cli/point_argument.hpp"
#include "cli/settings_options.hpp"
#include "commands/commands.hpp"
#include "experiments/clocks.hpp"
#include "fairway/io/scenario/zones_file.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/zones/zone_map.hpp"
#include "results/plan_output.hpp"

namespace fairway::app {

namespace {

struct PlanCommand {
  std::string map;
  std::string start;
  std::string goal;
  std::string corridor;
  std::string zones;
  std::optional<double> clearance;
  std::optional<double> inward_offset;
  std::optional<double> robot_radius;
  int repeats = 0;
  std::string json;
  std::string picture;
  SettingsOptions settings;

  [[nodiscard]] Expected<int> run() const;
  [[nodiscard]] Expected<void> apply_options(Settings& target) const;
};

// A contracted rectangle surely contains a path point if a square of side 2 Delta_s fits around it.
double workspace_margin(double inward_offset) {
  return (std::numbers::sqrt2 - 1.0) * inward_offset;
}

Expected<void> PlanCommand::apply_options(Settings& target) const {
  if (robot_radius) target.robot.radius = *robot_radius;
  if (inward_offset) {
    target.corridor.space = CorridorSpace::Workspace;
    target.corridor.inward_offset = *inward_offset;
    if (!robot_radius) target.robot.radius = *inward_offset;
  } else if (robot_radius) {
    target.corridor.space = CorridorSpace::Configuration;
  }
  const bool in_workspace = target.corridor.space == CorridorSpace::Workspace;
  if (clearance) {
    if (!robot_radius && !inward_offset) {
      target.robot.radius = std::min(target.robot.radius, *clearance);
    }
    const double least = in_workspace ? std::max(target.robot.radius, target.corridor.inward_offset)
                                      : target.robot.radius;
    if (*clearance < least) {
      return fail(fmt::format("--clearance: expected at least {}, the {}, found {}", least,
                              in_workspace ? "clearance inside the rectangles" : "robot's radius",
                              *clearance));
    }
    target.path.margin = *clearance - least;
  } else if (in_workspace) {
    target.path.margin =
        std::max(target.path.margin, workspace_margin(target.corridor.inward_offset));
  }
  return validate(target);
}

PreparedMap prepared(const OccupancyGrid& grid, const PlanQuery& query) {
  BitGrid obstacles(grid, unknown_cells(query.settings.map));
  if (!query.zones.empty()) {
    obstacles.set_zones(std::make_shared<const ZoneMap>(query.zones, query.settings.robot.radius));
  }
  return PreparedMap(std::move(obstacles));
}

PlanAnswer answer(const OccupancyGrid& grid, const PlanQuery& query, int repeats) {
  PlanAnswer best;
  Planner planner;
  // The fastest repeat of each stage counts. The first ones fetch memory from the system, and other
  // programs may use the machine. 0 repeats: as many as take no noticeable time.
  constexpr int kMostRepeats = 50;
  constexpr double kUnnoticed = 0.4;  // [s]
  const Stopwatch all;
  const auto enough = [&](int done) {
    return repeats > 0 ? done >= repeats : done >= kMostRepeats || all.seconds() > kUnnoticed;
  };
  for (int i = 0; i == 0 || !enough(i); ++i) {
    const Stopwatch prepare;
    const PreparedMap map = prepared(grid, query);
    const double seconds = prepare.seconds();
    Plan plan = planner.plan(map, query.start.position,
                             {.position = query.goal.position, .heading = query.goal.heading},
                             planner_settings(query.settings), query.hooks);
    if (i > 0) {
      plan.path_seconds = std::min(plan.path_seconds, best.plan.path_seconds);
      plan.corridor_seconds = std::min(plan.corridor_seconds, best.plan.corridor_seconds);
    }
    best = {.plan = std::move(plan),
            .reason = {},
            .obstruction = {},
            .prepare_seconds = i > 0 ? std::min(seconds, best.prepare_seconds) : seconds};
  }
  if (!best.plan.usable()) {
    const PreparedMap map = prepared(grid, query);
    const double radius = query.settings.robot.radius;
    best.reason = explain(map, query.start.position, best.plan, radius);
    best.obstruction = find_obstruction(map, query.start.position, best.plan, radius);
  }
  return best;
}

Expected<int> PlanCommand::run() const {
  for (const auto& checked : {check_output(json), check_picture_output(picture)}) {
    if (!checked) return tl::unexpected(checked.error());
  }
  PlanQuery query;
  const Expected<PointArgument> from = parse_point(start, "--start");
  if (!from) return tl::unexpected(from.error());
  const Expected<PointArgument> to = parse_point(goal, "--goal");
  if (!to) return tl::unexpected(to.error());
  query.start = *from;
  query.goal = *to;
  const Expected<Settings> loaded = load_settings(settings);
  if (!loaded) return tl::unexpected(loaded.error());
  query.settings = *loaded;
  const Expected<CorridorChoice> choice = choose_corridor(corridor, query.settings.corridor);
  if (!choice) return tl::unexpected(choice.error());
  if (const auto applied = apply_options(query.settings); !applied) {
    return tl::unexpected(applied.error());
  }
  if (!zones.empty()) {
    const Expected<Zones> read = io::read_zones_file(zones);
    if (!read) return tl::unexpected(read.error());
    query.zones = *read;
  }
  const Expected<OccupancyGrid> grid = load_map(map);
  if (!grid) return tl::unexpected(grid.error());
  if (const auto apart = check_apart({{"--json", json}, {"--picture", picture}}); !apart)
    return tl::unexpected(apart.error());
  for (const auto& inside : {check_inside(*grid, query.start.position, "--start"),
                             check_inside(*grid, query.goal.position, "--goal")}) {
    if (!inside) return tl::unexpected(inside.error());
  }
  query.hooks = {.clock = steady_seconds,
                 // Returns the requested radius, or the clearance at start and goal if that is
                 // less. The navigator adds a part of the path's margin.
                 .build =
                     [&](const BitGrid& obstacles, const Path& path, double radius,
                         const CorridorSettings& corridor_settings) {
                       return choice->build(obstacles, path,
                                            std::min(radius, query.settings.robot.radius),
                                            corridor_settings);
                     },
                 .fixed_margin = clearance.has_value()};
  const PlanAnswer found = answer(*grid, query, repeats);
  if (const auto drawn = write_plan_picture(picture, *grid, query, found.plan); !drawn) {
    return tl::unexpected(drawn.error());
  }
  const std::string text = plan_json(found, query, choice->name,
                                     {.schema = "plan.v1",
                                      .files = {map, settings.file, zones},
                                      .map = &*grid,
                                      .settings = &query.settings});
  if (const auto written = write_output(json, text); !written) {
    return tl::unexpected(written.error());
  }
  if (!found.plan.usable()) {
    print_error(found.reason);
    return kFailed;
  }
  if (json != "-") {
    if (const auto printed = print(plan_summary(found)); !printed)
      return tl::unexpected(printed.error());
  }
  return kDone;
}

}  // namespace

void add_plan_command(CommandLine& tool) {
  const auto command = std::make_shared<PlanCommand>();
  const Options options = tool.add_command("plan", "Find a path and the safe corridor along it",
                                           [command] { return command->run(); });
  options.add("MAP", command->map, "map_server YAML file").required();
  options.add("--start", command->start, "Start pose of the robot [m, rad]")
      .required()
      .type_name("X,Y[,HEADING]");
  options.add("--goal", command->goal, "Goal [m, rad]").required().type_name("X,Y[,HEADING]");
  options.add("--corridor", command->corridor,
              "src, fsrc, mdsrc (the paper's, made sound) or fewest (the default)");
  options
      .add("--clearance", command->clearance,
           "Least distance between path and obstacles, including the robot's radius [m]; "
           "default: the radius plus path.margin, which shrinks in narrow passages")
      .check(number_between(0.0, 20.0));
  options
      .add("--inward-offset", command->inward_offset,
           "Build rectangles in the workspace, for a robot centre that keeps this distance inside "
           "[m]")
      .check(number_between(0.0, 10.0));
  options
      .add("--robot-radius", command->robot_radius,
           "Build rectangles in configuration space, for the centre of a disc of this radius [m]")
      .check(number_between(0.01, 10.0));
  options
      .add("--repeat", command->repeats,
           "Report the fastest of N runs; default: as many as fit in 0.4 s")
      .between(1, 1000);
  options.add("--zones", command->zones, "YAML file with a list `zones` that the plan obeys")
      .type_name("FILE.yaml");
  options.add("--json", command->json, "Write the plan as JSON; - is standard output")
      .type_name("FILE");
  options.add("--picture", command->picture, "Draw the plan; .svg, .png or .pdf").type_name("FILE");
  add_settings_options(options, command->settings);
}

}  // namespace fairway::app
