// SPDX-License-Identifier: Apache-2.0
#include "experiments/solver/ocp_instances.hpp"

#include <array>
#include <cstddef>

#include <fmt/core.h>

#include "experiments/solver/paper_problem.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/mpc/mpc_settings.hpp"

namespace fairway::io {
namespace {

constexpr std::size_t kLargestInstances = 256U << 20U;  // [bytes]
constexpr double kObstacleRadius = 0.8;                 // Ro of Table I
constexpr double kInwardOffset = 0.3;                   // Delta_s of Table I

using Fields = std::vector<std::string_view>;

constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\r'; }

Fields split(std::string_view line) {
  Fields fields;
  std::size_t i = 0;
  while (i < line.size()) {
    const std::size_t begin = i;
    while (i < line.size() && !is_blank(line[i]))
      ++i;
    if (i > begin) fields.push_back(line.substr(begin, i - begin));
    while (i < line.size() && is_blank(line[i]))
      ++i;
  }
  return fields;
}

std::string found(std::string_view field) { return field.empty() ? "nothing" : excerpt(field); }

// Reads the fields of one line in order; after the first error all reads give 0.
class LineReader {
 public:
  LineReader(const Fields& fields, std::string where)
      : fields_(&fields),
        where_(std::move(where)) {}

  double number(const char* key) {
    const std::string_view text = next();
    const std::optional<double> value = parse_number(text);
    if (!value) complain(fmt::format("{}: expected a number, found {}", key, found(text)));
    return value.value_or(0.0);
  }

  int integer(const char* key) {
    const std::string_view text = next();
    const std::optional<int> value = parse_integer(text);
    if (!value) complain(fmt::format("{}: expected an integer, found {}", key, found(text)));
    return value.value_or(0);
  }

  std::string word() { return std::string(next()); }

  // Braces evaluate the reads in order.
  Eigen::Vector2d point(const char* x, const char* y) {
    return Eigen::Vector2d{number(x), number(y)};
  }
  Pose2 pose(const char* x, const char* y, const char* heading) {
    return Pose2{.position = point(x, y), .heading = number(heading)};
  }

