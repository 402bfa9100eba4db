// SPDX-License-Identifier: Apache-2.0
#include "bridge/sensing/obstacle_cloud.hpp"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

const std::vector<MovingObstacle> kTwo{
    {.position = {1.5, -2.0}, .velocity = {0.25, 0.5}, .radius = 0.375},
    {.position = {100.0, 3.0}, .velocity = {0.0, -1.0}, .radius = 0.5}};

CloudView view_of(const std::vector<std::uint8_t>& data) {
  return {.fields = kObstacleFields, .points = 2, .point_step = kObstacleStep, .data = data};
}

TEST(ObstacleCloud, ReadsWhatItWrites) {
  const std::vector<std::uint8_t> data = write_obstacles(kTwo);
  const auto read = read_obstacles(view_of(data));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ((*read)[i].position, kTwo[i].position);
    EXPECT_EQ((*read)[i].velocity, kTwo[i].velocity);
    EXPECT_EQ((*read)[i].radius, kTwo[i].radius);
  }
}

TEST(ObstacleCloud, ReadsDoublesInAnyOrderAndStaticObstacles) {
  const std::array<CloudField, 3> fields{
      {{"radius", 0, kFloat64}, {"y", 8, kFloat64}, {"x", 16, kFloat64}}};
  const std::array<double, 3> values{0.4, 2.0, 1.0};
  std::vector<std::uint8_t> data(sizeof(values));
  std::memcpy(data.data(), values.data(), sizeof(values));
  const auto read = read_obstacles({.fields = fields, .points = 1, .point_step = 24, .data = data});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->at(0).position, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(read->at(0).velocity, Eigen::Vector2d::Zero());
  EXPECT_EQ(read->at(0).radius, 0.4);
}

TEST(ObstacleCloud, NamesTheFieldThatItCannotRead) {
  const std::vector<std::uint8_t> data = write_obstacles(kTwo);
  const auto message_of = [](const CloudView& cloud) {
    const auto read = read_obstacles(cloud);
    return read ? std::string() : read.error().message;
  };
  CloudView cloud = view_of(data);
  cloud.fields = cloud.fields.subspan(1);
  EXPECT_EQ(message_of(cloud), "obstacles: expected a field x, found none");
  cloud = view_of(data);
  cloud.points = 3;
  EXPECT_EQ(message_of(cloud), "obstacles: data: expected 3 points of 24 bytes, found 48 bytes");
  cloud.points = ~0ULL;
  EXPECT_NE(message_of(cloud), "");
  cloud = view_of(data);
  cloud.point_step = 22;
  EXPECT_NE(message_of(cloud).find("radius: expected an offset inside a point of 22"),
            std::string::npos);
  cloud = view_of(data);
  cloud.big_endian = true;
  EXPECT_NE(message_of(cloud), "");
  const std::array<CloudField, 3> bytes{{{"x", 0, kFloat32}, {"y", 4, 2}, {"radius", 8, kFloat32}}};
  cloud = view_of(data);
  cloud.fields = bytes;
  EXPECT_NE(message_of(cloud).find("y: expected FLOAT32 or FLOAT64, found datatype 2"),
            std::string::npos);
}

TEST(ObstacleCloud, ReadsAnEmptyCloud) {
  const auto read =
      read_obstacles({.fields = kObstacleFields, .points = 0, .point_step = 24, .data = {}});
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->empty());
}

}  // namespace
}  // namespace fairway::bridge
