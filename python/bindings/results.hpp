// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "fairway/base/error.hpp"
#include "fairway/io/maps/map_file.hpp"

namespace fairway::python {

namespace py = pybind11;

/// Runs a function that uses nothing of Python, so that other threads of Python can run.
template <typename Call>
auto without_gil(Call&& call) {
  const py::gil_scoped_release release;
  return call();
}

/// Returns the value, or throws the error, which Python receives as a ValueError.
template <typename Value>
Value value_of(Expected<Value> result) {
  if (!result) throw std::invalid_argument(result.error().message);
  if constexpr (!std::is_void_v<Value>) return std::move(*result);
}

/// Passes texts to Python's `warnings`; those about old names of settings are deprecations.
inline void warn(const std::vector<std::string>& texts,
                 PyObject* category = PyExc_DeprecationWarning) {
  for (const std::string& text : texts) {
    if (PyErr_WarnEx(category, text.c_str(), 1) != 0) throw py::error_already_set();
  }
}

/// Passes what the reader of a file notes to Python's `warnings`.
inline void warn(const io::FileNotes& notes) {
  warn(notes.warnings, PyExc_UserWarning);
  warn(notes.old_names);
}

}  // namespace fairway::python
