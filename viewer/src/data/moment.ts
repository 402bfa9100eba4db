// SPDX-License-Identifier: Apache-2.0
import type { Body, Frame } from './frame';
import type { Point, Pose } from './geometry';
import type { Grid } from './grid';
import type { Run } from './run';

/**
 * The displayed state at one instant: the frame at or before it, interpolated towards the next one.
 */
export interface Moment {
  time: number;
  index: number;
  frame: Frame;
  poses: Pose[];
  bodies: Body[];
}

const turn = (from: number, to: number): number => {
  const difference = (to - from) % (2 * Math.PI);
  if (difference > Math.PI) return difference - 2 * Math.PI;
  return difference < -Math.PI ? difference + 2 * Math.PI : difference;
};

export function momentAt(run: Run, time: number): Moment | null {
  const index = run.frameIndex(time);
  const frame = run.frames[index];
  if (!frame) return null;
  const next = run.frames[index + 1];
  const span = next ? next.time - frame.time : 0;
  const share = next && span > 0 ? Math.min(Math.max((time - frame.time) / span, 0), 1) : 0;
  const poses = frame.robots.map((robot, i) => {
    const to = next?.robots[i];
    if (!to) return robot;
    return {
      x: robot.x + share * (to.x - robot.x),
      y: robot.y + share * (to.y - robot.y),
      heading: robot.heading + share * turn(robot.heading, to.heading),
    };
  });
  const bodies = frame.bodies.map((body, i) => {
    const to = next?.bodies[i];
    return to ? { ...body, x: body.x + share * (to.x - body.x), y: body.y + share * (to.y - body.y) } : body;
  });
  return { time, index, frame, poses, bodies };
}

/** The newest map of a slot at `time`. */
export function gridAt(run: Run, slot: number, time: number): Grid | null {
  const grids = run.grids[slot] ?? [];
  let found = grids[0] ?? null;
  for (const grid of grids) {
    if (grid.time > time + 1e-9) break;
    found = grid;
  }
  return found;
}

/** The robot nearest to `p`, if its body is within `reach`. */
export function robotAt(moment: Moment, p: Point, radius: number, reach: number): number | null {
  let best: number | null = null;
  let least = radius + reach;
  moment.poses.forEach((pose, i) => {
    if (moment.frame.robots[i]?.absent) return;
    const distance = Math.hypot(pose.x - p.x, pose.y - p.y);
    if (distance < least) [least, best] = [distance, i];
  });
  return best;
}

