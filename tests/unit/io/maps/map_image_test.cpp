// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/map_image.hpp"

#include <Magick++.h>
#include <gtest/gtest.h>

namespace fairway::io {
namespace {

std::string p5(int width, int height, const std::string& pixels, const char* comment = "") {
  return "P5\n" + std::string(comment) + std::to_string(width) + " " + std::to_string(height) +
         "\n255\n" + pixels;
}

std::string png(int width, int height, const std::string& format, const std::string& pixels) {
  Magick::InitializeMagick(nullptr);
  Magick::Image image(static_cast<unsigned>(width), static_cast<unsigned>(height), format,
                      Magick::CharPixel, pixels.data());
  image.matte(format.find('A') != std::string::npos);
  Magick::Blob blob;
  image.write(&blob, "PNG");
  return {static_cast<const char*>(blob.data()), blob.length()};
}

std::string image_complaint(const std::string& bytes) {
  const auto image = decode_map_image(bytes, "m.pgm");
  return image ? "none" : image.error().message;
}

using Levels = std::vector<std::uint32_t>;

TEST(MapImage, ReadsBinaryPgm) {
  const auto image = decode_map_image(p5(2, 2, std::string("\x00\xff\xcd\x01", 4)), "m").value();
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.brightness, (Levels{0, 3 * 65535, 3 * 257 * 0xcd, 3 * 257}));
  EXPECT_TRUE(image.opaque.empty());
}

TEST(MapImage, ReadsCommentsInTheHeader) {
  const auto image = decode_map_image(p5(1, 1, "\xff", "# CREATOR: 3 3 map_saver\n"), "m");
  EXPECT_EQ(image.value().brightness, Levels{MapImage::kWhite});
}

TEST(MapImage, AcceptsAFirstPixelThatLooksLikeWhitespaceOrAComment) {
  EXPECT_EQ(decode_map_image(p5(2, 1, "# "), "m").value().brightness,
            (Levels{3 * 257 * '#', 3 * 257 * ' '}));
}

TEST(MapImage, ReadsTextPgm) {
  EXPECT_EQ(decode_map_image("P2 3 1 15\n0 #half\n 15\n5", "m").value().brightness,
            (Levels{0, 3 * 65535, 65535}));
}

TEST(MapImage, Reads16BitsPerSample) {
  EXPECT_EQ(decode_map_image("P5 2 1 65535\n" + std::string("\x12\x34\xff\xff", 4), "m")
                .value()
                .brightness,
            (Levels{3 * 0x1234, 3 * 65535}));
}

TEST(MapImage, ReadsGreyAndColourPng) {
  EXPECT_EQ(decode_map_image(png(2, 1, "I", "\x10\xff"), "m").value().brightness,
            (Levels{3 * 257 * 16, MapImage::kWhite}));
  EXPECT_EQ(decode_map_image(png(1, 1, "RGB", "\x01\x02\x03"), "m").value().brightness,
            (Levels{257 * 6}));
}

TEST(MapImage, DetectsOpaquePixels) {
  const auto image =
      decode_map_image(png(2, 1, "RGBA", "\xff\xff\xff\xff\xff\xff\xff\x80"), "m").value();
  EXPECT_EQ(image.opaque, (std::vector<bool>{true, false}));
}

TEST(MapImage, DetectsATruncatedFileAtEveryLength) {
  const std::string pgm = p5(4, 4, std::string(16, 'x'));
  for (std::size_t length = 0; length < pgm.size(); ++length) {
    EXPECT_NE(image_complaint(pgm.substr(0, length)), "none") << length;
  }
  const std::string picture = png(4, 4, "I", std::string(16, 'x'));
  for (std::size_t length = 0; length < picture.size(); ++length) {
    EXPECT_NE(image_complaint(picture.substr(0, length)), "none") << length;
  }
  EXPECT_EQ(image_complaint(pgm.substr(0, pgm.size() - 1)),
            "m.pgm: expected 16 bytes of pixels, found 15: the file is truncated");
  EXPECT_NE(image_complaint("P2 2 2 255 1 2 3"), "none");
}

TEST(MapImage, DetectsADamagedPng) {
  const std::string good = png(4, 4, "I", std::string(16, 'x'));
  ASSERT_EQ(image_complaint(good), "none");
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    EXPECT_NE(image_complaint(bad), "none") << i;
  }
}

TEST(MapImage, RefusesAbsurdSizesBeforeReading) {
  for (const char* size : {"1000000 1000000", "0 5", "5 0", "32769 1", "20000 20000",
                           "99999999999999999999 1", "-1 1", "4294967297 1"}) {
    EXPECT_NE(image_complaint("P5 " + std::string(size) + " 255\nabc"), "none") << size;
    EXPECT_NE(image_complaint("P2 " + std::string(size) + " 255\n1 2"), "none") << size;
  }
}

TEST(MapImage, RefusesSamplesAboveTheMaximum) {
  EXPECT_NE(image_complaint("P2 1 1 15 16"), "none");
  EXPECT_NE(image_complaint("P5 1 1 15\n\x10"), "none");
  EXPECT_NE(image_complaint("P5 1 1 0\n\x10"), "none");
  EXPECT_NE(image_complaint("P5 1 1 70000\n\x10\x10"), "none");
}

TEST(MapImage, AcceptsOnlyPgmAndPng) {
  for (const char* bytes : {"", "P6 1 1 255\nabc", "GIF89a", "BM", "<svg/>", "P5", "P", "%PDF",
                            "push graphic-context", "P5x"}) {
    EXPECT_NE(image_complaint(bytes), "none") << bytes;
  }
}

}  // namespace
}  // namespace fairway::io
