// SPDX-License-Identifier: Apache-2.0
import type { Point, Pose } from './geometry';

export interface Body extends Point {
  vx: number;
  vy: number;
  radius: number;
}

/** The place of the constraint that limits a plan. */
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

/** What a robot touched: nothing known, a static obstacle, a body, or another robot. */
export interface Contact {
  with: 'nothing' | 'obstacle' | 'body' | 'robot';
  other: number;
  time: number;
  /** Speeds of the robot and of the other towards each other; not above 0 when they separate. */
  approach: number;
  otherApproach: number;
}

export interface RobotFrame extends Pose {
  collided: boolean;
  /** It was removed from the running world. */
  absent: boolean;
  contact: Contact | null;
  plan: Plan | null;
  cycle: Cycle | null;
  /** The pose of the frame of a robot with a lidar, in which all its estimates are given. */
  belief: Pose | null;
  scan: Scan | null;
  /** The maps that it uses: the known one, and for a robot with a lidar its occupied cells. */
  slots: { known: number; occupied: number };
  /** The goal, if plans may end at other places first. */
  goal: Goal | null;
  /** Status of its last cycle, also if it has no cycle in this frame, for example after arrival. */
  status: number | null;
}

/** The scan of a lidar, in the robot's own frame. */
export interface Scan {
  time: number;
  points: Float32Array; // x, y of each beam with a hit
}

/** The state of everything at one time. */
export interface Frame {
  time: number;
  bodies: Body[];
  robots: RobotFrame[];
}

export interface Goal extends Point {
  heading: number | null;
}

/** What closes every route: its place, its size, and the size that the robot needs. */
export interface Obstruction extends Point {
  kind: 'start' | 'goal' | 'gap' | 'closed';
  found: number;
  needed: number;
}

export interface Plan {
  robot: number;
  time: number;
  usable: boolean;
  /** The robot's goal was dropped. */
  dropped: boolean;
  obstruction: Obstruction | null;
  goal: Goal;
  reason: string;
  path: Point[];
  /** Where the robot's centre may be: four corners each, counter-clockwise. */
  rectangles: Point[][];
}
