// SPDX-License-Identifier: Apache-2.0

import type { Scan } from './belief';

/** Lengths in metres, angles in radians, times in seconds, as everywhere in Fairway. */
export interface Point {
  x: number;
  y: number;
}

export interface Pose extends Point {
  heading: number;
}

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

export interface GridFrame {
  width: number;
  height: number;
  resolution: number;
  origin: Pose;
}

/** A map from some time on. Cells: 0 free, 1 occupied, 2 unknown, lowest row first. */
export interface Grid {
  slot: number;
  time: number;
  frame: GridFrame;
  cells: Uint8Array;
  changes: CellChange[];
}

/** Runs of cells: y, x, count, value. */
export interface CellChange {
  time: number;
  runs: number[];
}

export interface Setting {
  group: string;
  name: string;
  unit: string;
  meaning: string;
  kind: 'number' | 'integer' | 'switch' | 'choice' | 'discs';
  value: number | boolean | string;
  min?: number;
  max?: number;
  choices?: string[];
}

export interface RobotTask {
  name: string;
  start: [number, number, number];
  goal: number[];
}

/** What is said once, at the beginning. */
export interface Begin {
  version: number;
  name: string;
  robots: RobotTask[];
  bodies: string[];
  /** What the robots know. */
  sensing?: 'map' | 'lidar';
  physics?: 'unicycle' | 'mujoco';
  statuses: string[];
  limits: string[];
  rows: string[];
  settings: Setting[];
}

/** A run, as far as it is known. */
export class Run {
  frames: Frame[] = [];
  plans: Plan[][];
  goals: (Goal | null)[];
  scans: (Scan | null)[];
  /** By slot, in order of time: 0 is the true map, the others are what robots see. */
  grids: Grid[][] = [[]];
  settings: Setting[];

  constructor(readonly begin: Begin) {
    this.plans = begin.robots.map(() => []);
    this.goals = begin.robots.map(() => null);
    this.scans = begin.robots.map(() => null);
    this.settings = begin.settings;
  }

  get duration(): number {
    return this.frames.at(-1)?.time ?? 0;
  }

  /** Index of the last frame at or before `time`; 0 before the first. */
  frameIndex(time: number): number {
    let low = 0;
    let high = this.frames.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.frames[middle]!.time <= time + 1e-9) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Forgets what was before `time`, but for the map and the plans that were made of it. */
  forget(time: number): void {
    this.frames.splice(0, this.frameIndex(time));
    this.plans = this.plans.map((list) => list.slice(Math.max(list.findIndex((p) => p.time >= time) - 1, 0)));
    this.grids = this.grids.map((list) => list
      .filter((_, i) => (list[i + 1]?.time ?? Infinity) > time) // not those that others replaced
      .map((grid) => folded(grid, time)));
  }

  get lidar(): boolean {
    return this.begin.sensing === 'lidar';
  }

  setting(group: string, name: string): number {
    const found = this.settings.find((s) => s.group === group && s.name === name);
    return typeof found?.value === 'number' ? found.value : NaN;
  }

  get radius(): number {
    return this.setting('robot', 'radius');
  }

  get body(): Footprint {
    const [length, width] = [this.setting('robot', 'length'), this.setting('robot', 'width')];
    const written = this.settings.find((s) => s.group === 'robot' && s.name === 'discs')?.value;
    const discs = typeof written === 'string' ? JSON.parse(written) as [number, number, number][] : [];
    // One side alone is none: see footprint_of in C++.
    const rectangle = discs.length === 0 && length > 0 && width > 0;
    return {
      radius: this.radius, length: rectangle ? length : 0, width: rectangle ? width : 0,
      discs: discs.map(([x, y, radius]) => ({ x, y, radius })),
    };
  }
}

/** The outline of a robot: discs, else a rectangle about its centre, else, without sides, a disc. */
export interface Footprint {
  radius: number; // of the disc that covers it
  length: number; // along the heading
  width: number;
  discs: (Point & { radius: number })[]; // in the robot's frame
}

/** The smallest disc about the centre of a robot that covers its body. */
export function coveringRadius({ radius, length, width, discs }: Footprint): number {
  if (discs.length > 0) return Math.max(...discs.map((d) => Math.hypot(d.x, d.y) + d.radius));
  return length > 0 ? Math.hypot(length, width) / 2 : radius;
}

/** How far `p` is from a robot that stands at `pose`; not above 0 inside. */
function distance({ radius, length, width, discs }: Footprint, pose: Pose, p: Point): number {
  const [dx, dy] = [p.x - pose.x, p.y - pose.y];
  if (discs.length > 0) {
    const [c, s] = [Math.cos(pose.heading), Math.sin(pose.heading)];
    return Math.min(...discs.map((d) => Math.hypot(c * dx + s * dy - d.x, c * dy - s * dx - d.y) - d.radius));
  }
  if (length === 0) return Math.hypot(dx, dy) - radius;
  const [c, s] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  const u = Math.abs(c * dx + s * dy) - length / 2;
  const v = Math.abs(c * dy - s * dx) - width / 2;
  return Math.hypot(Math.max(u, 0), Math.max(v, 0));
}

/**
 * The gap between a robot's body and the nearest other body; infinite when alone. Another robot
 * counts as the smallest disc around its body, as it does in the simulator.
 */
export function separation(frame: Frame, robot: number, body: Footprint): number {
  const me = frame.robots[robot];
  if (!me) return Infinity;
  const around = coveringRadius(body);
  let gap = Infinity;
  for (const other of frame.bodies) {
    if (other.radius <= 0) continue; // not there yet, or no more
    gap = Math.min(gap, distance(body, me, other) - other.radius);
  }
  frame.robots.forEach((other, i) => {
    if (i !== robot) gap = Math.min(gap, distance(body, me, other) - around);
  });
  return gap;
}

// The same map, with the changes before `time` in its cells.
function folded(grid: Grid, time: number): Grid {
  const old = grid.changes.filter((change) => change.time < time);
  if (old.length === 0) return grid;
  const cells = grid.cells.slice();
  for (const { runs } of old) {
    for (let i = 0; i < runs.length; i += 4) {
      const start = runs[i]! * grid.frame.width + runs[i + 1]!;
      cells.fill(runs[i + 3]!, start, start + runs[i + 2]!);
    }
  }
  return { ...grid, cells, changes: grid.changes.slice(old.length) };
}