  void complain(const std::string& message) {
    if (!error_) error_ = fail(fmt::format("{}: {}", where_, message)).value();
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  std::string_view next() {
    return index_ < fields_->size() ? (*fields_)[index_++] : std::string_view();
  }

  const Fields* fields_;
  std::string where_;
  std::size_t index_ = 0;
  std::optional<Error> error_;
};

// Checks the number of fields first, because it explains a missing separator best.
constexpr std::size_t kFixedFields = 19;
constexpr std::size_t kObstacleFields = 4;

OcpInstance read_instance(const Fields& fields, LineReader& line) {
  OcpInstance instance;
  instance.id = line.integer("id");
  instance.kind = line.word();
  const int count = line.integer("nobs");
  if (line.error()) return instance;
  if (count < 0 || count > kMaxObstacles) {
    line.complain(fmt::format("nobs: expected 0 to {}, found {}", kMaxObstacles, count));
    return instance;
  }
  const auto obstacles = static_cast<std::size_t>(count);
  const std::size_t expected = kFixedFields + kObstacleFields * obstacles;
  if (fields.size() != expected) {
    line.complain(
        fmt::format("expected {} fields for nobs = {}, found {}", expected, count, fields.size()));
    return instance;
  }
  instance.start = line.pose("x0", "y0", "psi0");
  instance.current_target = line.pose("g1x", "g1y", "g1psi");
  instance.next_target = line.pose("g2x", "g2y", "g2psi");
  instance.rectangle.seed = line.point("Px", "Py");
  instance.rectangle.orientation = line.number("theta");
  instance.rectangle.min = line.point("xl", "yl");
  instance.rectangle.max = line.point("xr", "yr");
  for (std::size_t j = 0; j < obstacles; ++j) {
    MovingObstacle obstacle{.radius = kObstacleRadius};
    obstacle.position = line.point("ox", "oy");
    obstacle.velocity = line.point("vx", "vy");
    instance.obstacles.push_back(obstacle);
  }
  if (instance.rectangle.is_empty())
    line.complain("xl yl xr yr: expected xl <= xr and yl <= yr, found the opposite");
  return instance;
}

OcpResult read_result(const Fields& fields, LineReader& line) {
  OcpResult result;
  constexpr std::size_t kExpected = 4 + 2 * kOcpHorizon;
  if (fields.size() != kExpected) {
    line.complain(fmt::format("expected {} fields, found {}", kExpected, fields.size()));
    return result;
  }
  result.id = line.integer("id");
  result.status = line.integer("status");
  result.iterations = line.integer("iterations");
  result.time_us = line.number("time_us");
  for (int k = 0; k < kOcpHorizon; ++k) {
    const std::string u = fmt::format("u{}", k);
    const std::string r = fmt::format("r{}", k);
    result.commands.push_back(
        Twist2{.linear = line.number(u.c_str()), .angular = line.number(r.c_str())});
  }
  return result;
}

template <typename Item>
Expected<std::vector<Item>> parse_lines(std::string_view text,
                                        const std::string& name,
                                        Item (*read_item)(const Fields&, LineReader&)) {
  std::vector<Item> items;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find('\n');
    const Fields fields = split(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (fields.empty()) continue;
    LineReader line(fields, fmt::format("{}:{}", name, number));
    items.push_back(read_item(fields, line));
    if (line.error()) return tl::unexpected<Error>(*line.error());
  }
  if (items.empty()) return fail(fmt::format("{}: expected at least one line, found none", name));
  return items;
}

}  // namespace

ControlProblem control_problem(const OcpInstance& instance) noexcept {
  return control_problem(instance, paper_mpc_settings(), paper_robot_settings());
}

ControlProblem control_problem(const OcpInstance& instance,
                               const MpcSettings& mpc,
                               const RobotSettings& robot) noexcept {
  return paper_problem(mpc, robot,
                       {.start = instance.start,
                        .previous_command = {},
                        .current_target = instance.current_target,
                        .next_target = instance.next_target,
                        .region = instance.rectangle.shrunk(kInwardOffset),
                        .obstacles = instance.obstacles,
                        .robot_radius = 0.0});
}

Expected<std::vector<OcpInstance>> parse_ocp_instances(std::string_view text,
                                                       const std::string& name) {
  return parse_lines<OcpInstance>(text, name, read_instance);
}

Expected<std::vector<OcpInstance>> read_ocp_instances(const std::string& path) {
  const Expected<std::string> text = read_whole_file(path, kLargestInstances);
  if (!text) return tl::unexpected<Error>(text.error());
  return parse_ocp_instances(*text, path);
}

Expected<std::vector<OcpResult>> parse_ocp_results(std::string_view text, const std::string& name) {
  return parse_lines<OcpResult>(text, name, read_result);
}

Expected<std::vector<OcpResult>> read_ocp_results(const std::string& path) {
  const Expected<std::string> text = read_whole_file(path, kLargestInstances);
  if (!text) return tl::unexpected<Error>(text.error());
  return parse_ocp_results(*text, path);
}

std::string format_ocp_results(std::span<const OcpResult> results) {
  std::string text;
  for (const OcpResult& result : results) {
    text +=
        fmt::format("{} {} {} {:.3f}", result.id, result.status, result.iterations, result.time_us);
    for (const Twist2& command : result.commands)
      text += ' ' + number_text(command.linear) + ' ' + number_text(command.angular);
    text += '\n';
  }
  return text;
}

Expected<void> write_ocp_results(const std::string& path, std::span<const OcpResult> results) {
  return write_file_atomically(path, format_ocp_results(results));
}

}  // namespace fairway::io
