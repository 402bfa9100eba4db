// SPDX-License-Identifier: Apache-2.0
// Not Nav2: by hand.
#pragma once

#include <stdexcept>
#include <string>

namespace nav2_core {
class ControllerException : public std::runtime_error {
 public:
  explicit ControllerException(const std::string& description) : runtime_error(description) {}
};
class InvalidController : public ControllerException {
 public:
  explicit InvalidController(const std::string& description) : ControllerException(description) {}
};
class ControllerTFError : public ControllerException {
 public:
  explicit ControllerTFError(const std::string& description) : ControllerException(description) {}
};
class InvalidPath : public ControllerException {
 public:
  explicit InvalidPath(const std::string& description) : ControllerException(description) {}
};
class NoValidControl : public ControllerException {
 public:
  explicit NoValidControl(const std::string& description) : ControllerException(description) {}
};
}  // namespace nav2_core
