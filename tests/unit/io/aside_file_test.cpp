// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/aside_file.hpp"

#include <gtest/gtest.h>

#include "support/runs/temporary_folder.hpp"

namespace fairway::io {
namespace {

using test::content_of;
using test::TemporaryFolder;

TEST(AsideFile, GetsItsNameWhenItIsWhole) {
  const TemporaryFolder folder;
  const std::string path = folder.write("x", "old");
  auto file = AsideFile::create(path).value();
  file->write("new ");
  file->write("content");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_TRUE(file->commit());
  EXPECT_EQ(content_of(path), "new content");
  EXPECT_EQ(folder.count_files(), 1U);
}

TEST(AsideFile, LeavesTheOlderFileWhereItIsGivenUp) {
  const TemporaryFolder folder;
  const std::string path = folder.write("x", "old");
  AsideFile::create(path).value()->write("half");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder.count_files(), 1U);
}

TEST(AsideFile, IsRefusedWhileAnotherWritesIt) {
  const TemporaryFolder folder;
  auto first = AsideFile::create(folder.path("x")).value();
  const auto second = AsideFile::create(folder.path("x"));
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("another run"), std::string::npos);
  first->write("whole");
  EXPECT_TRUE(first->commit());
  EXPECT_EQ(content_of(folder.path("x")), "whole");
  EXPECT_TRUE(AsideFile::create(folder.path("x")));
}

// What a killed run has left is no part of the next one.
TEST(AsideFile, BeginsEmptyAfterAKilledRun) {
  const TemporaryFolder folder;
  folder.write("x.part", "a long rest of an older run");
  auto file = AsideFile::create(folder.path("x")).value();
  file->write("new");
  EXPECT_TRUE(file->commit());
  EXPECT_EQ(content_of(folder.path("x")), "new");
  EXPECT_EQ(folder.count_files(), 1U);
}

TEST(AsideFile, SaysWhereTheDiskIsFull) {
  auto file = AsideFile::create("/dev/full").value();
  file->write("x");
  const auto committed = file->commit();
  ASSERT_FALSE(committed);
  EXPECT_TRUE(committed.error().message.starts_with("/dev/full: cannot be written: "));
}

TEST(AsideFile, KeepsALink) {
  const TemporaryFolder folder;
  folder.write("target", "old");
  std::filesystem::create_symlink("target", folder.path("link"));
  auto file = AsideFile::create(folder.path("link")).value();
  file->write("new");
  EXPECT_TRUE(file->commit());
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
  EXPECT_EQ(content_of(folder.path("target")), "new");
}

TEST(AsideFile, IsRefusedWhereNothingCanBeWritten) {
  const TemporaryFolder folder;
  EXPECT_FALSE(AsideFile::create(folder.path("none/x")));
  EXPECT_FALSE(AsideFile::create(folder.path("")));
  EXPECT_FALSE(AsideFile::create(""));
}

}  // namespace
}  // namespace fairway::io
