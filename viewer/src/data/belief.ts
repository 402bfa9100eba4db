// SPDX-License-Identifier: Apache-2.0
import { type Point, type Pose, placed, placedPose } from './geometry';
import type { GridFrame } from './grid';

/**
 * The pose of the frame in which a robot estimates its pose as `believed` and is truly at `truth`:
 * odometry errors let this frame drift away from the world's.
 */
export function beliefFrame(truth: Pose, believed: Pose): Pose {
  const heading = truth.heading - believed.heading;
  const turned = placed({ x: 0, y: 0, heading }, believed);
  return { x: truth.x - turned.x, y: truth.y - turned.y, heading };
}

/** The corners of a map whose origin differs between the robot's estimate and the world. */
export function windowCorners(frame: GridFrame, belief: Pose): Point[] {
  const origin = placedPose(belief, frame.origin);
  const side = [frame.width * frame.resolution, frame.height * frame.resolution] as const;
  return [[0, 0], [side[0], 0], [side[0], side[1]], [0, side[1]]].map(([x, y]) => placed(origin, { x: x!, y: y! }));
}
