// SPDX-License-Identifier: Apache-2.0
import type { Goal, RobotFrame } from '../data/frame';
import type { Pen } from './pen';
import { robotColor } from './theme';

/** Draws the corridor's rectangles, the current one stronger. */
export function drawCorridor(pen: Pen, { plan, cycle }: RobotFrame): void {
  if (!plan) return;
  const { theme } = pen;
  plan.rectangles.forEach((corners, i) => {
    const current = cycle !== null && i === cycle.rectangle && plan.usable;
    pen.trace(corners, true);
    pen.fill(theme.corridor, current ? 0.26 : 0.1);
    pen.stroke(current ? theme.current : theme.corridor, current ? 2 : 1, current ? 1 : 0.55);
  });
}

/** Draws the planned path, if requested, and its goal. */
export function drawWay(pen: Pen, robot: RobotFrame, index: number, selected: boolean, path: boolean): void {
  const { plan } = robot;
  if (!plan || plan.dropped || robot.absent) return;
  const { theme } = pen;
  if (path && plan.path.length > 1) {
    pen.trace(plan.path);
    pen.stroke(theme.path, selected ? 1.75 : 1, selected ? 0.95 : 0.4, [7, 5]);
  }
  if (robot.collided) return;
  drawGoal(pen, robot.goal ?? plan.goal, robotColor(index, theme), plan.usable);
}

function drawGoal(pen: Pen, goal: Goal, color: string, usable: boolean): void {
  const radius = Math.max(6 / pen.camera.scale, 0.14);
  pen.disc(goal, radius);
  pen.fill(pen.theme.halo, 0.85);
  pen.stroke(color, 2, 1, usable ? [] : [3, 3]);
  pen.disc(goal, radius / 3);
  pen.fill(color);
  if (goal.heading === null) return;
  pen.arrow(goal, goal.heading, 2.4 * radius, color);
}

/** Draws the predicted motion of a robot with this radius. */
export function drawPrediction(pen: Pen, robot: RobotFrame, index: number, radius: number): void {
  const points = robot.cycle?.prediction ?? [];
  if (points.length < 2) return;
  const { theme } = pen;
  const color = theme.prediction;
  const last = points.at(-1)!;
  pen.disc(last, radius);
  pen.stroke(robotColor(index, theme), 1, 0.5, [3, 3]);
  pen.trace(points);
  pen.stroke(theme.halo, 4, 0.6);
  pen.trace(points);
  pen.stroke(color, 2);
  for (const p of points.slice(1)) {
    pen.disc(p, 2 / pen.camera.scale);
    pen.fill(color);
  }
}

/** Draws the limiting constraint: a side of a rectangle, or a disc. */
export function drawLimit(pen: Pen, robot: RobotFrame): void {
  const mark = robot.cycle?.mark;
  if (!mark) return;
  const { theme } = pen;
  if (mark.shape === 'side') {
    pen.trace([mark.a, mark.b]);
    pen.stroke(theme.ink, 6.5, 0.85);
    pen.trace([mark.a, mark.b]);
    pen.stroke(theme.limit, 3.5);
  } else {
    pen.disc(mark.a, mark.radius);
    pen.fill(theme.limit, 0.15);
    pen.stroke(theme.ink, 4, 0.6);
    pen.stroke(theme.limit, 2.5);
  }
}
