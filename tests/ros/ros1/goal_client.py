# SPDX-License-Identifier: Apache-2.0
"""Sends one goal by the action, then waits; the test kills it during the drive."""

import sys

import actionlib
import rospy
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal

rospy.init_node("goal_client")
client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
client.wait_for_server()
goal = MoveBaseGoal()
goal.target_pose.header.frame_id = "map"
goal.target_pose.pose.position.x = float(sys.argv[1])
goal.target_pose.pose.position.y = float(sys.argv[2])
goal.target_pose.pose.orientation.w = 1.0
client.send_goal(goal)
client.wait_for_result()
