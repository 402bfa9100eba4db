// SPDX-License-Identifier: Apache-2.0
import { beliefFrame } from './belief';
import { Fields } from './bytes';
import type { Body, Contact, Cycle, Goal, Mark, Obstruction, Plan, RobotFrame, Scan } from './frame';
import type { Point } from './geometry';
import type { GridFrame } from './grid';
import { type Begin, type RobotTask, Run, type Setting } from './run';
import type { Zone } from './zones';

// The kinds of records, numbered as in C++'s RunStream.
const enum Kind { Begin = 1, Cells = 2, Plan = 3, Cycle = 4, World = 5, Tuning = 6, Scan = 7, Goal = 8, Robots = 9, Zones = 10 }

const point = (fields: Fields): Point => ({ x: fields.millis(), y: fields.millis() });

function steps(fields: Fields, count: number, from: Point = { x: 0, y: 0 }): Point[] {
  const points: Point[] = [];
  let x = Math.round(from.x * 1e3);
  let y = Math.round(from.y * 1e3);
  for (let i = 0; i < count; ++i) {
    x += fields.integer();
    y += fields.integer();
    points.push({ x: x / 1e3, y: y / 1e3 });
  }
  return points;
}

function bodies(fields: Fields): Body[] {
  const list: Body[] = [];
  for (let n = fields.count(); n > 0; --n) {
    const { x, y } = point(fields);
    const { x: vx, y: vy } = point(fields);
    list.push({ x, y, vx, vy, radius: fields.millis() });
  }
  return list;
}

function gridFrame(fields: Fields): GridFrame {
  const width = fields.count();
  const height = fields.count();
  const resolution = fields.real();
  return { width, height, resolution, origin: { x: fields.real(), y: fields.real(), heading: fields.real() } };
}

function cells(fields: Fields, frame: GridFrame): Uint8Array {
  const grid = new Uint8Array(frame.width * frame.height);
  for (let at = 0; at < grid.length;) {
    const value = fields.count();
    const count = fields.count();
    grid.fill(value, at, at + count);
    at += count;
  }
  return grid;
}

function goalOf(fields: Fields): { flags: number; goal: Goal } {
  const flags = fields.count();
  return { flags, goal: { ...point(fields), heading: flags & 2 ? fields.angle() : null } };
}

// The ends of beams with a hit; other beams are 0.
function scanOf(fields: Fields): Scan {
  const time = fields.millis();
  const from = point(fields);
  const first = fields.angle();
  const step = fields.real();
  const beams = fields.count();
  const points = new Float32Array(2 * beams);
  let used = 0;
  for (let i = 0, range = 0; i < beams; ++i) {
    range += fields.integer();
    if (range === 0) continue;
    const angle = first + i * step;
    points[used++] = from.x + range / 100 * Math.cos(angle);
    points[used++] = from.y + range / 100 * Math.sin(angle);
  }
  return { time, points: points.slice(0, used) };
}

function plan(fields: Fields): Plan {
  const robot = fields.count();
  const time = fields.millis();
  const { flags, goal } = goalOf(fields);
  const path = steps(fields, fields.count());
  const rectangles: Point[][] = [];
  let seed: Point = { x: 0, y: 0 };
  for (let n = fields.count(); n > 0; --n) {
    seed = steps(fields, 1, seed)[0]!;
    const turn = fields.angle();
    const min = point(fields);
    const max = point(fields);
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const { x: sx, y: sy } = seed;
    rectangles.push([[min.x, min.y], [max.x, min.y], [max.x, max.y], [min.x, max.y]].map(
      ([x, y]) => ({ x: sx + c * x! - s * y!, y: sy + s * x! + c * y! })));
  }
  const reason = fields.text();
  return {
    robot, time, usable: (flags & 1) !== 0, dropped: (flags & 4) !== 0, goal, reason, path, rectangles,
    obstruction: obstruction(fields),
  };
}

function obstruction(fields: Fields): Obstruction | null {
  const kind = (['start', 'goal', 'gap', 'closed'] as const)[fields.count() - 1];
  if (!kind) return null;
  return { kind, ...point(fields), found: fields.millis(), needed: fields.millis() };
}

function contact(fields: Fields): Contact {
  return {
    with: (['nothing', 'obstacle', 'body', 'robot'] as const)[fields.count()] ?? 'nothing',
    other: fields.count(), time: fields.millis(), approach: fields.millis(), otherApproach: fields.millis(),
  };
}

function mark(fields: Fields): Mark | null {
  const shape = fields.count();
  if (shape === 1) return { shape: 'side', a: point(fields), b: point(fields) };
  if (shape === 2) return { shape: 'disc', a: point(fields), radius: fields.millis() };
  return null;
}

/** Builds a run from records, which may arrive in pieces of any size. */
export class StreamReader {
  run: Run | null = null;
  private rest = new Uint8Array(0);

  /** @param onBegin called when a new run begins; the previous run is unchanged. */
  constructor(private readonly onBegin: (run: Run) => void = () => {}) {}

  /** Drops an incomplete record: the next piece begins a run. */
  restart(): void {
    this.rest = new Uint8Array(0);
  }

