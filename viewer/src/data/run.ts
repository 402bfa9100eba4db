// SPDX-License-Identifier: Apache-2.0
import type { Footprint } from './footprint';
import type { Frame, Goal, Plan, Scan } from './frame';
import { type Grid, folded } from './grid';
import type { Zone } from './zones';

export interface Setting {
  group: string;
  name: string;
  unit: string;
  meaning: string;
  kind: 'number' | 'integer' | 'switch' | 'choice' | 'discs';
  value: number | boolean | string;
  min?: number;
  max?: number;
  choices?: string[];
  /** The value of an untouched program. */
  default?: number | boolean | string;
}

/** What a status or a limiting factor means, as `fairway statuses` prints it. */
export interface Guide {
  label: string;
  meaning: string;
  causes: string;
  remedy: string;
}

export interface RobotTask {
  name: string;
  start: [number, number, number];
  goal: number[];
  idle?: boolean;
  /** The true outline in the robot's frame, of a robot with a body of its own: polygons. */
  outline?: [number, number][][];
}

/** The constant data from the beginning of a run. */
export interface Begin {
  version: number;
  name: string;
  robots: RobotTask[];
  bodies: string[];
  /** What the robots know. */
  sensing?: 'map' | 'lidar';
  physics?: 'unicycle' | 'mujoco';
  statuses: string[];
  limits: string[];
  rows: string[];
  zones?: Zone[];
  status_guides?: Guide[];
  limit_guides?: Guide[];
  settings: Setting[];
}

/** A run, as far as it has been received. */
export class Run {
  frames: Frame[] = [];
  plans: Plan[][];
  goals: (Goal | null)[];
  scans: (Scan | null)[];
  /** By slot, in order of time: 0 is the true map, the others are the robots' maps. */
  grids: Grid[][] = [[]];
  settings: Setting[];
  private zones: { time: number; zones: Zone[] }[];

  constructor(public begin: Begin) {
    this.plans = begin.robots.map(() => []);
    this.goals = begin.robots.map(() => null);
    this.scans = begin.robots.map(() => null);
    this.settings = begin.settings;
    this.zones = [{ time: -Infinity, zones: begin.zones ?? [] }];
  }

  /** Other zones hold from `time` on. */
  setZones(time: number, zones: Zone[]): void {
    this.zones.push({ time, zones });
  }

  /** The zones that hold at a time. */
  zonesAt(time: number): Zone[] {
    return this.zones.findLast((set) => set.time <= time + 1e-9)!.zones;
  }

  /** The robots of the running world, of which there are more from now on. */
  setRobots(robots: RobotTask[]): void {
    this.begin = { ...this.begin, robots };
    while (this.plans.length < robots.length) {
      this.plans.push([]);
      this.goals.push(null);
      this.scans.push(null);
    }
  }

  get duration(): number {
    return this.frames.at(-1)?.time ?? 0;
  }

  /** Index of the last frame at or before `time`; 0 before the first. */
  frameIndex(time: number): number {
    let low = 0;
    let high = this.frames.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.frames[middle]!.time <= time + 1e-9) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Removes everything before `time`, except the map and the plans that still apply then. */
  forget(time: number): void {
    this.frames.splice(0, this.frameIndex(time));
    this.plans = this.plans.map((list) => list.slice(Math.max(list.findIndex((p) => p.time >= time) - 1, 0)));
    this.grids = this.grids.map((list) => list
      .filter((_, i) => (list[i + 1]?.time ?? Infinity) > time) // not those that later ones
                                                                // replaced
      .map((grid) => folded(grid, time)));
  }

  get lidar(): boolean {
    return this.begin.sensing === 'lidar';
  }

  setting(group: string, name: string): number {
    const found = this.settings.find((s) => s.group === group && s.name === name);
    return typeof found?.value === 'number' ? found.value : NaN;
  }

  get radius(): number {
    return this.setting('robot', 'radius');
  }

  get body(): Footprint {
    const [length, width] = [this.setting('robot', 'length'), this.setting('robot', 'width')];
    const written = this.settings.find((s) => s.group === 'robot' && s.name === 'discs')?.value;
    const discs = typeof written === 'string' ? JSON.parse(written) as [number, number, number][] : [];
    // A single side gives no rectangle: see footprint_of in C++.
    const rectangle = discs.length === 0 && length > 0 && width > 0;
    return {
      radius: this.radius, length: rectangle ? length : 0, width: rectangle ? width : 0,
      discs: discs.map(([x, y, radius]) => ({ x, y, radius })),
    };
  }
}
