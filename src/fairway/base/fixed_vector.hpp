// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>

#include "fairway/base/contract.hpp"

namespace fairway {

/// At most `N` values, kept in place: a std::vector that never allocates. A copy copies the values
/// in use only. Control cycles use it wherever the number of values is bounded.
template <typename T, std::size_t N>
class FixedVector {
 public:
  using value_type = T;
  using iterator = T*;
  using const_iterator = const T*;

  FixedVector() noexcept {}  // NOLINT(modernize-use-equals-default): the values stay uninitialised
  FixedVector(std::initializer_list<T> values) noexcept { append(values.begin(), values.end()); }
  FixedVector(const FixedVector& other) noexcept { append(other.begin(), other.end()); }
  FixedVector& operator=(const FixedVector& other) noexcept {
    if (this == &other) return *this;
    clear();
    append(other.begin(), other.end());
    return *this;
  }
  ~FixedVector() = default;

  [[nodiscard]] static constexpr std::size_t capacity() noexcept { return N; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] bool full() const noexcept { return size_ == N; }

  void clear() noexcept { size_ = 0; }

  /// @pre !full()
  void push_back(const T& value) noexcept {
    FAIRWAY_EXPECTS(!full());
    values_[size_++] = value;
  }

  /// Appends the values from `first` up to `last`, or as many of them as fit.
  template <typename Iterator>
  void append(Iterator first, Iterator last) noexcept {
    for (; first != last && !full(); ++first)
      values_[size_++] = *first;
  }

  /// Removes the first `count` values. @pre count <= size()
  void pop_front(std::size_t count) noexcept {
    FAIRWAY_EXPECTS(count <= size_);
    std::copy(begin() + count, end(), begin());
    size_ -= count;
  }

  [[nodiscard]] T& operator[](std::size_t i) noexcept { return values_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return values_[i]; }
  /// @pre !empty()
  [[nodiscard]] T& front() noexcept { return values_[0]; }
  [[nodiscard]] const T& front() const noexcept { return values_[0]; }
  [[nodiscard]] T& back() noexcept { return values_[size_ - 1]; }
  [[nodiscard]] const T& back() const noexcept { return values_[size_ - 1]; }

  [[nodiscard]] T* data() noexcept { return values_.data(); }
  [[nodiscard]] const T* data() const noexcept { return values_.data(); }
  [[nodiscard]] T* begin() noexcept { return data(); }
  [[nodiscard]] T* end() noexcept { return data() + size_; }
  [[nodiscard]] const T* begin() const noexcept { return data(); }
  [[nodiscard]] const T* end() const noexcept { return data() + size_; }

 private:
  std::array<T, N> values_;
  std::size_t size_ = 0;
};

}  // namespace fairway
