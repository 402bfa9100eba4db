// SPDX-License-Identifier: Apache-2.0
#pragma once

// Emscripten 3.1.6 brings a standard library that lacks some parts of C++20. This header, which
// every source is compiled with, adds those that the sources use. A newer library has its own.
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>
#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
namespace std {

#ifndef __cpp_lib_bit_cast
template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
#endif

namespace ranges {
template <typename Range, typename Predicate>
constexpr bool any_of(const Range& range, Predicate predicate) {
  return std::any_of(std::begin(range), std::end(range), predicate);
}
template <typename First, typename Second>
constexpr bool equal(const First& a, const Second& b) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b));
}
}  // namespace ranges

// Numbers as in the C locale, which is the only one here.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  const bool digit =
      !text.empty() &&
      (text.front() == '-' || text.front() == '.' || (text.front() >= '0' && text.front() <= '9') ||
       text.front() == 'i' || text.front() == 'n' || text.front() == 'I' || text.front() == 'N');
  const bool hexadecimal = text.find_first_of("xX") != string::npos;
  char* end = nullptr;
  errno = 0;
  const double number = strtod(text.c_str(), &end);
  if (!digit || hexadecimal || end == text.c_str()) return {first, errc::invalid_argument};
  const char* stop = first + (end - text.c_str());
  if (errno == ERANGE) return {stop, errc::result_out_of_range};
  value = number;
  return {stop, errc()};
}

// There are no threads: a program that starts one ends.
class stop_token {
 public:
  [[nodiscard]] bool stop_requested() const noexcept { return false; }
};
class jthread {
 public:
  jthread() noexcept = default;
  template <typename Function>
  explicit jthread(Function&& /*work*/) {
    abort();
  }
  void request_stop() noexcept {}
  void join() noexcept {}
};

}  // namespace std
#endif
