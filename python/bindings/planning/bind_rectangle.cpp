// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/geometry/oriented_rectangle.hpp"

namespace fairway::python {

namespace {

OrientedRectangle make_rectangle(const Eigen::Vector2d& seed,
                                 double orientation,
                                 const Eigen::Vector2d& min,
                                 const Eigen::Vector2d& max) {
  return {.seed = seed, .orientation = orientation, .min = min, .max = max};
}

}  // namespace

void bind_rectangle(py::module_& module) {
  py::class_<OrientedRectangle>(
      module, "Rectangle",
      "A turned rectangle with its sides and corners. Its own frame has its origin at `seed` and "
      "is rotated by `orientation`; `min` and `max` are the corners there.")
      .def(py::init(&make_rectangle), py::arg("seed") = Eigen::Vector2d(0.0, 0.0),
           py::arg("orientation") = 0.0, py::arg("min") = Eigen::Vector2d(0.0, 0.0),
           py::arg("max") = Eigen::Vector2d(0.0, 0.0))
      .def_readwrite("seed", &OrientedRectangle::seed, "Point that it was grown from [m].")
      .def_readwrite("orientation", &OrientedRectangle::orientation,
                     "Rotation of its own frame relative to the world [rad].")
      .def_readwrite("min", &OrientedRectangle::min, "Lower-left corner in its own frame [m].")
      .def_readwrite("max", &OrientedRectangle::max, "Upper-right corner in its own frame [m].")
      .def_property_readonly("area", &OrientedRectangle::area, "Area [m^2]; 0 if it is empty.")
      .def_property_readonly("is_empty", &OrientedRectangle::is_empty,
                             "Whether it contains no point.")
      .def_property_readonly("center", &OrientedRectangle::center, "Centre in the world [m].")
      .def_property_readonly(
          "corners",
          [](const OrientedRectangle& rectangle) { return points_array(rectangle.corners()); },
          "Corners in the world [m], 4 x 2, counter-clockwise, starting at `min`.")
      .def("contains", &OrientedRectangle::contains, py::arg("point"), py::arg("tolerance") = 0.0,
           "Returns whether a point lies inside, or beyond a side by at most `tolerance` [m].")
      .def("to_local", &OrientedRectangle::to_local, py::arg("point"),
           "Transforms a point of the world to the rectangle's own frame.")
      .def("to_world", &OrientedRectangle::to_world, py::arg("local"),
           "Transforms a point of the rectangle's own frame to the world.")
      .def("shrunk", &OrientedRectangle::shrunk, py::arg("offset"),
           "Returns the rectangle with every side moved inward by `offset` [m].")
      .def("__repr__", [](const OrientedRectangle& r) {
        return py::str("Rectangle(seed={}, orientation={}, min={}, max={})")
            .format(r.seed, r.orientation, r.min, r.max);
      });
}

}  // namespace fairway::python
