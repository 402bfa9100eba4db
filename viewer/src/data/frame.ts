// SPDX-License-Identifier: Apache-2.0
import type { Point, Pose } from './geometry';

export interface Body extends Point {
  vx: number;
  vy: number;
  radius: number;
}

/** Where the row that limits a plan lies. */
export type Mark = { shape: 'side'; a: Point; b: Point } | { shape: 'disc'; a: Point; radius: number };

/** A robot in a control cycle. */
export interface Cycle {
  linear: number;
  angular: number;
  commandLinear: number;
  commandAngular: number;
  status: number;
  limit: number;
  rectangle: number;
  clearance: number;
  micros: number;
  row: number;
  mark: Mark | null;
  iterations: number;
  violation: number;
  prediction: Point[];
  believed: Body[];
}

export interface RobotFrame extends Pose {
  collided: boolean;
  plan: Plan | null;
  cycle: Cycle | null;
  /** Where its own frame lies, for a robot with a lidar: all that it believes is in it. */
  belief: Pose | null;
  scan: Scan | null;
  /** The map it drives on, and for a robot with a lidar what of it was seen to be occupied. */
  slots: { known: number; occupied: number };
  /** Where it was sent, if its plans may lead to places before that. */
  goal: Goal | null;
  /** Of its last cycle, also where it has none in this frame: it has arrived, say. */
  status: number | null;
}

/** What a lidar saw, in the frame that its robot believes to be in. */
export interface Scan {
  time: number;
  points: Float32Array; // x, y of where beams ended on something; there are many of them
}

/** Everything at one time. */
export interface Frame {
  time: number;
  bodies: Body[];
  robots: RobotFrame[];
}

export interface Goal extends Point {
  heading: number | null;
}

export interface Plan {
  robot: number;
  time: number;
  usable: boolean;
  goal: Goal;
  reason: string;
  path: Point[];
  /** Where the robot's centre may be: four corners each, counter-clockwise. */
  rectangles: Point[][];
}
