// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/robot_model_file.hpp"

#include <array>

#include <fmt/core.h>

#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/yaml_document.hpp"

namespace fairway::io {

namespace {

constexpr double kFastest = 100.0;
constexpr double kStrongest = 1000.0;
constexpr std::array<const char*, 4> kKinds{"unicycle", "car", "tricycle", "omni"};
constexpr std::array<const char*, 4> kWheels{"differential", "steered", "mecanum", "swerve"};

WheelLimit read_wheels(YamlMapping& robot) {
  WheelLimit wheels;
  std::optional<YamlMapping> mapping = robot.mapping("wheels");
  if (!mapping) return wheels;
  wheels.kind = static_cast<WheelKind>(1 + mapping->choice("type", kWheels));
  wheels.speed_max = mapping->number("speed_max", {.min = 0.01, .max = kFastest});
  constexpr NumberRange kSize{.min = 0.01, .max = 20.0};
  if (wheels.kind == WheelKind::Differential) wheels.track = mapping->number("track", kSize);
  if (wheels.kind == WheelKind::Mecanum) wheels.half_sum = mapping->number("half_sum", kSize);
  if (wheels.kind == WheelKind::Swerve) {
    for (const std::vector<double>& at : mapping->rows("positions", 2)) {
      if (wheels.num_modules == WheelLimit::kMaxModules) {
        mapping->complain("positions", "expected 1 to 8 modules, found more");
        break;
      }
      wheels.modules[static_cast<std::size_t>(wheels.num_modules++)] = {at[0], at[1]};
    }
  }
  mapping->finish();
  return wheels;
}

BaseModel read_base(YamlMapping& robot) {
  BaseModel base;
  base.kind = static_cast<BaseKind>(robot.choice("kind", kKinds));
  if (is_steered(base)) {
    base.wheelbase = robot.number("wheelbase", {.min = 0.05, .max = 50.0});
    base.steering_max = robot.number("steering_max", {.min = 0.01, .max = 1.5});
    base.steering_rate_max = robot.number("steering_rate_max", {.min = 0.01, .max = kFastest});
  }
  constexpr NumberRange kSpeed{.min = 0.01, .max = kFastest};
  constexpr NumberRange kChange{.min = 0.01, .max = kStrongest};
  if (base.kind == BaseKind::Omni) {
    base.lateral_max = robot.number("lateral_max", kSpeed);
    base.lateral_acceleration = robot.number("lateral_acceleration", kChange);
  }
  base.linear_min = robot.number("linear_min", {.min = -kFastest, .max = 0.0});
  base.linear_max = robot.number("linear_max", kSpeed);
  base.angular_max = robot.number("angular_max", kSpeed);
  base.linear_acceleration = robot.number("linear_acceleration", kChange);
  base.angular_acceleration = robot.number("angular_acceleration", kChange);
  base.response_time = robot.number("response_time", {.min = 0.0, .max = 1.0}, 0.0);
  base.wheels = read_wheels(robot);
  return base;
}

BodyShape shape_of(YamlMapping& robot, const char* key, const Expected<BodyShape>& shape) {
  if (shape) return *shape;
  robot.complain(key, shape.error().message);
  return BodyShape::rectangle(1.0, 1.0, 0.5);
}

BodyShape read_polygon(YamlMapping& robot) {
  std::vector<Eigen::Vector2d> vertices;
  for (const std::vector<double>& at : robot.rows("footprint", 2))
    vertices.emplace_back(at[0], at[1]);
  if (vertices.size() < 3 || vertices.size() > ConvexPart::kMaxVertices) {
    robot.complain("footprint", fmt::format("expected 3 to {} points, found {}",
                                            ConvexPart::kMaxVertices, vertices.size()));
    return BodyShape::rectangle(1.0, 1.0, 0.5);
  }
  return shape_of(robot, "footprint", BodyShape::polygon(vertices));
}

BodyShape read_discs(YamlMapping& robot) {
  std::vector<ConvexPart> parts;
  for (const std::vector<double>& disc : robot.rows("discs", 3)) {
    ConvexPart part;
    part.count = 1;
    part.vertices[0] = {disc[0], disc[1]};
    part.radius = disc[2];
    parts.push_back(part);
  }
  return shape_of(robot, "discs", BodyShape::make(parts));
}

BodyShape read_body(YamlMapping& robot) {
  if (robot.has("footprint")) return read_polygon(robot);
  if (robot.has("discs")) return read_discs(robot);
  constexpr NumberRange kSide{.min = 0.02, .max = 50.0};
  const double length = robot.number("length", kSide, 0.0);
  const double width = robot.number("width", kSide, 0.0);
  if (!robot.has("length") || !robot.has("width")) {
    robot.complain_here("expected length and width, footprint or discs, found none");
    return BodyShape::rectangle(1.0, 1.0, 0.5);
  }
  const double front =
      robot.number("reference_to_front", {.min = -50.0, .max = 50.0}, 0.5 * length);
  return BodyShape::rectangle(std::max(length, kSide.min), std::max(width, kSide.min), front);
}

}  // namespace

RobotModel read_robot_model(YamlMapping& mapping) {
  RobotModel model;
  model.base = read_base(mapping);
  model.body = read_body(mapping);
  mapping.finish();
  if (const Expected<void> valid = validate(model.base); !valid)
    mapping.complain_here(valid.error().message);
  return model;
}

Expected<RobotModel> parse_robot_model(const std::string& text, const std::string& name) {
  YamlFile file{.name = name, .error = {}, .warnings = {}};
  YamlMapping root = parse_yaml_mapping(file, text);
  RobotModel model;
  if (!file.error) model = read_robot_model(root);
  if (file.error) return tl::unexpected(*file.error);
  return model;
}

Expected<RobotModel> read_robot_model(const std::string& path) {
  constexpr std::size_t kLongest = 1U << 20U;  // [bytes]
  const Expected<std::string> text = read_whole_file(path, kLongest);
  if (!text) return tl::unexpected(text.error());
  return parse_robot_model(*text, path);
}

std::string robot_model_yaml(const RobotModel& model, int indent) {
  const BaseModel& base = model.base;
  const std::string space(static_cast<std::size_t>(indent), ' ');
  std::string text;
  const auto line = [&](const char* key, const std::string& value) {
    text += fmt::format("{}{}: {}\n", space, key, value);
  };
  const auto number = [&](const char* key, double value) { line(key, fmt::format("{}", value)); };
  line("kind", to_text(base.kind));
  std::string parts;
  const auto shapes = model.body.parts();
  if (shapes.size() == 1 && shapes[0].count > 2) {
    for (int i = 0; i < shapes[0].count; ++i)
      parts += fmt::format("{}[{}, {}]", i > 0 ? ", " : "", shapes[0].vertex(i).x(),
                           shapes[0].vertex(i).y());
    line("footprint", "[" + parts + "]");
  } else {
    for (const Footprint::Disc& disc : model.body.cover())
      parts += fmt::format("{}[{}, {}, {}]", parts.empty() ? "" : ", ", disc.center.x(),
                           disc.center.y(), disc.radius);
    line("discs", "[" + parts + "]");
  }
  if (is_steered(base)) {
    number("wheelbase", base.wheelbase);
    number("steering_max", base.steering_max);
    number("steering_rate_max", base.steering_rate_max);
  }
  if (base.kind == BaseKind::Omni) {
    number("lateral_max", base.lateral_max);
    number("lateral_acceleration", base.lateral_acceleration);
  }
  number("linear_min", base.linear_min);
  number("linear_max", base.linear_max);
  number("angular_max", base.angular_max);
  number("linear_acceleration", base.linear_acceleration);
  number("angular_acceleration", base.angular_acceleration);
  number("response_time", base.response_time);
  const WheelLimit& wheels = base.wheels;
  if (wheels.kind == WheelKind::None) return text;
  std::string form;
  if (wheels.kind == WheelKind::Differential) form = fmt::format(", track: {}", wheels.track);
  if (wheels.kind == WheelKind::Mecanum) form = fmt::format(", half_sum: {}", wheels.half_sum);
  if (wheels.kind == WheelKind::Swerve) {
    for (int i = 0; i < wheels.num_modules; ++i) {
      const Eigen::Vector2d& at = wheels.modules[static_cast<std::size_t>(i)];
      form += fmt::format("{}[{}, {}]", i > 0 ? ", " : ", positions: [", at.x(), at.y());
    }
    form += "]";
  }
  line("wheels",
       fmt::format("{{type: {}, speed_max: {}{}}}",
                   kWheels[static_cast<std::size_t>(wheels.kind) - 1], wheels.speed_max, form));
  return text;
}

}  // namespace fairway::io
