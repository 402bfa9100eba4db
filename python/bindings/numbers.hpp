// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "fairway/prediction/moving_obstacle.hpp"

namespace fairway::python {

namespace py = pybind11;

/// Throws the error for Python's ValueError: "NAME: expected EXPECTED, found FOUND".
[[noreturn]] void refuse(const std::string& name, const std::string& expected, py::handle found);

/// Reads `least` to `numbers.size()` numbers from a tuple, a list or an array.
/// @return how many there were. @throws py::value_error for anything else.
std::size_t read_numbers(py::handle source,
                         const char* name,
                         const char* expected,
                         std::size_t least,
                         std::span<double> numbers);

/// A table of numbers, row by row, as NumPy has it in memory.
struct NumberTable {
  py::array_t<double, py::array::c_style | py::array::forcecast> array;
  std::size_t rows = 0;

  [[nodiscard]] const double* row(std::size_t i) const {
    return array.data() + i * static_cast<std::size_t>(array.shape(1));
  }
};

/// Reads an array of any type with the given number of columns; an empty list has no row.
/// @throws py::value_error for another shape.
[[nodiscard]] NumberTable read_table(py::handle source, const char* name, std::size_t columns);

/// Makes an array of zeros with this number of rows and columns.
[[nodiscard]] py::array_t<double> new_table(std::size_t rows, std::size_t columns);

/// Points as an array with the columns x and y [m].
[[nodiscard]] py::array_t<double> points_array(std::span<const Eigen::Vector2d> points);

/// Moving obstacles as an array with the columns x, y, velocity in x and y, radius.
[[nodiscard]] py::array_t<double> obstacles_array(MovingObstacles obstacles);

}  // namespace fairway::python
