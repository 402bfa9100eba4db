// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/map_bounds.hpp"
#include "cli/number_option.hpp"
#include "cli/output.hpp"
#include "cli/physics_choice.hpp"
#include "cli/point_argument.hpp"
#include "cli/progress.hpp"
#include "cli/provenance.hpp"
#include "cli/settings_options.hpp"
#include "commands/commands.hpp"
#include "experiments/clocks.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/io/scenario/zones_file.hpp"
#include "fairway/io/trace_file.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "fairway/simulation/scenarios/swap_scenario.hpp"
#include "results/episode_output.hpp"
#include "results/run_animation.hpp"
#include "results/run_outputs.hpp"

namespace fairway::app {

namespace {

struct SimulateCommand {
  std::string scenario;
  std::string map;
  std::string start;
  std::string goal;
  std::string swap;
  std::string zones;
  std::string sensing;
  std::string pose;
  std::string noise;
  std::string physics;
  std::string body;
  std::optional<int> seed;
  std::optional<double> time_limit;
  std::string json;
  std::string trace;
  std::string picture;
  std::string animation;
  RunAnimation moving;
  std::string speeds;
  SettingsOptions settings;
  RunOutputs outputs;

  [[nodiscard]] Expected<int> run();
  [[nodiscard]] Expected<Scenario> load() const;
  [[nodiscard]] Expected<Scenario> scenario_of_options() const;
  [[nodiscard]] Expected<Scenario> scenario_of_swap() const;
  [[nodiscard]] Expected<void> write(const Scenario& world, const EpisodeResult& result) const;
};

Expected<Scenario> SimulateCommand::scenario_of_options() const {
  const Expected<PointArgument> from = parse_point(start, "--start");
  if (!from) return tl::unexpected(from.error());
  const Expected<PointArgument> to = parse_point(goal, "--goal");
  if (!to) return tl::unexpected(to.error());
  const Expected<OccupancyGrid> grid = load_map(map);
  if (!grid) return tl::unexpected(grid.error());
  for (const auto& inside : {check_inside(*grid, from->position, "--start"),
                             check_inside(*grid, to->position, "--goal")}) {
    if (!inside) return tl::unexpected(inside.error());
  }
  Scenario result;
  result.name = map;
  result.map = *grid;
  // Without a heading the robot starts towards its goal.
  const Eigen::Vector2d way = to->position - from->position;
  const double towards = way.isZero() ? 0.0 : std::atan2(way.y(), way.x());
  result.robots = {
      {.name = "robot",
       .start = {.position = from->position, .heading = from->heading.value_or(towards)},
       .goal = {.position = to->position, .heading = to->heading}}};
  return result;
}

Expected<Scenario> SimulateCommand::scenario_of_swap() const {
  constexpr int kMostRobots = 1000;
  constexpr double kWidest = 400.0;  // [m]; the map of the ground has cells of 0.1 m
  const std::optional<std::vector<double>> numbers = parse_list(swap);
  const bool known =
      numbers && (numbers->size() == 1 || numbers->size() == 2) &&
      numbers->front() == std::floor(numbers->front()) && numbers->front() >= 2.0 &&
      numbers->front() <= kMostRobots &&
      (numbers->size() == 1 || (numbers->back() > 0.0 && numbers->back() <= kWidest));
  if (!known) {
    return fail("--swap: expected N from 2 to 1000, or N,RADIUS with a radius up to 400 m, found " +
                io::excerpt(swap));
  }
  const int robots = static_cast<int>(numbers->front());
  const double radius = numbers->size() == 2 ? numbers->back() : swap_radius(robots);
  return swap_scenario(robots, radius, {}, static_cast<std::uint64_t>(seed.value_or(1)));
}

Expected<Scenario> SimulateCommand::load() const {
  const bool by_options = !map.empty() || !start.empty() || !goal.empty();
  if (static_cast<int>(by_options) + static_cast<int>(!scenario.empty()) +
              static_cast<int>(!swap.empty()) !=
          1 ||
      (by_options && (map.empty() || start.empty() || goal.empty()))) {
    return fail(
        "simulate: expected either SCENARIO.yaml, or all of --map, --start and --goal, or --swap");
  }
  Expected<Scenario> loaded = by_options      ? scenario_of_options()
                              : !swap.empty() ? scenario_of_swap()
                                              : load_scenario(scenario);
  if (!loaded) return loaded;
  const Expected<Settings> own = load_settings(settings, loaded->settings);
  if (!own) return tl::unexpected(own.error());
  if (const auto valid = validate(*own); !valid) return tl::unexpected(valid.error());
  loaded->settings = *own;
  if (!zones.empty()) {
    const Expected<Zones> read = io::read_zones_file(zones);
    if (!read) return tl::unexpected(read.error());
    loaded->zones.insert(loaded->zones.end(), read->begin(), read->end());
    if (const auto valid = validate(loaded->zones); !valid) return tl::unexpected(valid.error());
  }
  if (!sensing.empty())
    loaded->sensing.sensing = sensing == "lidar" ? Sensing::Lidar : Sensing::Map;
  if (!pose.empty()) loaded->sensing.pose = pose == "scans" ? PoseSource::Scans : PoseSource::Exact;
  if (loaded->sensing.sensing == Sensing::Lidar && loaded->sensing.pose == PoseSource::Scans)
    return fail("--pose: expected exact with --sensing lidar, found scans");
  if (!noise.empty()) {
    use_noise(loaded->sensing, noise == "standard" ? SensorNoise::Standard : SensorNoise::None);
  }
  if (!physics.empty()) loaded->engine = physics == "mujoco" ? Engine::Mujoco : Engine::Unicycle;
  if (!body.empty()) {
    const Expected<RobotModel> model = io::read_robot_model(body);
    if (!model) return tl::unexpected(model.error());
    note_input(body);
    for (RobotTask& robot : loaded->robots)
      robot.model = *model;
    describe_models(*loaded);
  }
  if (const auto fits = check_models(*loaded); !fits) return tl::unexpected(fits.error());
  if (has_models(*loaded) && !outputs.log.empty() && loaded->settings.planning.background)
    return fail(
        "--log: expected planning.background false with robots of their own body, found true");
  if (seed) loaded->seed = static_cast<std::uint64_t>(*seed);
  if (time_limit) loaded->time_limit = *time_limit;
  return loaded;
}

Expected<void> SimulateCommand::write(const Scenario& world, const EpisodeResult& result) const {
  if (!picture.empty()) {
    const Expected<std::string> bytes = world_picture(world, result, picture);
    if (!bytes) return tl::unexpected(bytes.error());
    if (auto done = write_output(picture, *bytes); !done) return done;
  }
  if (!animation.empty()) {
    const Expected<std::string> bytes = moving.draw(world, result);
    if (!bytes) return tl::unexpected(bytes.error());
    if (auto done = write_output(animation, *bytes); !done) return done;
  }
  if (!speeds.empty()) {
    const Expected<std::string> bytes = speed_picture(world, result, speeds);
    if (!bytes) return tl::unexpected(bytes.error());
    if (auto done = write_output(speeds, *bytes); !done) return done;
  }
  if (!trace.empty()) {
    if (auto done = write_output(trace, io::trace_csv(result)); !done) return done;
  }
  if (!json.empty()) {
    Json object = episode_json(world, result);
    add_provenance(object, {.schema = "simulate.v1",
                            .files = {scenario, map, settings.file, zones},
                            .map = &world.map,
                            .seed = world.seed,
                            .settings = &world.settings});
    if (auto done = write_output(json, json_text(object)); !done) return done;
  }
  // The table is omitted if another result was requested on standard output.
  if (json == "-" || trace == "-") return {};
  return print(episode_table(result));
}

Expected<int> SimulateCommand::run() {
  for (const auto& checked :
       {check_output(json), check_output(trace), check_animation_output(animation),
        check_picture_output(picture), check_picture_output(speeds)}) {
    if (!checked) return tl::unexpected(checked.error());
  }
  const Expected<Scenario> world = load();
  if (!world) return tl::unexpected(world.error());
  if (const auto apart = check_apart({{"--json", json},
                                      {"--trace", trace},
                                      {"--picture", picture},
                                      {"--animation", animation},
                                      {"--speeds", speeds},
                                      {"--log", outputs.log},
                                      {"--report", outputs.report}});
      !apart) {
    return tl::unexpected(apart.error());
  }
  const Expected<PhysicsMaker> engine =
      choose_physics(setting_names(world->engine)[static_cast<std::size_t>(world->engine)]);
  if (!engine) return tl::unexpected(engine.error());
  if (const auto opened = outputs.open(); !opened) return tl::unexpected(opened.error());
  ObserverList observers;
  if (EpisodeObserver* const writes = outputs.observer(); writes != nullptr) observers.add(*writes);
  if (!animation.empty()) observers.add(moving);
  Progress progress(world->name);
  const EpisodeHooks hooks{.clock = steady_seconds,
                           .on_cycle =
                               [&](double time) {
                                 progress.show(fmt::format("{:.1f} s of at most {:.0f} s driven",
                                                           time, world->time_limit));
                                 return true;
                               },
                           .physics = *engine,
                           .solver = nullptr,
                           .observer = observers.empty() ? nullptr : &observers,
                           .play = {}};
  const EpisodeResult result = run_episode(*world, hooks);
  if (const auto closed = outputs.close(); !closed) return tl::unexpected(closed.error());
  if (const auto written = write(*world, result); !written) {
    return tl::unexpected(written.error());
  }
  if (!result.success) print_error(failure_text(*world, result));
  return result.success ? kDone : kFailed;
}

}  // namespace

void add_simulate_command(CommandLine& tool) {
  const auto command = std::make_shared<SimulateCommand>();
  const Options options = tool.add_command("simulate", "Drive through a scenario and judge the run",
                                           [command] { return command->run(); });
  options.add("SCENARIO", command->scenario,
              "Scenario YAML file; or use --map, --start and --goal");
  options.add("--map", command->map, "map_server YAML file").type_name("FILE.yaml");
  options.add("--start", command->start, "Start pose of the robot [m, rad]")
      .type_name("X,Y[,HEADING]");
  options.add("--goal", command->goal, "Goal [m, rad]").type_name("X,Y[,HEADING]");
  options
      .add("--swap", command->swap,
           "Robots on a circle in open space swap places with the opposite robot [-, m]; "
           "--seed shifts their starts slightly, 0 does not")
      .type_name("N[,RADIUS]");
  options
      .add("--zones", command->zones,
           "YAML file with a list `zones` that the robots obey, with those of the scenario")
      .type_name("FILE.yaml");
  options.add("--sensing", command->sensing, "What the robots know; overrides the scenario")
      .one_of({"map", "lidar"});
  options
      .add("--pose", command->pose,
           "How robots that know the map know their pose; overrides the scenario")
      .one_of({"exact", "scans"});
  options.add("--noise", command->noise, "Errors of lidar and odometry; overrides the scenario")
      .one_of({"none", "standard"});
  options.add("--physics", command->physics, "Model that moves the robots; overrides the scenario")
      .one_of({"unicycle", "mujoco"});
  options
      .add("--body", command->body,
           "Outline and base of all robots, as under `robot:` of a scenario's robot")
      .type_name("FILE.yaml");
  options.add("--seed", command->seed, "Seed of all random numbers").not_negative();
  options.add("--time-limit", command->time_limit, "Longest run [s]")
      .check(number_between(0.001, 1e5));
  options.add("--json", command->json, "Write the result as JSON; - is standard output")
      .type_name("FILE");
  options.add("--trace", command->trace, "Write every cycle as CSV; - is standard output")
      .type_name("FILE.csv");
  options.add("--picture", command->picture, "Draw the run; .svg, .png or .pdf").type_name("FILE");
  options.add("--animation", command->animation, "Draw the run as a moving picture; .svg")
      .type_name("FILE.svg");
  options.add("--speeds", command->speeds, "Draw speeds over time; .svg, .png or .pdf")
      .type_name("FILE");
  add_run_options(options, command->outputs);
  add_settings_options(options, command->settings);
}

}  // namespace fairway::app
