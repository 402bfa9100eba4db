// SPDX-License-Identifier: Apache-2.0

/** Lengths in metres, angles in radians, times in seconds, as everywhere in Fairway. */
export interface Point {
  x: number;
  y: number;
}

export interface Pose extends Point {
  heading: number;
}

/** Transforms a point from `frame` to the world. */
export function placed(frame: Pose, p: Point): Point {
  const [c, s] = [Math.cos(frame.heading), Math.sin(frame.heading)];
  return { x: frame.x + c * p.x - s * p.y, y: frame.y + s * p.x + c * p.y };
}

/** Transforms a pose from `frame` to the world. */
export function placedPose(frame: Pose, pose: Pose): Pose {
  return { ...placed(frame, pose), heading: frame.heading + pose.heading };
}
