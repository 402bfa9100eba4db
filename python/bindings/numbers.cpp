// SPDX-License-Identifier: Apache-2.0
#include "numbers.hpp"

#include "fairway/io/number_text.hpp"

namespace fairway::python {

void refuse(const std::string& name, const std::string& expected, py::handle found) {
  const auto text = py::repr(found).cast<std::string>();
  throw py::value_error(name + ": expected " + expected + ", found " + io::excerpt(text));
}

std::size_t read_numbers(py::handle source,
                         const char* name,
                         const char* expected,
                         std::size_t least,
                         std::span<double> numbers) {
  const auto items = py::reinterpret_steal<py::object>(PySequence_Fast(source.ptr(), ""));
  std::size_t count = 0;
  if (items && !PyUnicode_Check(source.ptr())) {
    const auto size = static_cast<std::size_t>(PySequence_Fast_GET_SIZE(items.ptr()));
    PyObject** const item = PySequence_Fast_ITEMS(items.ptr());
    while (size <= numbers.size() && count < size) {
      numbers[count] = PyFloat_AsDouble(item[count]);
      if (numbers[count] == -1.0 && PyErr_Occurred() != nullptr) break;
      ++count;
    }
    if (count == size && count >= least) return count;
  }
  PyErr_Clear();
  refuse(name, expected, source);
}

NumberTable read_table(py::handle source, const char* name, std::size_t columns) {
  NumberTable table;
  table.array = decltype(table.array)::ensure(source);
  if (!table.array) PyErr_Clear();
  const bool fits = table.array && table.array.ndim() == 2 &&
                    static_cast<std::size_t>(table.array.shape(1)) == columns;
  if (fits) {
    table.rows = static_cast<std::size_t>(table.array.shape(0));
  } else if (!table.array || table.array.size() != 0) {
    refuse(name, "an array with " + std::to_string(columns) + " columns", source);
  }
  return table;
}

py::array_t<double> new_table(std::size_t rows, std::size_t columns) {
  return py::array_t<double>({rows, columns});
}

py::array_t<double> points_array(std::span<const Eigen::Vector2d> points) {
  py::array_t<double> array = new_table(points.size(), 2);
  double* out = array.mutable_data();
  for (const Eigen::Vector2d& point : points) {
    *out++ = point.x();
    *out++ = point.y();
  }
  return array;
}

py::array_t<double> obstacles_array(MovingObstacles obstacles) {
  py::array_t<double> array = new_table(obstacles.size(), 5);
  double* out = array.mutable_data();
  for (const MovingObstacle& o : obstacles) {
    for (const double value :
         {o.position.x(), o.position.y(), o.velocity.x(), o.velocity.y(), o.radius})
      *out++ = value;
  }
  return array;
}

}  // namespace fairway::python
