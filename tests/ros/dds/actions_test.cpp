// SPDX-License-Identifier: Apache-2.0
// The actions over DDS: accepting, feedback, results, cancelling and replacing goals.
#include <dds/ddsi/ddsi_serdata.h>

#include "ros/dds/action_rig.hpp"

namespace fairway::dds {
namespace {

TEST_F(Actions, AGoalIsAcceptedExecutedAndSucceeds) {
  EXPECT_TRUE(accepts(kFirst));
  EXPECT_EQ(frame, "map");
  EXPECT_EQ(target, Eigen::Vector2d(3.0, -4.0));
  EXPECT_TRUE(actions.active());
  const std::int64_t result = navigate.client.request_result(kFirst);
  bridge::DriveProgress progress;
  progress.begin(10.0);
  progress.update({}, 7.5, 12.25);
  actions.give_feedback(progress, {.position = {1.0, 2.0}, .heading = 0.0}, "map", 12.25);
  wait_for([&] { return !navigate.feedback[kFirst].empty(); });
  const NavigateToPose::Feedback& feedback = navigate.feedback[kFirst][0];
  EXPECT_FLOAT_EQ(feedback.distance_remaining, 7.5F);
  EXPECT_EQ(feedback.navigation_time.sec, 2);
  EXPECT_EQ(feedback.navigation_time.nanosec, 250'000'000U);
  EXPECT_EQ(feedback.current_pose.pose.position.y, 2.0);
  EXPECT_TRUE(navigate.results.empty()) << "the goal is still active";
  wait_for([&] { return navigate.statuses[kFirst] == ActionStatus::Executing; });
  actions.succeed(wall_time());
  wait_for([&] { return navigate.results.count(result) > 0; });
  EXPECT_EQ(navigate.results[result], ActionStatus::Succeeded);
  EXPECT_EQ(navigate.error_code, 0);
  wait_for([&] { return navigate.statuses[kFirst] == ActionStatus::Succeeded; });
  EXPECT_EQ(result_of(kFirst), ActionStatus::Succeeded) << "a later request has the same answer";
}

TEST_F(Actions, AnAbortedGoalHasNav2sErrorCodeAndAText) {
  accepts(kFirst);
  actions.abort(ActionFault::GoalBlocked, "the robot does not fit at the goal", wall_time());
  EXPECT_EQ(result_of(kFirst), ActionStatus::Aborted);
  EXPECT_EQ(navigate.error_code, 206);
  EXPECT_EQ(navigate.error, "the robot does not fit at the goal");
}

TEST_F(Actions, ACancelledGoalEndsWhenTheRobotHasStopped) {
  accepts(kFirst);
  EXPECT_EQ(cancel(kFirst), 0);
  EXPECT_EQ(navigate.canceling, 1);
  EXPECT_EQ(cancels, 1);
  EXPECT_TRUE(actions.canceling());
  wait_for([&] { return navigate.statuses[kFirst] == ActionStatus::Canceling; });
  actions.canceled(wall_time());
  EXPECT_FALSE(actions.active());
  EXPECT_EQ(result_of(kFirst), ActionStatus::Canceled);
  EXPECT_EQ(cancel(kFirst), 3) << "it has ended";
}

TEST_F(Actions, ASecondGoalReplacesTheFirst) {
  accepts(kFirst);
  const std::int64_t result = navigate.client.request_result(kFirst);
  EXPECT_TRUE(accepts(kSecond));
  wait_for([&] { return navigate.results.count(result) > 0; });
  EXPECT_EQ(navigate.results[result], ActionStatus::Aborted);
  EXPECT_FALSE(navigate.error.empty());
  wait_for([&] { return navigate.statuses[kSecond] == ActionStatus::Executing; });
  EXPECT_EQ(navigate.statuses[kFirst], ActionStatus::Aborted);
  EXPECT_EQ(cancels, 0) << "the robot drives on to the second goal";
}

TEST_F(Actions, AGoalOfTheOtherActionReplacesIt) {
  accepts(kFirst);
  std::string odom = "odom";
  std::string none;
  std::vector<geometry_msgs_msg_dds__PoseStamped_> path(3);
  for (geometry_msgs_msg_dds__PoseStamped_& pose : path)
    pose.header = header(odom, 1.0);
  FollowPath::Goal goal{};
  goal.path.header = header(odom, 1.0);
  point_to(path, goal.path.poses);
  goal.controller_id = goal.goal_checker_id = goal.progress_checker_id = none.data();
  const std::int64_t number = follow.client.send(kSecond, goal);
  wait_for([&] { return follow.accepted.count(number) > 0; });
  EXPECT_TRUE(follow.accepted[number]);
  EXPECT_EQ(frame, "odom");
  EXPECT_EQ(poses, 3);
  EXPECT_EQ(result_of(kFirst), ActionStatus::Aborted);
  const std::int64_t result = follow.client.request_result(kSecond);
  actions.abort(ActionFault::NoProgress, "stuck", wall_time());
  wait_for([&] { return follow.results.count(result) > 0; });
  EXPECT_EQ(follow.error_code, 105);
  EXPECT_EQ(follow.error, "stuck");
}

TEST_F(Actions, UnknownAndRepeatedGoalsAreAnswered) {
  EXPECT_EQ(result_of(kSecond), ActionStatus::Unknown);
  EXPECT_EQ(cancel(kSecond), 2);
  EXPECT_TRUE(accepts(kFirst));
  EXPECT_FALSE(accepts(kFirst)) << "an id is accepted once";
  EXPECT_TRUE(actions.active());
  EXPECT_EQ(cancel({}), 0) << "zeros cancel every goal";
  EXPECT_TRUE(actions.canceling());
}

TEST_F(Actions, TwoClientsReceiveTheirOwnAnswersOnly) {
  Participant other(domain(), "robot_0");
  Client<NavigateToPose> second(other);
  wait_for([&] { return second.client.is_served(); });
  const std::int64_t number = send(kFirst);
  wait_for([&] { return navigate.accepted.count(number) > 0; });
  second.receive();
  EXPECT_TRUE(second.accepted.empty());
  wait_for([&] {
    second.receive();
    return second.statuses[kFirst] == ActionStatus::Executing;
  });
}

// A late client receives the states of the goals, because the topic is transient local.
TEST_F(Actions, ALateClientReceivesTheStates) {
  accepts(kFirst);
  Participant late(domain(), "robot_0");
  Client<NavigateToPose> second(late);
  wait_for([&] {
    second.receive();
    return second.statuses[kFirst] == ActionStatus::Executing;
  });
}

TEST_F(Actions, RequestsOfAnotherMiddlewareAreNotServed) {
  Writer<NavigateToPose::SendGoalRequest> writer(
      user, "//rq/navigate_to_pose/_action/send_goalRequest", {});
  wait_for([&] { return writer.is_read(); });
  std::string none;
  NavigateToPose::SendGoalRequest request{};
  request.goal.pose.header.frame_id = request.goal.behavior_tree = none.data();
  testing::internal::CaptureStderr();
  writer.send(request);
  EXPECT_TRUE(accepts(kFirst)) << "requests of ROS 2's clients are served as before";
  EXPECT_NE(testing::internal::GetCapturedStderr().find("RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"),
            std::string::npos);
  EXPECT_EQ(target.x(), 3.0);
}

// The bytes of a request as rmw_cyclonedds_cpp writes and reads them: little-endian CDR, with the
// client's handle and the number of the request before the message.
TEST(RequestBytes, BeginWithTheHeaderOfTheMiddleware) {
  Participant participant(domain(), "");
  Reader<NavigateToPose::SendGoalRequest> reader(participant, "//rq/bytesRequest", {});
  Writer<NavigateToPose::SendGoalRequest> writer(participant, "//rq/bytesRequest", {});
  std::string map = "map";
  std::string none;
  NavigateToPose::SendGoalRequest request{};
  request.header = {.client = 0x1122334455667788, .number = 5};
  request.goal_id = to_uuid({0xA1, 0xA2});
  request.goal.pose.header = header(map, 3.0);
  request.goal.pose.pose.position.x = 2.0;
  request.goal.behavior_tree = none.data();
  writer.send(request);
  ddsi_serdata* sample = nullptr;
  dds_sample_info_t info{};
  ASSERT_EQ(dds_takecdr(reader.get(), &sample, 1, &info, DDS_ANY_STATE), 1);
  std::vector<std::uint8_t> bytes(ddsi_serdata_size(sample));
  ddsi_serdata_to_ser(sample, 0, bytes.size(), bytes.data());
  ddsi_serdata_unref(sample);
  const std::vector<std::uint8_t> begin{
      0x00, 0x01, 0x00, 0x00,                          // little-endian CDR
      0x88, 0x77, 0x66, 0x55, 0x44, 0x33, 0x22, 0x11,  // handle of the client
      5,    0,    0,    0,    0,    0,    0,    0,     // number of the request
      0xA1, 0xA2, 0,    0,    0,    0,    0,    0,    0, 0, 0, 0, 0, 0, 0, 0,  // id of the goal
      3,    0,    0,    0,    0,    0,    0,    0,                             // stamp
      4,    0,    0,    0,    'm',  'a',  'p',  0,                             // frame
      0,    0,    0,    0,    0,    0,    0,    0x40};                         // x = 2.0
  ASSERT_GE(bytes.size(), begin.size());
  EXPECT_EQ(bytes[3] & 0xFC, 0);
  bytes[3] = 0;  // holds the number of padding bytes at the end
  bytes.resize(begin.size());
  EXPECT_EQ(bytes, begin);
}

TEST(TopicNames, AreRos2s) {
  const Participant solo(domain(), "");
  const Participant robot(domain(), "robot_0");
  EXPECT_EQ(solo.topic_name("navigate_to_pose/_action/status"),
            "rt/navigate_to_pose/_action/status");
  EXPECT_EQ(solo.topic_name("//rq/navigate_to_pose/_action/send_goalRequest"),
            "rq/navigate_to_pose/_action/send_goalRequest");
  EXPECT_EQ(robot.topic_name("//rr/navigate_to_pose/_action/send_goalReply"),
            "rr/robot_0/navigate_to_pose/_action/send_goalReply");
  EXPECT_EQ(robot.topic_name("/tf"), "rt/tf");
}

}  // namespace
}  // namespace fairway::dds
