// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_run.hpp"

namespace fairway::test {
namespace {

using nlohmann::json;

std::set<std::string> files_in(const TemporaryFolder& folder, const std::string& name) {
  const std::filesystem::path root = folder.path(name);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.is_regular_file()) names.insert(std::filesystem::relative(entry, root).string());
  }
  return names;
}

TEST(Reproduce, GivesTheSameBytesForTheSameSeed) {
  const TemporaryFolder folder;
  // A run may have a contact, which gives exit code 1; this test only compares the files.
  const int code = run_tool(folder, "reproduce all --maps 1 --threads 1 --out a").code;
  EXPECT_LE(code, 1);
  EXPECT_EQ(run_tool(folder, "reproduce all --maps 1 --threads 2 --out b").code, code);
  const std::set<std::string> names = files_in(folder, "a");
  EXPECT_EQ(names, files_in(folder, "b"));
  EXPECT_TRUE(names.contains("index.html"));
  EXPECT_TRUE(names.contains("figures/case2_figure7_environment1.svg"));
  for (const std::string& name : names) {
    if (name == "timing.html" || name == "results.json") continue;
    EXPECT_EQ(content_of(folder.path("a/" + name)), content_of(folder.path("b/" + name))) << name;
  }
  json a = json::parse(content_of(folder.path("a/results.json")));
  json b = json::parse(content_of(folder.path("b/results.json")));
  EXPECT_TRUE(a.at("timing").contains("case2"));
  EXPECT_EQ(a.at("schema"), "fairway/reproduce.v1");
  a.erase("provenance");  // the command lines differ
  b.erase("provenance");
  a.erase("timing");
  b.erase("timing");
  EXPECT_EQ(a, b);
}

TEST(Reproduce, WritesEveryKindOfPicture) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool(folder, "reproduce case2 --maps 1 --out here/inside");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("here/inside/index.html"), std::string::npos);
  const std::string figure = folder.path("here/inside/figures/case2_figure9_fields");
  EXPECT_TRUE(content_of(figure + ".svg").starts_with("<?xml"));
  EXPECT_TRUE(content_of(figure + ".png").starts_with("\x89PNG"));
  EXPECT_TRUE(content_of(figure + ".pdf").starts_with("%PDF"));
}

TEST(Reproduce, RefusesBadUsageInOneLine) {
  const TemporaryFolder folder;
  folder.write("file", "");
  for (const char* arguments :
       {"reproduce", "reproduce case4 --out x", "reproduce case2", "reproduce case2 --out file/x",
        "reproduce case2 --out x --maps -1", "reproduce case1 --out x --solver simplex"}) {
    const ToolRun run = run_tool(folder, arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_TRUE(run.err.starts_with("fairway: ")) << run.err;
  }
}

}  // namespace
}  // namespace fairway::test
