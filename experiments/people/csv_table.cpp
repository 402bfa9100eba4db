// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/csv_table.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "fairway/io/number_text.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::io {

namespace {

constexpr std::size_t kLargestTable = 64U << 20U;  // [bytes]

std::vector<std::string_view> split(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::vector<std::string_view> values;
  while (true) {
    const std::size_t comma = line.find(',');
    values.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return values;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

Expected<CsvTable> CsvTable::read(const std::string& path,
                                  const std::vector<std::string>& columns) {
  Expected<std::string> content = read_whole_file(path, kLargestTable);
  if (!content) return tl::unexpected(content.error());
  CsvTable table;
  table.path_ = path;
  table.content_ = std::make_shared<const std::string>(*std::move(content));
  table.columns_ = columns;
  std::string_view rest = *table.content_;
  const auto take_line = [&rest] {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    return line;
  };
  const std::vector<std::string_view> names = split(take_line());
  std::vector<std::size_t> places;
  for (const std::string& column : columns) {
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end())
      return fail(fmt::format("{}:1: expected a column {}, found none", path, column));
    places.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  for (int number = 2; !rest.empty(); ++number) {
    const std::string_view line = take_line();
    if (line.empty()) continue;
    const std::vector<std::string_view> all = split(line);
    if (all.size() != names.size()) {
      return fail(fmt::format("{}:{}: expected {} values, found {}", path, number, names.size(),
                              all.size()));
    }
    std::vector<std::string_view> values;
    for (const std::size_t place : places)
      values.push_back(all[place]);
    table.lines_.push_back({.number = number, .values = std::move(values)});
  }
  return table;
}

std::string_view CsvTable::text(std::size_t row, std::size_t column) const noexcept {
  return lines_[row].values[column];
}

double CsvTable::number(std::size_t row, std::size_t column, double low, double high) {
  const std::optional<double> value = parse_number(text(row, column));
  if (value && *value >= low && *value <= high) return *value;
  complain(row, column, fmt::format("expected a number from {:g} to {:g}", low, high));
  return low;
}

int CsvTable::whole(std::size_t row, std::size_t column, int low, int high) {
  const std::optional<int> value = parse_integer(text(row, column));
  if (value && *value >= low && *value <= high) return *value;
  complain(row, column, fmt::format("expected a whole number from {} to {}", low, high));
  return low;
}

void CsvTable::complain(std::size_t row, std::size_t column, const std::string& expected) {
  if (!error_.empty()) return;
  const std::string_view found = text(row, column);
  error_ = fmt::format("{}:{}: {}: {}, found {}", path_, lines_[row].number, columns_[column],
                       expected, found.empty() ? "nothing" : excerpt(found));
}

}  // namespace fairway::io
