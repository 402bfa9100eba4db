// SPDX-License-Identifier: Apache-2.0
#include "server/uploads/uploaded_map.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "fairway/base/utf8_text.hpp"
#include "fairway/io/base64.hpp"
#include "fairway/io/maps/map_file.hpp"
#include "fairway/io/maps/map_image.hpp"
#include "fairway/io/number_text.hpp"

namespace fairway::app {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMostMapCells = 16U << 20U;
constexpr std::size_t kLongestName = 80;

// Returns the number of pixels that a PNG declares, to be checked before memory is allocated. It is
// 0 for others: a PGM has at least a byte per pixel, so the size of the upload bounds it.
std::uint64_t promised_pixels(std::string_view bytes) {
  if (!bytes.starts_with("\x89PNG") || bytes.size() < 24) return 0;
  const auto big_endian = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value << 8U | static_cast<std::uint8_t>(bytes[i]);
    return value;
  };
  return big_endian(16) * big_endian(20);
}

// The texts and the number of an upload. Everything else is refused as soon as it is met, so that a
// hostile client cannot have values built without bound.
class UploadReader final : public nlohmann::json_sax<Json> {
 public:
  std::string name;
  std::string image;
  std::optional<std::string> yaml;
  std::optional<double> resolution;
  std::string error;

  bool null() override { return refuse("a null"); }
  bool boolean(bool /*value*/) override { return refuse("a boolean"); }
  bool number_integer(number_integer_t value) override {
    return number(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override {
    return number(value);
  }
  bool string(string_t& value) override {
    if (key_ == "name") {
      name = std::move(value);
    } else if (key_ == "image") {
      image = std::move(value);
    } else if (key_ == "yaml") {
      yaml = std::move(value);
    } else {
      return refuse("a text");
    }
    return true;
  }
  bool binary(binary_t& /*value*/) override { return refuse("bytes"); }
  bool start_object(std::size_t /*size*/) override {
    return std::exchange(depth_, depth_ + 1) == 0 || refuse("an object");
  }
  bool key(string_t& value) override {
    key_ = std::move(value);
    return true;
  }
  bool end_object() override { return true; }
  bool start_array(std::size_t /*size*/) override { return refuse("a list"); }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position,
                   const std::string& /*token*/,
                   const nlohmann::detail::exception& /*what*/) override {
    error = "expected JSON, found none at byte " + std::to_string(position);
    return false;
  }

 private:
  bool number(double value) {
    if (key_ != "resolution") return refuse("a number");
    resolution = value;
    return true;
  }

  bool refuse(const char* what) {
    error = io::excerpt(key_) + ": expected the name, image, yaml or resolution of a map, found " +
            what;
    return false;
  }

  std::string key_;
  int depth_ = 0;
};

Expected<io::MapHeader> header_of(const UploadReader& upload) {
  if (upload.yaml) return io::parse_map_header(*upload.yaml, upload.name);
  if (!upload.resolution || !(*upload.resolution >= 0.001 && *upload.resolution <= 10.0)) {
    return fail("resolution: expected a number from 0.001 to 10");
  }
  return io::MapHeader{.image = {},
                       .resolution = *upload.resolution,
                       .origin = {},
                       .negate = false,
                       .occupied_thresh = 0.65,
                       .free_thresh = 0.196,
                       .mode = io::MapMode::Trinary};
}

// At most kLongestName bytes, and no character cut in two.
std::string shortened(const std::string& name) {
  std::size_t end = 0;
  while (end < name.size()) {
    const std::size_t length =
        std::max<std::size_t>(1, utf8_length({name.data() + end, name.size() - end}));
    if (end + length > kLongestName) break;
    end += length;
  }
  return one_line(name.substr(0, end));
}

Expected<UploadedMap> read(UploadReader& upload) {
  upload.name = shortened(upload.name);
  const Expected<io::MapHeader> header = header_of(upload);
  if (!header) return tl::unexpected(header.error());
  const auto image = io::from_base64(upload.image);
  if (!image) return fail("image: expected base64");
  if (promised_pixels(*image) > kMostMapCells)
    return fail("image: expected at most 16 million pixels");
  const auto decoded = io::decode_map_image(*image, upload.name);
  if (!decoded) return tl::unexpected(decoded.error());
  auto grid = io::make_grid(*header, *decoded, upload.name);
  if (!grid) return tl::unexpected(grid.error());
  return UploadedMap{.name = upload.name.empty() ? "uploaded" : upload.name,
                     .map = *std::move(grid)};
}

}  // namespace

Expected<UploadedMap> read_uploaded_map(std::string_view json) {
  UploadReader upload;
  if (!Json::sax_parse(json, &upload)) return fail("expected a map: " + upload.error);
  return read(upload);
}

}  // namespace fairway::app
