# SPDX-License-Identifier: Apache-2.0
"""One robot, from roscore to rosbag: drive_test.py PACKAGE SCENARIOS SHARED_DATA."""

import math
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import threading
import time
import unittest

from ros_system import RosSystem, skip

try:
    import actionlib
    import dynamic_reconfigure.client
    import rosbag
    import rospy
    from actionlib_msgs.msg import GoalStatus
    from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
    from geometry_msgs.msg import PoseStamped, Twist
    from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
    from std_msgs.msg import Bool, String
except ImportError as missing:
    skip(f"ROS 1's Python packages: {missing}")

PACKAGE, SCENARIOS, SHARED_DATA = sys.argv[1:4]
DEPOT = pathlib.Path(SHARED_DATA) / "maps" / "depot.yaml"
# A real map if it is available, else one of the project's; a start, and goals that can be reached.
if DEPOT.exists():
    WORLD = [f"_map:={DEPOT}", "_start:=2.2,1.5,1.57"]
    GOALS = [(6.0, 3.0), (2.2, 4.5)]
    FAR = (25.0, 12.0)
else:
    WORLD = [f"_scenario:={SCENARIOS}/doorways.yaml"]
    GOALS = [(-5.0, 0.0), (-4.0, -3.0)]
    FAR = (5.0, 3.0)

AGE_LIMIT = 0.3      # [s], the longest of the pose's and the scans'
BRAKING = 0.6        # [s], from 1 m/s at 2 m/s^2, plus a cycle
SYSTEM_SLACK = 0.7   # [s], delay of a loaded machine


class Robot:
    """The robot's commands and its true motion, from topics."""

    def __init__(self):
        self.lock = threading.Lock()
        self.commands = []  # (time received, linear, angular)
        self.truth = None
        self.truth_time = 0.0  # when it was received
        self.contact = None
        self.statuses = []
        rospy.Subscriber("cmd_vel", Twist, self.on_command, tcp_nodelay=True)
        rospy.Subscriber("truth", PoseStamped, self.on_truth)
        rospy.Subscriber("contact", Bool, self.on_contact)
        rospy.Subscriber("fairway/status", DiagnosticStatus, self.on_status)

    def on_command(self, message):
        with self.lock:
            self.commands.append((time.monotonic(), message.linear.x, message.angular.z))

    def on_truth(self, message):
        self.truth = message.pose.position
        self.truth_time = time.monotonic()

    def on_contact(self, message):
        self.contact = message.data

    def on_status(self, message):
        self.statuses.append(message)

    def speed(self):
        with self.lock:
            return self.commands[-1][1] if self.commands else 0.0

    def drives(self):
        return self.speed() > 0.5

    def distance(self, goal):
        return math.hypot(self.truth.x - goal[0], self.truth.y - goal[1])

    def commands_since(self, begin):
        with self.lock:
            return [c for c in self.commands if c[0] >= begin]


def goal_message(goal):
    message = PoseStamped()
    message.header.frame_id = "map"
    message.pose.position.x, message.pose.position.y = goal
    message.pose.orientation.w = 1.0
    return message


class DriveTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ros = RosSystem(PACKAGE)
        cls.ros.node("fairway_ros_simulator", *WORLD)
        cls.node = cls.ros.node("fairway_ros_node", "_patience:=8")
        cls.bag = cls.ros.path("drive.bag")
        cls.recorder = cls.ros.start(
            "rosbag", "record", "-O", cls.bag, "/cmd_vel", "/odom", "/tf", "/tf_static", "/map",
            "/fairway/plan", "/fairway/corridor", "/fairway/prediction", "/fairway/status",
            "/diagnostics", "/move_base/result", name="rosbag")
        rospy.init_node("drive_test", disable_signals=True)
        cls.robot = Robot()
        cls.mute = rospy.Publisher("mute", String, queue_size=1, latch=True)
        cls.simple = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        cls.client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
        assert cls.client.wait_for_server(rospy.Duration(30))
        cls.ros.wait_for(lambda: cls.robot.truth is not None, 10, "the simulator")
        cls.ros.wait_for(lambda: os.path.exists(cls.bag + ".active"), 10, "the recorder")

    @classmethod
    def tearDownClass(cls):
        cls.ros.close(show=not getattr(cls, "all_good", False))

    def send(self, goal):
        self.feedback = []
        message = MoveBaseGoal(target_pose=goal_message(goal))
        self.client.send_goal(message, feedback_cb=self.feedback.append)

    def drive_off(self, goal):
        self.send(goal)
        self.ros.wait_for(self.robot.drives, 20, "the robot to drive")

    def expect_stand(self, begin, seconds):
        """Checks that all commands later than `seconds` after `begin` are exactly zero."""
        end = begin + seconds + 0.5
        self.ros.wait_for(lambda: self.robot.truth_time > end, seconds + 20, "the simulator")
        late = self.robot.commands_since(begin + seconds)
        self.assertEqual([c for c in late if c[1] or c[2]], [], "it still moves")
        return late

    def settle(self):
        self.client.cancel_all_goals()
        self.mute.publish("")
        self.ros.wait_for(lambda: self.robot.speed() == 0.0, 10, "the robot to stop")

    def test_1_goals_are_reached_with_feedback(self):
        for goal in GOALS:
            self.send(goal)
            self.assertTrue(self.client.wait_for_result(rospy.Duration(60)), "no result")
            self.assertEqual(self.client.get_state(), GoalStatus.SUCCEEDED)
            self.assertLess(self.robot.distance(goal), 0.15)
            self.assertGreater(len(self.feedback), 10)
        self.assertIs(self.robot.contact, False)

    def test_2_a_cancelled_goal_brakes(self):
        self.drive_off(FAR)
        begin = time.monotonic()
        self.client.cancel_goal()
        self.assertTrue(self.client.wait_for_result(rospy.Duration(5)))
        self.assertEqual(self.client.get_state(), GoalStatus.PREEMPTED)
        self.expect_stand(begin, BRAKING + SYSTEM_SLACK)

    def test_3_a_goal_by_topic_replaces_one_by_action(self):
        self.drive_off(FAR)
        self.simple.publish(goal_message(GOALS[0]))
        self.assertTrue(self.client.wait_for_result(rospy.Duration(5)))
        self.assertEqual(self.client.get_state(), GoalStatus.PREEMPTED)
        self.ros.wait_for(lambda: self.robot.distance(GOALS[0]) < 0.15, 60, "the goal by topic")

    def test_4_goals_that_make_no_sense_are_refused(self):
        self.send((math.nan, 0.0))
        self.assertTrue(self.client.wait_for_result(rospy.Duration(5)))
        self.assertEqual(self.client.get_state(), GoalStatus.REJECTED)
        self.send((-500.0, 0.0))
        self.assertTrue(self.client.wait_for_result(rospy.Duration(20)))
        self.assertEqual(self.client.get_state(), GoalStatus.ABORTED)
        self.assertIn("outside the map", self.client.get_goal_status_text())

    def test_5_a_lost_sensor_stops_the_robot(self):
        for sensor, limit in (("scan", "stale map"), ("odom", "stale pose")):
            self.drive_off(FAR)
            begin = time.monotonic()
            self.mute.publish(sensor)
            late = self.expect_stand(begin, AGE_LIMIT + BRAKING + SYSTEM_SLACK)
            self.assertGreater(len(late), 2, "zero commands continue")
            status = self.robot.statuses[-1]
            self.assertEqual(status.message, "stale")
            self.assertEqual({v.key: v.value for v in status.values}["limit"], limit)
            self.mute.publish("")
            self.ros.wait_for(self.robot.drives, 10, "it to continue")
            self.settle()

    def test_6_a_killed_goal_client_stops_the_robot(self):
        client = self.ros.start("/usr/bin/python3", pathlib.Path(__file__).with_name(
            "goal_client.py"), *FAR, name="goal_client")
        self.ros.wait_for(self.robot.drives, 20, "the robot to drive")
        begin = time.monotonic()
        client.send_signal(signal.SIGKILL)
        self.expect_stand(begin, BRAKING + SYSTEM_SLACK)

    def test_7_settings_change_at_run_time(self):
        settings = dynamic_reconfigure.client.Client("/fairway", timeout=10)
        self.drive_off(GOALS[1] if self.robot.distance(GOALS[1]) > 2.0 else FAR)
        settings.update_configuration({"robot.linear_max": 0.3})
        self.assertAlmostEqual(rospy.get_param("/fairway/robot/linear_max"), 0.3)
        begin = time.monotonic() + 1.0  # until then it may still brake
        self.ros.wait_for(lambda: len(self.robot.commands_since(begin)) >= 10, 20, "ten commands")
        speeds = [c[1] for c in self.robot.commands_since(begin)]
        self.assertLessEqual(max(speeds), 0.3 + 1e-9)
        with self.assertRaises(dynamic_reconfigure.DynamicReconfigureCallbackException):
            settings.update_configuration({"robot.linear_max": -7.0})
        settings.update_configuration({"robot.linear_max": 1.0})
        self.settle()

    def test_8_termination_brakes_and_ends_with_zero(self):
        self.drive_off(FAR)
        self.assertEqual(self.ros.end(self.node, signal.SIGTERM), 0)
        self.ros.wait_for(lambda: self.robot.commands[-1][1:] == (0.0, 0.0), 5, "a last command of zero")
        self.assertIs(self.robot.contact, False)

    def test_9a_the_recording_holds_everything(self):
        self.assertEqual(self.ros.end(self.recorder), 0)
        # `rosbag` may end before the program that it started has renamed the file.
        self.ros.wait_for(lambda: os.path.exists(self.bag), 10, "the recording")
        linear, commanded, scan_to_command, cycle = [], [], [], []
        topics = set()
        with rosbag.Bag(self.bag) as bag:
            for topic, message, received in bag.read_messages():
                topics.add(topic)
                if topic == "/cmd_vel":
                    linear.append(message.linear.x)
                    commanded.append(received.to_sec())
                    self.assertTrue(math.isfinite(message.linear.x + message.angular.z))
                    self.assertEqual((message.linear.y, message.angular.x), (0.0, 0.0))
                elif topic == "/fairway/status":
                    values = {v.key: v.value for v in message.values}
                    cycle.append(float(values["cycle_seconds"]))
                    if "scan_to_command_seconds" in values:
                        scan_to_command.append((float(values["scan_to_command_seconds"]),
                                                float(values["received_to_command_seconds"])))
        self.assertEqual(topics, {
            "/cmd_vel", "/odom", "/tf", "/tf_static", "/map", "/fairway/plan", "/fairway/corridor",
            "/fairway/prediction", "/fairway/status", "/diagnostics", "/move_base/result"})
        self.assertGreater(len(scan_to_command), 100)
        # The stop is a function of time: after a cycle that is late by half a period, the longest that
        # is on time, the command has changed by as much as the acceleration allows until then. On a
        # busy machine a cycle may be later still.
        gaps = [max(0.15, 0.05 + b - a) for a, b in zip(commanded, commanded[1:])]
        steps = [abs(b - a) for a, b in zip(linear, linear[1:])]
        for step, gap in zip(steps, gaps):
            self.assertLessEqual(step, 2.0 * gap + 1e-9)  # 2 m/s^2
        self.assertEqual(linear[-1], 0.0)
        for name, times in (("scan stamp to command", [a for a, _ in scan_to_command]),
                            ("scan received to command", [b for _, b in scan_to_command]),
                            ("control cycle", cycle)):
            times.sort()
            print(f"{name}: median {1e3 * statistics.median(times):.2f} ms, "
                  f"p99 {1e3 * times[int(0.99 * len(times))]:.2f} ms, n {len(times)}")

    def test_9b_bad_parameters_are_named_and_end_the_node(self):
        for parameter, message in (
                ("_mpc/horizn:=3", "'mpc.horizn': expected one of"),
                ("_mpc/step_length:=-1", "mpc.step_length: expected a number from"),
                ("_use_mapp:=true", "use_mapp: expected a group of settings, or one of"),
                ("_use_map:=5", "use_map: expected true or false, found 5")):
            node = self.ros.node("fairway_ros_node", parameter, "__name:=bad", name="bad")
            self.assertEqual(node.wait(20), 2)
            node.log.seek(0)
            text = node.log.read()
            self.assertIn(f"fairway: /bad: {message}", text)
            self.assertEqual(len(text.strip().splitlines()), 1, text)
            subprocess.run(["rosparam", "delete", "/bad"], check=True, capture_output=True)
        type(self).all_good = True


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings="ignore")
