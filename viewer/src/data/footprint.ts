// SPDX-License-Identifier: Apache-2.0
import type { Frame } from './frame';
import type { Point, Pose } from './geometry';

/**
 * The outline of a robot: discs, or a rectangle around its centre, or a disc if it has no sides.
 */
export interface Footprint {
  radius: number; // circumscribed radius
  length: number; // along the heading
  width: number;
  discs: (Point & { radius: number })[]; // in the robot's frame
}

/** The smallest disc around a robot's centre that covers its body. */
export function coveringRadius({ radius, length, width, discs }: Footprint): number {
  if (discs.length > 0) return Math.max(...discs.map((d) => Math.hypot(d.x, d.y) + d.radius));
  return length > 0 ? Math.hypot(length, width) / 2 : radius;
}

/** The distance of `p` from a robot at `pose`; not above 0 inside. */
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
 * The distance between a robot's body and the nearest other body; infinite when alone. As in the
 * simulator, another robot counts as the smallest disc around its body.
 */
export function separation(frame: Frame, robot: number, body: Footprint): number {
  const me = frame.robots[robot];
  if (!me) return Infinity;
  const around = coveringRadius(body);
  let gap = Infinity;
  for (const other of frame.bodies) {
    if (other.radius <= 0) continue; // not present at this time
    gap = Math.min(gap, distance(body, me, other) - other.radius);
  }
  frame.robots.forEach((other, i) => {
    if (i !== robot && !other.absent) gap = Math.min(gap, distance(body, me, other) - around);
  });
  return gap;
}
