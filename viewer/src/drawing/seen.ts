// SPDX-License-Identifier: Apache-2.0
import { windowCorners } from '../data/belief';
import type { RobotFrame } from '../data/frame';
import { placedPose } from '../data/geometry';
import { type Moment, gridAt } from '../data/moment';
import type { Run } from '../data/run';
import { MapLayer } from './map_layer';
import type { Pen } from './pen';

/** Draws a robot's map: the known one, or the cells that its lidar has seen. */
export class SeenMap {
  private readonly seen = new MapLayer((theme) => [`${theme.believed}00`, `${theme.believed}cc`, `${theme.ink}18`]);
  private readonly fog = new MapLayer((theme) => ['#00000000', theme.fog, theme.fog]);

  draw({ context, camera, theme }: Pen, run: Run, { time }: Moment, robot: RobotFrame | null): void {
    if (!robot || robot.slots.known === 0) return;
    const known = gridAt(run, robot.slots.known, time);
    if (!known) return;
    if (robot.slots.occupied === 0 || !robot.belief) return this.seen.draw(context, camera, known, time, theme);
    const occupied = gridAt(run, robot.slots.occupied, time);
    // Cells outside the window are unknown or forgotten.
    context.beginPath();
    context.rect(0, 0, camera.width, camera.height);
    windowCorners(known.frame, robot.belief).forEach((p, i) => {
      const at = camera.toScreen(p);
      if (i === 0) context.moveTo(at.x, at.y);
      else context.lineTo(at.x, at.y);
    });
    context.closePath();
    context.fillStyle = theme.fog;
    context.fill('evenodd');
    const origin = placedPose(robot.belief, known.frame.origin);
    this.fog.draw(context, camera, known, time, theme, origin);
    if (occupied) this.seen.draw(context, camera, occupied, time, theme, placedPose(robot.belief, occupied.frame.origin));
  }
}

/** Draws the ends of a lidar's beams; the pen is in the robot's own frame. */
export function drawScan(pen: Pen, { scan }: RobotFrame): void {
  const { context } = pen;
  if (!scan) return;
  context.fillStyle = pen.theme.scan;
  for (let i = 0; i < scan.points.length; i += 2) {
    const at = pen.at({ x: scan.points[i]!, y: scan.points[i + 1]! });
    context.fillRect(at.x - 1.25, at.y - 1.25, 2.5, 2.5);
  }
}
