// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/people_runs.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "experiments/people/people_files.hpp"
#include "experiments/people/people_summary.hpp"
#include "fairway/geometry/angle.hpp"
#include "support/runs/temporary_folder.hpp"

namespace fairway {
namespace {

double no_clock() { return 0.0; }

PeopleOptions recorded_options() {
  PeopleOptions options{.settings = {}, .clock = no_clock};
  use_recorded_robot(options.settings);
  return options;
}

constexpr const char* kCasesHeader =
    "scene,case,task,start_x,start_y,goal_x,goal_y,start_frame,start_time,time_limit\n";

TEST(PeopleRuns, ArriveWithoutPeople) {
  const RecordedCase task{.number = 4, .start = {0, 0}, .goal = {6, 0}, .time_limit = 10.0};
  const PeopleRun run = run_recorded(task, {}, recorded_options());
  EXPECT_EQ(run.outcome, PeopleOutcome::Success);
  EXPECT_GT(run.time, 5.0 / 1.75);
  EXPECT_LT(run.time, 5.0 / 1.75 + 1.0);
  EXPECT_NEAR(run.path, 5.0, 0.2);
  ASSERT_FALSE(run.rows.empty());
  EXPECT_EQ(run.rows.front().pose.position, task.start);
  EXPECT_NEAR(run.rows.back().time, run.time, 1e-9);
}

TEST(PeopleRuns, EndAtAContactAndAtTheTimeLimit) {
  PeopleRecording recording;
  for (int frame = 0; frame < 40; ++frame)
    recording.frames[frame] = {{.person = 1, .position = {0.45, 0.0}}};
  const RecordedCase task{.start = {0, 0}, .goal = {6, 0}, .time_limit = 2.0};
  const PeopleRun contact = run_recorded(task, recording, recorded_options());
  EXPECT_EQ(contact.outcome, PeopleOutcome::Contact);
  EXPECT_EQ(contact.time, 0.0);
  EXPECT_TRUE(contact.contact_between_steps);
  const PeopleRun timeout = run_recorded(task, {}, recorded_options());
  EXPECT_EQ(timeout.outcome, PeopleOutcome::Timeout);
  EXPECT_EQ(timeout.rows.size(), 21U);
}

TEST(PeopleRuns, NoticeAContactBetweenTwoFrames) {
  // The person jumps over the robot from one frame to the next.
  PeopleRecording recording;
  recording.frames[0] = {{.person = 1, .position = {0.0, 2.0}}};
  recording.frames[1] = {{.person = 1, .position = {0.0, -2.0}}};
  const RecordedCase task{.start = {0, 0}, .goal = {6, 0}, .time_limit = 10.0};
  const PeopleRun run = run_recorded(task, recording, recorded_options());
  EXPECT_EQ(run.outcome, PeopleOutcome::Success);
  EXPECT_TRUE(run.contact_between_steps);
}

TEST(PeopleRuns, AreEqualForEqualInput) {
  const CrowdCase one = draw_case(CrowdBenchmark::CrowdNav, 11, 1011);
  PeopleOptions options{.settings = {}, .clock = no_clock};
  use_crowd_robot(CrowdBenchmark::CrowdNav, Kinematics::Ours, options.settings);
  const PeopleRun a = run_crowd(CrowdBenchmark::CrowdNav, one, options);
  const PeopleRun b = run_crowd(CrowdBenchmark::CrowdNav, one, options);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  EXPECT_EQ(a.rows.back().pose.position, b.rows.back().pose.position);
  EXPECT_EQ(people_rows_csv(a), people_rows_csv(b));
}

TEST(PeopleRuns, KeepTheLimitsOfTheRobot) {
  const CrowdCase one = draw_case(CrowdBenchmark::DsRnn, 2, 1002);
  for (const Kinematics kinematics : {Kinematics::Ours, Kinematics::Jumps}) {
    PeopleOptions options{.settings = {}, .kinematics = kinematics, .clock = no_clock};
    use_crowd_robot(CrowdBenchmark::DsRnn, kinematics, options.settings);
    const PeopleRun run = run_crowd(CrowdBenchmark::DsRnn, one, options);
    for (std::size_t i = 1; i < run.rows.size(); ++i) {
      const double driven = (run.rows[i].pose.position - run.rows[i - 1].pose.position).norm();
      EXPECT_LE(driven, 0.1 + 1e-9);
      EXPECT_LE(std::abs(shortest_turn(run.rows[i].pose.heading, run.rows[i - 1].pose.heading)),
                0.1 + 1e-9);
    }
  }
}

TEST(PeopleRuns, NeedAPeriodThatDividesTheStep) {
  Settings settings;
  settings.navigation.control_period = 0.1;
  EXPECT_TRUE(check_period(settings, 0.1));
  EXPECT_FALSE(check_period(settings, 0.25));
  settings.navigation.control_period = 0.5;
  EXPECT_FALSE(check_period(settings, 0.25));
}

TEST(PeopleFiles, ReadScenesWithOtherNamesAndNumbers) {
  const test::TemporaryFolder folder;
  folder.write("cases.csv", std::string(kCasesHeader) + "UNIV,300,flow,-1,2.5,3,4,10,1.0,12.5\n");
  folder.write("tracks_univ.csv", "frame,id,x,y,vx,vy\n10,7,1.5,2,0,0\n10,8,3,4,0,0\n");
  const auto cases = io::read_recorded_cases(folder.path(""), {300});
  ASSERT_TRUE(cases) << cases.error().message;
  EXPECT_EQ(cases->front().start, Eigen::Vector2d(-1.0, 2.5));
  EXPECT_EQ(cases->front().time_limit, 12.5);
  const auto recording = io::read_recording(folder.path(""), "UNIV");
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->at(10).size(), 2U);
  EXPECT_TRUE(recording->at(11).empty());
}

TEST(PeopleFiles, NameTheLineAndTheColumnOfAnError) {
  const test::TemporaryFolder folder;
  const auto error = [&](const std::string& line) {
    folder.write("cases.csv", std::string(kCasesHeader) + "A,1,flow,0,0,1,1,0,0,5\n" + line);
    const auto cases = io::read_recorded_cases(folder.path(""), {});
    return cases ? std::string("none") : cases.error().message;
  };
  EXPECT_NE(error("A,x,flow,0,0,1,1,0,0,5\n").find("cases.csv:3: case: expected a whole number"),
            std::string::npos);
  EXPECT_NE(error("A,2,flow,nan,0,1,1,0,0,5\n").find("cases.csv:3: start_x: expected a number"),
            std::string::npos);
  EXPECT_NE(error("A,1,flow,0,0,1,1,0,0,5\n").find("expected each case once"), std::string::npos);
  EXPECT_NE(error("A,2,flow\n").find("cases.csv:3: expected 10 values, found 3"),
            std::string::npos);
  EXPECT_NE(error("../A,2,flow,0,0,1,1,0,0,5\n").find("scene: expected the name"),
            std::string::npos);
  EXPECT_EQ(error(""), "none");
}

TEST(PeopleSummary, AveragesOverSuccesses) {
  PeopleSummary summary;
  summary.add({.outcome = PeopleOutcome::Success, .time = 4.0, .closest = 1.0, .steps = 10});
  summary.add({.outcome = PeopleOutcome::Success, .time = 6.0, .closest = 2.0, .steps = 10});
  summary.add({.outcome = PeopleOutcome::Contact, .time = 90.0, .steps = 20, .danger = 10});
  EXPECT_DOUBLE_EQ(summary.share(PeopleOutcome::Success), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(summary.mean_time(), 5.0);
  EXPECT_DOUBLE_EQ(summary.mean_closest(), 1.5);
  EXPECT_DOUBLE_EQ(summary.danger_rate(), 0.25);
}

}  // namespace
}  // namespace fairway
