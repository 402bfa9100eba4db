// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/trace_file.hpp"

#include <gtest/gtest.h>

namespace fairway::io {
namespace {

TEST(TraceFile, HasALinePerRobotAndCycle) {
  EpisodeResult episode;
  episode.robots = {{.name = "a"}, {.name = "b, \"c\""}};
  episode.trace.rows = {{.time = 0.5,
                         .robot = 0,
                         .pose = {.position = {1, -2}, .heading = 0.25},
                         .twist = {.linear = 0.5, .angular = -0.5},
                         .command = {.linear = 0.75, .angular = 0.125},
                         .status = NavigationStatus::Ok,
                         .limit = LimitingFactor::Speed,
                         .rectangle = 3,
                         .clearance = 1.5},
                        {.time = 0.5, .robot = 1}};
  EXPECT_EQ(trace_csv(episode),
            "time,robot,x,y,heading,linear,angular,status,command_linear,command_angular,limit,"
            "rectangle,clearance\n"
            "0.5,a,1,-2,0.25,0.5,-0.5,ok,0.75,0.125,speed limit,3,1.5\n"
            "0.5,\"b, \"\"c\"\"\",0,0,0,0,0,no plan,0,0,none,0,0\n");
}

}  // namespace
}  // namespace fairway::io
