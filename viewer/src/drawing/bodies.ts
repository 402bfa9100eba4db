// SPDX-License-Identifier: Apache-2.0
import type { Body, RobotFrame } from '../data/frame';
import type { Point, Pose } from '../data/geometry';
import type { Run } from '../data/run';
import type { Pen } from './pen';
import { robotColor } from './theme';

/** Least radius of a distant robot [pixels]. */
export const LEAST_ROBOT = 5;

function corners(pose: Pose, length: number, width: number): Point[] {
  const [c, s] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  return [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([u, v]) => ({
    x: pose.x + (c * u! * length - s * v! * width) / 2,
    y: pose.y + (s * u! * length + c * v! * width) / 2,
  }));
}

/** Draws a moving body, with its velocity if requested. */
export function drawBody(pen: Pen, body: Body, velocity: boolean): void {
  const { theme } = pen;
  const color = theme.body;
  pen.disc(body, body.radius);
  pen.fill(color, 0.85);
  pen.stroke(theme.halo, 1.25, 0.9);
  const speed = Math.hypot(body.vx, body.vy);
  if (!velocity || speed < 0.05) return;
  // The position in one second.
  pen.trace([body, { x: body.x + body.vx, y: body.y + body.vy }]);
  pen.stroke(color, 2, 0.9);
  pen.disc({ x: body.x + body.vx, y: body.y + body.vy }, body.radius);
  pen.stroke(color, 1.25, 0.6, [3, 3]);
}

const RESTING = 0.1; // a tracked object that is slower is shown small [m/s]

/** Draws a tracked object where a robot estimates it; the size of one at rest means little. */
export function drawBelieved(pen: Pen, body: Body): void {
  const resting = Math.hypot(body.vx, body.vy) < RESTING;
  pen.disc(body, resting ? Math.min(body.radius, 4 / pen.camera.scale) : body.radius);
  pen.stroke(pen.theme.tracked, 2, 0.9, [2, 3]);
}

/** Draws a robot with its outline and an arrow for its heading. */
export function drawRobot(pen: Pen, pose: Pose, robot: RobotFrame, index: number, run: Run, selected: boolean): void {
  const { theme } = pen;
  // On a large map it is enlarged so that it is visible.
  const radius = Math.max(run.radius, LEAST_ROBOT / pen.camera.scale);
  const color = robotColor(index, theme);
  if (robot.absent) return;
  const fill = robot.collided ? theme.fault : color;
  const { length, width, discs } = run.body;
  const outline = radius === run.radius ? run.begin.robots[index]?.outline : undefined;
  if (outline) {
    pen.polygons(pose, outline);
  } else if (discs.length > 0 && radius === run.radius) {
    pen.disc(pose, radius);
    pen.stroke(fill, 1, 0.6);
    pen.discs(pose, discs);
  } else if (length > 0 && radius === run.radius) {
    // The disc that corridors keep free, and the true body in it.
    pen.disc(pose, radius);
    pen.stroke(fill, 1, 0.6);
    pen.trace(corners(pose, length, width), true);
  } else {
    pen.disc(pose, radius);
  }
  pen.fill(fill);
  pen.stroke(theme.halo, 1.5);
  const ahead = (distance: number, turn: number): Point => ({
    x: pose.x + distance * Math.cos(pose.heading + turn),
    y: pose.y + distance * Math.sin(pose.heading + turn),
  });
  const size = outline ? Math.min(...outline.flat().map(([, y]) => Math.abs(y)).filter((y) => y > 0.01), radius)
    : discs.length > 0 ? Math.min(...discs.map((d) => d.radius))
    : length > 0 ? Math.min(length, width) / 2 : radius;
  const arrow = Math.max(size, LEAST_ROBOT / pen.camera.scale);
  pen.trace([ahead(0.82 * arrow, 0), ahead(0.66 * arrow, 2.4), ahead(0.25 * arrow, Math.PI),
    ahead(0.66 * arrow, -2.4)], true);
  pen.fill(theme.halo, 0.95);
  if (selected && run.begin.robots.length > 1) {
    pen.disc(pose, radius + 4 / pen.camera.scale);
    pen.stroke(color, 1.5, 0.9);
  }
}
