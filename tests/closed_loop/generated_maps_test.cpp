// SPDX-License-Identifier: Apache-2.0
// As real_maps_test.cpp, on generated maps of buildings and clutter.
#include "fairway/simulation/scenarios/generated_maps.hpp"

#include <gtest/gtest.h>

#include "support/worlds/map_crossing.hpp"

namespace fairway {
namespace {

class GeneratedBuildings : public testing::TestWithParam<MapKind> {};

TEST_P(GeneratedBuildings, AreCrossedWithoutContact) {
  test::expect_crossings_without_contact(generate_map(GetParam(), 5, 30));
}

INSTANTIATE_TEST_SUITE_P(Kinds,
                         GeneratedBuildings,
                         testing::Values(MapKind::UnstructuredSmall,
                                         MapKind::Structured,
                                         MapKind::Field),
                         [](const auto& kind) { return std::string(to_text(kind.param)); });

}  // namespace
}  // namespace fairway
