// SPDX-License-Identifier: Apache-2.0
import type { Body, Frame, RobotFrame } from './frame';
import type { Point } from './geometry';
import type { Run } from './run';
import { capitalised, contactName, hasGoal, limitWords, statusWords } from './words';

/** Why a robot is as slow as it is. */
export interface Explanation {
  /** Before the reason, such as "Limited by"; empty for a whole sentence. */
  lead: string;
  reason: string;
  detail: string;
  fault: boolean;
}

const metres = (value: number): string => `${(Math.round(value * 100) / 100).toFixed(2)} m`;
const speed = (value: number): string => `${Math.abs(value).toFixed(2)} m/s`;
const place = (p: Point): string => `(${p.x.toFixed(2)}, ${p.y.toFixed(2)})`;
const plain = (reason: string, detail = '', fault = false): Explanation => ({ lead: '', reason, detail, fault });

const SLOW = 0.05; // a robot that is slower is at standstill [m/s]

/** What a robot waits for: a body or another robot, and where it is. */
export interface Awaited extends Point {
  name: string;
  radius: number;
  distance: number;
}

/** The moving obstacle that limits a robot: the one nearest to the disc of its constraint. */
export function awaited(run: Run, frame: Frame, index: number): Awaited | null {
  const robot = frame.robots[index];
  const cycle = robot?.cycle;
  if (!robot || !cycle || run.begin.limits[cycle.limit] !== 'moving obstacle') return null;
  const near = cycle.mark?.shape === 'disc' ? cycle.mark.a : robot;
  let best: Awaited | null = null;
  let least = Infinity;
  const consider = (name: string, at: Point, radius: number): void => {
    const from = Math.hypot(at.x - near.x, at.y - near.y);
    if (from >= least) return;
    least = from;
    best = { name, x: at.x, y: at.y, radius, distance: Math.hypot(at.x - robot.x, at.y - robot.y) };
  };
  frame.bodies.forEach((body: Body, i) => {
    if (body.radius > 0) consider(run.begin.bodies[i] ?? `person ${i + 1}`, body, body.radius);
  });
  frame.robots.forEach((other, i) => {
    if (i !== index && !other.absent) consider(run.begin.robots[i]?.name ?? 'a robot', other, run.radius);
  });
  return best;
}

/** The distance in which a robot stops from its present speed [m]. */
export function stopLength(run: Run, robot: RobotFrame): number {
  const braking = run.setting('robot', 'linear_braking_max') || run.setting('robot', 'linear_acceleration_max') || 1;
  const v = Math.abs(robot.cycle?.linear ?? 0);
  const reaction = (run.setting('robot', 'linear_delay') || 0) + (run.setting('navigation', 'control_period') || 0.1);
  return v * reaction + v * v / (2 * braking);
}

function collision(run: Run, robot: RobotFrame): Explanation {
  const { contact } = robot;
  const name = contactName(run, robot);
  const text = `Collided with ${name}, removed from the run`;
  if (!contact || contact.with === 'nothing') return plain(text, `near ${place(robot)}`, true);
  const own = contact.approach > SLOW ? `the robot drove at ${speed(contact.approach)}` : 'the robot did not drive towards it';
  const other = contact.with === 'obstacle' ? ''
    : contact.otherApproach > SLOW ? `; ${name} moved into it at ${speed(contact.otherApproach)}` : `; ${name} did not move towards it`;
  return plain(text, `At ${contact.time.toFixed(1)} s near ${place(robot)}: ${own}${other}.`, true);
}

function noPath(robot: RobotFrame): Explanation {
  const { obstruction, reason } = robot.plan!;
  if (obstruction?.kind === 'gap') {
    return plain(`No path: every route is narrower than ${metres(obstruction.needed)}`,
      `The widest route has a gap of ${metres(obstruction.found)} at ${place(obstruction)}.`);
  }
  if (obstruction?.kind === 'closed') return plain('No path: obstacles or unknown cells close every route', `The best route is closed at ${place(obstruction)}.`);
  if (obstruction) {
    return plain(`No path: the robot does not fit at the ${obstruction.kind}`,
      `An obstacle is ${metres(obstruction.found)} away; the robot needs ${metres(obstruction.needed)}.`);
  }
  return plain(`No path: ${reason}`);
}

/** The explanation of robot `index` in a frame. */
export function explanationOf(run: Run, frame: Frame, index: number): Explanation {
  const robot = frame.robots[index];
  if (!robot) return plain('Removed');
  const { cycle, plan } = robot;
  if (robot.collided) return collision(run, robot);
  if (!hasGoal(run, robot, index)) return plain('No goal');
  if (plan && !plan.usable) return noPath(robot);
  if (!cycle) return plain('Stopped');
  const name = run.begin.limits[cycle.limit];
  if (name === 'none') return plain(limitWords(run, cycle.limit));
  // While a plan is made, the lack of a path is not a limit.
  if (run.begin.statuses[cycle.status] === 'planning') return plain(statusWords(run, cycle.status).label);
  const most = run.setting('robot', 'linear_max') || 1;
  const fast = Math.abs(cycle.linear) > 0.97 * most;
  if (name === 'speed limit' && fast) return plain(limitWords(run, run.begin.limits.indexOf('none')), `At its speed limit of ${speed(most)}.`);
  const waits = awaited(run, frame, index);
  if (waits && Math.abs(cycle.linear) < SLOW) {
    return { lead: 'Waiting for', reason: waits.name, detail: `${metres(waits.distance)} away (between centres).`, fault: false };
  }
  if (waits) return { lead: 'Limited by', reason: waits.name, detail: `${metres(waits.distance)} away (between centres).`, fault: false };
  if (name === 'stop not proven') {
    return plain(limitWords(run, cycle.limit),
      `Stopping from ${speed(cycle.linear)} takes ${metres(stopLength(run, robot))}; ${metres(cycle.clearance)} to the nearest obstacle.`);
  }
  // The constraint is more specific than the limiting factor: which speed, which acceleration.
  const row = run.begin.rows[cycle.row];
  const reason = cycle.row > 0 && row && cycle.limit < 5 ? capitalised(row) : limitWords(run, cycle.limit);
  return { lead: fast ? 'Active constraint' : 'Limited by', reason, detail: '', fault: false };
}
