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

constexpr std::uint32_t kWhite = 3 * 65535;  // of a picture that is no PGM

TEST(MapImage, ReadsBinaryPgm) {
  const auto image = decode_map_image(p5(2, 2, std::string("\x00\xff\xcd\x01", 4)), "m").value();
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.white, 255U);
  EXPECT_EQ(image.brightness, (Levels{0, 255, 0xcd, 1}));
  EXPECT_TRUE(image.opaque.empty());
}

// The smallest, those with a byte per sample, the step to two bytes, and the largest.
TEST(MapImage, KeepsSamplesOfEveryMaximum) {
  for (const int maximum : {1, 2, 3, 15, 100, 127, 254, 255, 256, 1000, 1023, 4095, 65535}) {
    const int half = maximum / 2;
    std::string pixels;
    for (const int sample : {0, half, maximum}) {
      if (maximum > 255) pixels += static_cast<char>(sample / 256);
      pixels += static_cast<char>(sample % 256);
    }
    const std::string head = "3 1 " + std::to_string(maximum) + "\n";
    const std::string text = "0 " + std::to_string(half) + " " + std::to_string(maximum);
    for (const std::string& bytes : {"P5 " + head + pixels, "P2 " + head + text}) {
      const auto image = decode_map_image(bytes, "m");
      ASSERT_TRUE(image) << maximum << ": " << image.error().message;
      EXPECT_EQ(image->white, static_cast<std::uint32_t>(maximum));
      EXPECT_EQ(image->brightness,
                (Levels{0, static_cast<std::uint32_t>(half), static_cast<std::uint32_t>(maximum)}));
    }
  }
}

TEST(MapImage, ReadsHeadersOfEveryStyle) {
  for (const char* head :
       {"P5\n2 1\n255\n", "P5 2 1 255 ", "P5\t2\v1\f255\r", "P5\r\n2 1\r\n255\r\n",
        "P5#first\n#second 9 9\r\n2#width\n\n#height\n1#one\n255\n", "P5 2 1 255#comment\n",
        "P5 002 +1 255\n", "P5 # CREATOR: 3 3 map_saver\n2 1\n255\n"}) {
    const auto image = decode_map_image(std::string(head) + "\x0a#", "m");
    if (std::string(head).find('+') != std::string::npos) {
      EXPECT_FALSE(image) << head;
      continue;
    }
    ASSERT_TRUE(image) << head << image.error().message;
    EXPECT_EQ(image->brightness, (Levels{0x0a, '#'})) << head;
  }
}

TEST(MapImage, TakesAFirstPixelThatLooksLikeABlankOrComment) {
  EXPECT_EQ(decode_map_image(p5(2, 1, "# "), "m").value().brightness, (Levels{'#', ' '}));
  // A line feed behind the carriage return is a pixel where the file is exactly as long as that.
  EXPECT_EQ(decode_map_image("P5 2 1 255\r\n#", "m").value().brightness, (Levels{'\n', '#'}));
}

TEST(MapImage, ReadsTextPgm) {
  EXPECT_EQ(decode_map_image("P2 3 1 15\n0 #half\n 15\n5", "m").value().brightness,
            (Levels{0, 15, 5}));
}

TEST(MapImage, Reads16BitsPerSample) {
  EXPECT_EQ(decode_map_image("P5 2 1 65535\n" + std::string("\x12\x34\xff\xff", 4), "m")
                .value()
                .brightness,
            (Levels{0x1234, 0xffff}));
}

TEST(MapImage, ReadsGreyAndColourPng) {
  EXPECT_EQ(decode_map_image(png(2, 1, "I", "\x10\xff"), "m").value().brightness,
            (Levels{3 * 257 * 16, kWhite}));
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
