// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/whole_file.hpp"

#include <sys/stat.h>

#include <filesystem>

#include <gtest/gtest.h>

#include "support/runs/temporary_folder.hpp"

namespace fairway::io {
namespace {

using test::content_of;
using test::TemporaryFolder;

TEST(WholeFile, ReadsEveryByte) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n", 4);
  EXPECT_EQ(read_whole_file(folder.write("f", bytes), 4).value(), bytes);
}

TEST(WholeFile, RefusesAnythingButAFileWithinTheLimit) {
  const TemporaryFolder folder;
  const auto message = [](const std::string& path) {
    const auto result = read_whole_file(path, 3);
    return result ? "" : result.error().message;
  };
  EXPECT_EQ(message(folder.path("none")),
            folder.path("none") + ": expected a file, found nothing of that name");
  EXPECT_EQ(message(folder.path("")), folder.path("") + ": expected a file, found a folder");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: expected a file, found a device or a pipe");
  EXPECT_NE(message(folder.write("f", "1234")), "");
  EXPECT_NE(message(""), "");
}

TEST(WholeFile, ReplacesAFileAndLeavesNoTemporaryFile) {
  const TemporaryFolder folder;
  const std::string path = folder.write("f", "old");
  ASSERT_TRUE(write_file_atomically(path, "new"));
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(folder.count_files(), 1U);
}

TEST(WholeFile, WritesThroughASymbolicLink) {
  const TemporaryFolder folder;
  const std::string path = folder.write("f", "old");
  std::filesystem::create_symlink(path, folder.path("link"));
  ASSERT_TRUE(write_file_atomically(folder.path("link"), "new"));
  EXPECT_EQ(content_of(path), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
}

TEST(WholeFile, ReportsWhyItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_FALSE(write_file_atomically(folder.path("no/such/folder"), "x"));
  EXPECT_FALSE(write_file_atomically(folder.path(""), "x"));
  EXPECT_FALSE(write_file_atomically("", "x"));
  EXPECT_FALSE(write_file_atomically("/dev/full", "x"));
  EXPECT_EQ(folder.count_files(), 0U);
}

}  // namespace
}  // namespace fairway::io
