// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "ros2_double.hpp"