  push(piece: Uint8Array): void {
    let bytes = piece;
    if (this.rest.length > 0) {
      bytes = new Uint8Array(this.rest.length + piece.length);
      bytes.set(this.rest);
      bytes.set(piece, this.rest.length);
    }
    let start = 0;
    for (;;) {
      const head = new Fields(bytes, start);
      let kind: number;
      let content: Uint8Array;
      try {
        kind = head.byte();
        content = head.take(head.count());
      } catch {
        break; // the rest has not arrived
      }
      start = head.position;
      this.record(kind, content);
    }
    this.rest = bytes.slice(start);
  }

  private record(kind: number, content: Uint8Array): void {
    const fields = new Fields(content);
    if (kind === Kind.Begin) {
      this.run = new Run(JSON.parse(new TextDecoder().decode(content)) as Begin);
      this.onBegin(this.run);
      return;
    }
    const run = this.run;
    if (!run) return;
    if (kind === Kind.Cells) this.cells(run, fields);
    else if (kind === Kind.Plan) this.plan(run, fields);
    else if (kind === Kind.Cycle) this.cycle(run, fields);
    else if (kind === Kind.World) this.world(run, fields);
    else if (kind === Kind.Scan) this.scan(run, fields);
    else if (kind === Kind.Goal) this.goal(run, fields);
    else if (kind === Kind.Tuning) {
      const { settings } = JSON.parse(new TextDecoder().decode(content)) as { settings: Setting[] };
      run.settings = settings;
      // Robots with a lidar have new navigators, which receive their goals again.
      if (run.lidar) run.goals = run.goals.map(() => null);
    } else if (kind === Kind.Robots) {
      run.setRobots((JSON.parse(new TextDecoder().decode(content)) as { robots: RobotTask[] }).robots);
    } else if (kind === Kind.Zones) {
      const { time, zones } = JSON.parse(new TextDecoder().decode(content)) as { time: number; zones: Zone[] };
      run.setZones(time, zones);
    }
  }

  private cells(run: Run, fields: Fields): void {
    const slot = fields.count();
    const whole = fields.count() !== 0;
    const time = fields.millis();
    const grids = (run.grids[slot] ??= []);
    if (whole) {
      const frame = gridFrame(fields);
      grids.push({ slot, time, frame, cells: cells(fields, frame), changes: [] });
      return;
    }
    const runs: number[] = [];
    for (let n = 4 * fields.count(); n > 0; --n) runs.push(fields.count());
    grids.at(-1)?.changes.push({ time, runs });
  }

  private plan(run: Run, fields: Fields): void {
    const made = plan(fields);
    run.plans[made.robot]?.push(made);
    // A robot without a map plans in its cycle, the others after it.
    const robot = run.frames.at(-1)?.robots[made.robot];
    if (run.lidar && robot) robot.plan = made;
  }

  private scan(run: Run, fields: Fields): void {
    const index = fields.count();
    const scan = scanOf(fields);
    run.scans[index] = scan;
    const robot = run.frames.at(-1)?.robots[index];
    if (robot) robot.scan = scan;
  }

  private goal(run: Run, fields: Fields): void {
    const index = fields.count();
    fields.millis(); // time
    run.goals[index] = goalOf(fields).goal;
  }

  private world(run: Run, fields: Fields): void {
    const time = fields.millis();
    const list = bodies(fields);
    const last = run.frames.at(-1);
    const before = last?.robots;
    const robots: RobotFrame[] = [];
    for (let n = fields.count(), i = 0; i < n; ++i) {
      const { x, y } = point(fields);
      const heading = fields.angle();
      const flags = fields.count();
      const collided = (flags & 1) !== 0;
      const plan = run.plans[i]?.at(-1) ?? null;
      robots.push({
        x, y, heading, collided, absent: (flags & 2) !== 0, contact: collided ? contact(fields) : null, plan, cycle: null, status: before?.[i]?.status ?? null,
        belief: before?.[i]?.belief ?? null, scan: run.scans[i] ?? null, goal: run.goals[i] ?? null,
        slots: before?.[i]?.slots ?? { known: 0, occupied: 0 },
      });
    }
    // A world that is paused between two cycles: the last ones still hold.
    if (fields.count() !== 0) robots.forEach((robot, i) => { robot.cycle = before?.[i]?.cycle ?? null; });
    if (last?.time === time) run.frames.pop();
    run.frames.push({ time, bodies: list, robots });
  }

  private cycle(run: Run, fields: Fields): void {
    const robot = run.frames.at(-1)?.robots[fields.count()];
    if (!robot) return;
    const slot = fields.count();
    const at = point(fields);
    const heading = fields.angle();
    // The measured pose; the page displays the true one.
    if (run.lidar) robot.belief = beliefFrame(robot, { ...at, heading });
    const cycle: Cycle = {
      linear: fields.millis(),
      angular: fields.millis(),
      commandLinear: fields.millis(),
      commandAngular: fields.millis(),
      status: fields.count(),
      limit: fields.count(),
      rectangle: fields.count(),
      clearance: fields.millis(),
      micros: fields.integer(),
      row: fields.count(),
      mark: mark(fields),
      iterations: 0,
      violation: 0,
      prediction: [],
      believed: [],
    };
    const horizon = fields.count();
    if (horizon > 0) {
      cycle.iterations = fields.count();
      cycle.violation = fields.millis();
      cycle.prediction = [at, ...steps(fields, horizon, at)];
    }
    cycle.believed = bodies(fields);
    robot.slots = { known: slot, occupied: fields.count() };
    robot.cycle = cycle;
    robot.status = cycle.status;
  }
}
