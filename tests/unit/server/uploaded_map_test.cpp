// SPDX-License-Identifier: Apache-2.0
#include "server/uploads/uploaded_map.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fairway/io/base64.hpp"

namespace fairway::app {
namespace {

const std::string kPicture = io::to_base64("P2 2 2 255\n254 0\n205 254\n");

TEST(UploadedMap, IsReadWithAResolution) {
  const nlohmann::json json{{"name", "a"}, {"image", kPicture}, {"resolution", 0.1}};
  const auto uploaded = read_uploaded_map(json.dump());
  ASSERT_TRUE(uploaded) << uploaded.error().message;
  EXPECT_EQ(uploaded->name, "a");
  EXPECT_EQ(uploaded->map.frame().resolution, 0.1);
  EXPECT_EQ(uploaded->map.at({.x = 1, .y = 1}), CellState::Occupied);
  EXPECT_EQ(uploaded->map.at({.x = 0, .y = 0}), CellState::Unknown);
}

TEST(UploadedMap, NeverLooksForTheImageThatTheYamlNames) {
  const std::string yaml =
      "image: /dev/zero\nresolution: 0.2\norigin: [1, 2, 0.5]\nnegate: 1\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  const nlohmann::json json{{"name", "b"}, {"image", kPicture}, {"yaml", yaml}};
  const auto uploaded = read_uploaded_map(json.dump());
  ASSERT_TRUE(uploaded) << uploaded.error().message;
  EXPECT_EQ(uploaded->map.frame().origin.heading, 0.5);
  EXPECT_EQ(uploaded->map.at({.x = 1, .y = 1}), CellState::Free);
}

TEST(UploadedMap, RefusesInvalidMaps) {
  for (const char* text :
       {"", "[]", "{}", R"({"name":"a","image":"*","resolution":0.1})",
        R"({"name":"a","image":"AAAA","resolution":0.1})", R"({"name":"a","image":7})"})
    EXPECT_FALSE(read_uploaded_map(text)) << text;
  nlohmann::json json{{"name", "a"}, {"image", kPicture}, {"resolution", 0.0}};
  EXPECT_FALSE(read_uploaded_map(json.dump()));
  json["resolution"] = "0.1";
  EXPECT_FALSE(read_uploaded_map(json.dump()));
}

// What a hostile client can have built before it is refused is bounded by the first wrong value.
TEST(UploadedMap, RefusesValuesThatNoMapHas) {
  for (const std::string& text :
       {R"({"name":"a","image":[)" + std::string(100'000, '['), std::string(100'000, '['),
        R"({"name":{"a":1}})" + std::string(), R"({"name":"a","more":"b"})" + std::string(),
        R"({"name":"a","image":"AAAA","yaml":7})" + std::string(),
        R"({"name":"a","image":"AAAA","resolution":null})" + std::string(),
        R"({"name":"a","image":"AAAA","resolution":true})" + std::string()}) {
    const auto uploaded = read_uploaded_map(text);
    ASSERT_FALSE(uploaded) << text.substr(0, 60);
    EXPECT_NE(uploaded.error().message.find("expected"), std::string::npos);
  }
}

TEST(UploadedMap, RefusesAYamlBeyondTheLimitOfMapFiles) {
  std::string yaml =
      "image: x\nresolution: 0.2\norigin: [1, 2, 0.5]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\nmore: [";
  for (int i = 0; i < 40'000; ++i)
    yaml += "1,";
  const nlohmann::json json{{"name", "b"}, {"image", kPicture}, {"yaml", yaml + "1]\n"}};
  const auto uploaded = read_uploaded_map(json.dump());
  ASSERT_FALSE(uploaded);
  EXPECT_NE(uploaded.error().message.find("at most 65536 bytes"), std::string::npos);
}

TEST(UploadedMap, CutsALongNameBetweenTwoCharacters) {
  std::string name;
  for (int i = 0; i < 50; ++i)
    name += "\xc3\xa4";  // two bytes each
  const nlohmann::json json{{"name", "x" + name}, {"image", kPicture}, {"resolution", 0.1}};
  EXPECT_EQ(read_uploaded_map(json.dump()).value().name, "x" + name.substr(0, 78));
}

TEST(UploadedMap, RefusesAPictureThatPromisesTooMuchBeforeItIsDecoded) {
  const std::string header("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\xEA\x60\0\0\xEA\x60", 24);
  const nlohmann::json json{{"name", "a"}, {"image", io::to_base64(header)}, {"resolution", 0.1}};
  const auto uploaded = read_uploaded_map(json.dump());
  ASSERT_FALSE(uploaded);
  EXPECT_NE(uploaded.error().message.find("16 million"), std::string::npos);
}

}  // namespace
}  // namespace fairway::app
