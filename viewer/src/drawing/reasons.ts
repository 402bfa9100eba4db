// SPDX-License-Identifier: Apache-2.0
import { awaited, explanationOf, stopLength } from '../data/explanation';
import type { Obstruction, RobotFrame } from '../data/frame';
import type { Point } from '../data/geometry';
import type { Moment } from '../data/moment';
import type { Run } from '../data/run';
import { limitWords } from '../data/words';
import { drawNote } from './lettering';
import type { Pen } from './pen';

const SLOW = 0.05; // a robot that is slower is at standstill [m/s]

/** Draws why a robot cannot drive: the gap, the obstacle that is awaited, the stop, the contact. */
export function drawReasons(pen: Pen, run: Run, moment: Moment, selected: number): void {
  moment.frame.robots.forEach((robot, i) => {
    const pose = moment.poses[i];
    if (!pose || robot.absent) return;
    if (robot.collided) drawContact(pen, run, moment, i, i === selected);
    else if (i === selected) drawStandstill(pen, run, moment, i, robot);
  });
}

function cross(pen: Pen, at: Point, color: string): void {
  const r = 7 / pen.camera.scale;
  for (const [dx, dy] of [[1, 1], [1, -1]] as const) {
    pen.trace([{ x: at.x - dx * r, y: at.y - dy * r }, { x: at.x + dx * r, y: at.y + dy * r }]);
    pen.stroke(pen.theme.halo, 6, 0.8);
    pen.stroke(color, 3);
  }
}

function drawContact(pen: Pen, run: Run, moment: Moment, index: number, noted: boolean): void {
  cross(pen, moment.poses[index]!, pen.theme.halo);
  if (!noted) return;
  const { reason, detail } = explanationOf(run, moment.frame, index);
  drawNote(pen, `${reason}\n${detail}`, moment.poses[index]!, 'fault');
}

function drawStandstill(pen: Pen, run: Run, moment: Moment, index: number, robot: RobotFrame): void {
  const { plan, cycle } = robot;
  if (plan && !plan.usable && !plan.dropped) {
    if (plan.obstruction) drawObstruction(pen, plan.obstruction);
    return;
  }
  if (!cycle || Math.abs(cycle.linear) > SLOW && run.begin.limits[cycle.limit] !== 'stop not proven') return;
  const pose = moment.poses[index]!;
  const waits = awaited(run, moment.frame, index);
  if (waits) {
    pen.trace([pose, waits]);
    pen.stroke(pen.theme.halo, 4, 0.7);
    pen.stroke(pen.theme.ink, 1.75, 1, [3, 4]);
    pen.disc(waits, waits.radius + 3 / pen.camera.scale);
    pen.stroke(pen.theme.ink, 2, 1, [3, 4]);
    drawNote(pen, `waits for ${waits.name}, ${waits.distance.toFixed(2)} m away`, waits);
  } else if (run.begin.limits[cycle.limit] === 'stop not proven') {
    const length = stopLength(run, robot) * Math.sign(cycle.linear || 1);
    const end = { x: pose.x + length * Math.cos(pose.heading), y: pose.y + length * Math.sin(pose.heading) };
    pen.trace([pose, end]);
    pen.stroke(pen.theme.fault, 3, 0.9, [6, 4]);
    pen.disc(end, run.radius);
    pen.stroke(pen.theme.fault, 2, 0.9, [6, 4]);
    drawNote(pen, `${limitWords(run, cycle.limit)}\nnearest obstacle ${cycle.clearance.toFixed(2)} m`, end);
  }
}

/** The gap as it is (solid) and as the robot needs it (dashed), with both widths. */
function drawObstruction(pen: Pen, found: Obstruction): void {
  const { theme } = pen;
  if (found.kind === 'closed') {
    cross(pen, found, theme.fault);
    return drawNote(pen, 'every route is closed;\nthe best one is closed here', found);
  }
  const gap = found.kind === 'gap';
  const share = gap ? 0.5 : 1; // a gap has a width, an end has a distance
  pen.disc(found, found.needed * share);
  pen.stroke(theme.halo, 4, 0.8);
  pen.stroke(theme.fault, 2, 1, [5, 4]);
  if (found.found > 0) {
    pen.disc(found, found.found * share);
    pen.fill(theme.fault, 0.18);
    pen.stroke(theme.fault, 2);
  }
  const [is, needs] = [found.found.toFixed(2), found.needed.toFixed(2)];
  drawNote(pen, gap ? `gap ${is} m wide, ${needs} m needed` : `${is} m to the nearest obstacle,\n${needs} m needed`, found);
}
