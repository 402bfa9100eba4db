// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/timestamp.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace fairway::vda5050 {

namespace {

// Reads `count` digits from `at` on; -1 if there are fewer.
int digits(std::string_view text, std::size_t at, std::size_t count) {
  if (at + count > text.size()) return -1;
  int value = 0;
  for (std::size_t i = at; i < at + count; ++i) {
    if (text[i] < '0' || text[i] > '9') return -1;
    value = 10 * value + (text[i] - '0');
  }
  return value;
}

// The offset from UTC at the end of a timestamp [s].
std::optional<double> offset_of(std::string_view text) {
  if (text == "Z" || text == "z") return 0.0;
  if (text.size() != 6 || (text[0] != '+' && text[0] != '-') || text[3] != ':') return std::nullopt;
  const int hours = digits(text, 1, 2);
  const int minutes = digits(text, 4, 2);
  if (hours < 0 || hours > 23 || minutes < 0 || minutes > 59) return std::nullopt;
  return (text[0] == '-' ? -1.0 : 1.0) * (3600.0 * hours + 60.0 * minutes);
}

}  // namespace

std::string to_timestamp(double seconds) {
  using namespace std::chrono;
  constexpr double kLast = 253402300799.0;  // the end of the year 9999
  const double within = seconds >= 0.0 ? std::min(seconds, kLast) : 0.0;
  const auto total = static_cast<std::int64_t>(std::floor(1000.0 * within + 0.5));
  const sys_time<milliseconds> time{milliseconds(total)};
  const auto day = floor<days>(time);
  const year_month_day date{day};
  const hh_mm_ss clock{time - day};
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ",
                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()), static_cast<int>(clock.hours().count()),
                static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()),
                static_cast<int>(clock.subseconds().count()));
  return text.data();
}

std::optional<double> from_timestamp(std::string_view text) {
  using namespace std::chrono;
  constexpr std::size_t kSecondsEnd = 19;  // length of "2026-11-30T08:00:00"
  if (text.size() <= kSecondsEnd || text[4] != '-' || text[7] != '-' || text[10] != 'T' ||
      text[13] != ':' || text[16] != ':') {
    return std::nullopt;
  }
  const int y = digits(text, 0, 4);
  const int m = digits(text, 5, 2);
  const int d = digits(text, 8, 2);
  const int hour = digits(text, 11, 2);
  const int minute = digits(text, 14, 2);
  const int second = digits(text, 17, 2);
  if (y < 0 || m < 0 || d < 0 || hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 ||
      second > 60) {
    return std::nullopt;
  }
  const year_month_day date{year(y), month(static_cast<unsigned>(m)),
                            day(static_cast<unsigned>(d))};
  if (!date.ok()) return std::nullopt;
  std::size_t at = kSecondsEnd;
  double fraction = 0.0;
  if (text[at] == '.') {
    double scale = 0.1;
    const std::size_t first = ++at;
    for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
      fraction += scale * (text[at] - '0');
      scale *= 0.1;
    }
    if (at == first) return std::nullopt;
  }
  const std::optional<double> offset = offset_of(text.substr(at));
  if (!offset) return std::nullopt;
  const auto midnight = static_cast<double>(sys_days(date).time_since_epoch().count()) * 86400.0;
  return midnight + 3600.0 * hour + 60.0 * minute + second + fraction - *offset;
}

}  // namespace fairway::vda5050
