// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/maps/map_image.hpp"

namespace fairway::io {
namespace {

// A valid header with one line replaced or, if `line` is empty, omitted.
std::string header_with(const std::string& key = "", const std::string& line = "") {
  std::string text;
  for (const char* good :
       {"image: map.pgm", "resolution: 0.05", "origin: [1, -2, 0.5]", "negate: 0",
        "occupied_thresh: 0.65", "free_thresh: 0.196", "mode: trinary"}) {
    const std::string own = good;
    const bool replaced = !key.empty() && own.starts_with(key + ":");
    if (!replaced) text += own + "\n";
    if (replaced && !line.empty()) text += line + "\n";
  }
  return text;
}

std::string header_complaint(const std::string& text) {
  const auto header = parse_map_header(text, "m.yaml");
  return header ? "none" : header.error().message;
}

TEST(MapHeader, ReadsEveryKey) {
  const auto header = parse_map_header(header_with(), "m.yaml");
  ASSERT_TRUE(header) << header.error().message;
  EXPECT_EQ(header->image, "map.pgm");
  EXPECT_EQ(header->resolution, 0.05);
  EXPECT_EQ(header->origin.position, Eigen::Vector2d(1, -2));
  EXPECT_EQ(header->origin.heading, 0.5);
  EXPECT_FALSE(header->negate);
  EXPECT_EQ(header->occupied_thresh, 0.65);
  EXPECT_EQ(header->free_thresh, 0.196);
  EXPECT_EQ(header->mode, MapMode::Trinary);
}

TEST(MapHeader, IsTrinaryWithoutMode) {
  EXPECT_EQ(parse_map_header(header_with("mode"), "m").value().mode, MapMode::Trinary);
  EXPECT_EQ(parse_map_header(header_with("mode", "mode: raw"), "m").value().mode, MapMode::Raw);
}

TEST(MapHeader, MayHaveEqualThresholdsWhereNothingIsScaled) {
  for (const char* mode : {"mode: trinary", "mode: raw"}) {
    std::string text = header_with("free_thresh", "free_thresh: 0.65");
    text.replace(text.find("mode: trinary"), 13, mode);
    EXPECT_EQ(header_complaint(text), "none") << mode;
  }
}

TEST(MapHeader, IsRefusedBeyondItsLimit) {
  EXPECT_EQ(header_complaint(std::string(65537, ' ')),
            "m.yaml: expected at most 65536 bytes, found 65537");
}

TEST(MapHeader, TakesNegateAsNumberOrWord) {
  EXPECT_TRUE(parse_map_header(header_with("negate", "negate: 1"), "m").value().negate);
  EXPECT_TRUE(parse_map_header(header_with("negate", "negate: true"), "m").value().negate);
}

TEST(MapHeader, NamesFileLineKeyExpectedAndFound) {
  EXPECT_EQ(header_complaint(header_with("resolution", "resolution: 0")),
            "m.yaml:2: resolution: expected a number above 0 and at most 1000, found '0'");
  EXPECT_EQ(header_complaint(header_with("resolution", "resolution: -0.05")),
            "m.yaml:2: resolution: expected a number above 0 and at most 1000, found '-0.05'");
  EXPECT_EQ(header_complaint(header_with("resolution", "resolution: .nan")),
            "m.yaml:2: resolution: expected a number above 0 and at most 1000, found '.nan'");
  EXPECT_EQ(header_complaint(header_with("resolution")),
            "m.yaml:1: resolution: expected a number above 0 and at most 1000, found no such key");
  EXPECT_EQ(header_complaint(header_with("negate", "negate: maybe")),
            "m.yaml:4: negate: expected true or false, found 'maybe'");
  EXPECT_EQ(header_complaint(header_with("mode", "mode: color")),
            "m.yaml:7: mode: expected trinary, scale or raw, found 'color'");
  EXPECT_EQ(header_complaint(header_with("mode", "mood: raw")),
            "m.yaml:7: 'mood': expected one of free_thresh, image, mode, negate, occupied_thresh, "
            "origin, resolution, found an unknown key");
  EXPECT_EQ(header_complaint(header_with("free_thresh", "free_thresh: 0.7")),
            "m.yaml:6: free_thresh: expected at most occupied_thresh 0.65, found 0.7");
  std::string scale = header_with("free_thresh", "free_thresh: 0.65");
  scale.replace(scale.find("mode: trinary"), 13, "mode: scale");
  EXPECT_EQ(header_complaint(scale),
            "m.yaml:6: free_thresh: expected in mode scale less than occupied_thresh 0.65, found "
            "0.65");
  EXPECT_EQ(header_complaint(header_with("origin", "origin: [0, nan, 0]")),
            "m.yaml:3: origin: expected a list of 3 numbers, found 'nan'");
  EXPECT_EQ(header_complaint(header_with("origin", "origin: [0, 0]")),
            "m.yaml:3: origin: expected a list of 3 numbers, found 2 of them");
  EXPECT_EQ(header_complaint("image: a\n" + header_with()),
            "m.yaml:2: 'image': expected a key once, found it twice");
}

TEST(MapHeader, RefusesEveryOtherWrongValue) {
  for (const char* line :
       {"resolution: inf", "resolution: 1e400", "resolution: 1e-9", "resolution: 1e9",
        "resolution: [0.05]", "resolution: abc", "resolution: ''", "resolution:"}) {
    EXPECT_NE(header_complaint(header_with("resolution", line)), "none") << line;
  }
  for (const char* line : {"origin: 0", "origin: [0, 0, .inf]", "origin: [1e300, 0, 0]",
                           "origin: {x: 0}", "origin: [[0], 0, 0]", "origin:"}) {
    EXPECT_NE(header_complaint(header_with("origin", line)), "none") << line;
  }
  for (const char* line : {"image:", "image: []", "image: ''"}) {
    EXPECT_NE(header_complaint(header_with("image", line)), "none") << line;
  }
  for (const char* key : {"image", "origin", "negate", "occupied_thresh", "free_thresh"}) {
    EXPECT_NE(header_complaint(header_with(key)), "none") << key;
  }
  EXPECT_NE(header_complaint(header_with("occupied_thresh", "occupied_thresh: 1.5")), "none");
  EXPECT_NE(header_complaint(header_with("free_thresh", "free_thresh: -0.1")), "none");
}

TEST(MapHeader, RefusesWhatIsNotOneMapping) {
  for (const std::string& text :
       {std::string(""), std::string("# nothing"), std::string("- a\n- b"), std::string("text"),
        std::string("a: [unclosed"), std::string("a: b: c"), std::string("\0\1\2\3", 4),
        std::string("\x89PNG\r\n\x1a\n"), std::string("\xff\xfe\xff"), std::string("{? [1]: 2}"),
        std::string("---\na: 1\n---\nb: 2"), std::string("&a [*a]"), std::string("a: &x [*x]"),
        std::string(5000, '['), std::string(5000, '{')}) {
    const std::string message = header_complaint(text);
    EXPECT_TRUE(message.starts_with("m.yaml:")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace fairway::io
