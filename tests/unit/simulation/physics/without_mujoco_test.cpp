// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

TEST(MujocoPhysics, IsNotBuilt) {
  GTEST_SKIP() << "MuJoCo was not found (Debian: libmujoco-dev libqhull-dev)";
}
