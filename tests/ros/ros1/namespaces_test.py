# SPDX-License-Identifier: Apache-2.0
"""Three robots under one master, each in a namespace: namespaces_test.py PACKAGE."""

import math
import sys
import unittest

from ros_system import RosSystem, skip

try:
    import actionlib
    import rospy
    from actionlib_msgs.msg import GoalStatus
    from geometry_msgs.msg import PoseStamped
    from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
    from std_msgs.msg import Bool
except ImportError as missing:
    skip(f"ROS 1's Python packages: {missing}")

PACKAGE = sys.argv[1]
LANES = {"red": 2.0, "green": 5.0, "blue": 8.0}  # y of each robot's lane [m]
START_X, GOAL_X = 2.0, 7.0


class NamespacesTest(unittest.TestCase):
    def setUp(self):
        self.ros = RosSystem(PACKAGE)
        self.good = False
        scenario = self.write_scenario()
        self.ros.node("fairway_ros_simulator", f"_scenario:={scenario}")
        for name in LANES:
            self.ros.node("fairway_ros_node", f"_base_frame:={name}/base_link", "map:=/map",
                          name=name, namespace=name)
        rospy.init_node("namespaces_test", disable_signals=True)

    def tearDown(self):
        self.ros.close(show=not self.good)

    def write_scenario(self):
        width, height = 200, 200  # 10 m x 10 m, open
        with open(self.ros.path("hall.pgm"), "wb") as image:
            image.write(f"P5\n{width} {height}\n255\n".encode() + b"\xfe" * (width * height))
        with open(self.ros.path("hall.yaml"), "w", encoding="utf-8") as header:
            header.write("image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                         "occupied_thresh: 0.65\nfree_thresh: 0.25\n")
        path = self.ros.path("lanes.yaml")
        with open(path, "w", encoding="utf-8") as file:
            file.write("map: hall.yaml\nrobots:\n")
            for name, y in LANES.items():
                file.write(f"  - {{name: {name}, start: [{START_X}, {y}, 0], goal: [{GOAL_X}, {y}]}}\n")
        return path

    def test_each_robot_obeys_its_own_goals(self):
        truth, contact, clients = {}, {}, {}
        for name in LANES:
            rospy.Subscriber(f"{name}/truth", PoseStamped,
                             lambda message, name=name: truth.update({name: message.pose.position}))
            rospy.Subscriber(f"{name}/contact", Bool,
                             lambda message, name=name: contact.update({name: message.data}))
            clients[name] = actionlib.SimpleActionClient(f"{name}/move_base", MoveBaseAction)
            self.assertTrue(clients[name].wait_for_server(rospy.Duration(30)), name)
        self.ros.wait_for(lambda: len(truth) == len(LANES), 20, "the simulator")

        # Only one robot has a goal; the others do not move.
        self.send(clients, "green")
        self.finish(clients, truth, "green")
        for name in ("red", "blue"):
            self.assertLess(math.hypot(truth[name].x - START_X, truth[name].y - LANES[name]), 1e-6)

        for name in ("red", "blue"):
            self.send(clients, name)
        for name in ("red", "blue"):
            self.finish(clients, truth, name)
        self.assertEqual(contact, {name: False for name in LANES})
        self.good = True

    def send(self, clients, name):
        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = "map"
        goal.target_pose.pose.position.x = GOAL_X
        goal.target_pose.pose.position.y = LANES[name]
        goal.target_pose.pose.orientation.w = 1.0
        clients[name].send_goal(goal)

    def finish(self, clients, truth, name):
        self.assertTrue(clients[name].wait_for_result(rospy.Duration(40)), name)
        self.assertEqual(clients[name].get_state(), GoalStatus.SUCCEEDED, name)
        self.assertLess(math.hypot(truth[name].x - GOAL_X, truth[name].y - LANES[name]), 0.15)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings="ignore")
