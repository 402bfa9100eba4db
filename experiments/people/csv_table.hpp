// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// A file of comma-separated values whose first line names the columns.
///
/// Values are converted when they are asked for; the first error is kept.
class CsvTable {
 public:
  /// Reads a file. Every line must have as many values as the header has names.
  [[nodiscard]] static Expected<CsvTable> read(const std::string& path,
                                               const std::vector<std::string>& columns);

  [[nodiscard]] std::size_t size() const noexcept { return lines_.size(); }

  /// Returns the value of one of the `columns` in line `row`, from 0 on, as text.
  [[nodiscard]] std::string_view text(std::size_t row, std::size_t column) const noexcept;
  [[nodiscard]] double number(std::size_t row, std::size_t column, double low, double high);
  [[nodiscard]] int whole(std::size_t row, std::size_t column, int low, int high);

  /// Keeps an error about a value: FILE:LINE: column: expected ..., found ...
  void complain(std::size_t row, std::size_t column, const std::string& expected);

  /// The first error; empty if there was none.
  [[nodiscard]] const std::string& error() const noexcept { return error_; }

 private:
  struct Line {
    int number = 0;
    std::vector<std::string_view> values;
  };

  std::string path_;
  std::shared_ptr<const std::string> content_;  // the values are parts of it
  std::vector<std::string> columns_;
  std::vector<Line> lines_;
  std::string error_;
};

}  // namespace fairway::io
