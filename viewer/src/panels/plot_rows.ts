// SPDX-License-Identifier: Apache-2.0
import { separation } from '../data/footprint';
import type { Run } from '../data/run';
import { type Theme, robotColor } from '../drawing/theme';

/** Largest measured clearance [m]; above it only "more than" is known. */
export const FAR = 2;

/** A curve over the frames of a run; null where there is no value. */
export interface Curve {
  name: string;
  color: string;
  width: number;
  value: (frame: number) => number | null;
}

/** A plot: curves, and dashed levels. */
export interface PlotRow {
  title: string;
  unit: string;
  digits: number;
  min: number;
  max: number;
  curves: Curve[];
  levels: { name: string; value: number; color: string }[];
}

export const plotNames = { speed: 'Speed', clearance: 'Clearance', turn: 'Angular velocity', cycle: 'Cycle time' } as const;
export type PlotName = keyof typeof plotNames;

/** The plots of one robot. */
export function plotRows(run: Run, robot: number, theme: Theme, names: PlotName[]): PlotRow[] {
  const color = robotColor(robot, theme);
  const cycle = (i: number) => run.frames[i]!.robots[robot]?.cycle ?? null;
  const most = run.setting('robot', 'linear_max') || 1;
  const least = Math.min(0, run.setting('robot', 'linear_min') || 0);
  const turn = run.setting('robot', 'angular_max') || 1;
  const margin = run.setting('prediction', 'obstacle_margin');
  const { body } = run;
  const rows: Record<PlotName, () => PlotRow> = {
    speed: () => ({
      title: plotNames.speed, unit: 'm/s', digits: 2, min: least * 1.1, max: most * 1.15,
      curves: [
        { name: 'command', color: theme.faint, width: 1, value: (i) => cycle(i)?.commandLinear ?? null },
        { name: 'actual', color, width: 1.75, value: (i) => cycle(i)?.linear ?? null }],
      levels: [{ name: 'limit', value: most, color: theme.ink }],
    }),
    clearance: () => ({
      title: plotNames.clearance, unit: 'm', digits: 2, min: 0, max: FAR,
      curves: [
        { name: 'to obstacles', color, width: 1.75, value: (i) => cycle(i)?.clearance ?? null },
        { name: 'to people and robots', color: theme.body, width: 1.5, value: (i) => {
          const gap = separation(run.frames[i]!, robot, body);
          return gap <= FAR ? gap : null;
        } }],
      levels: [{ name: 'margin', value: margin, color: theme.body }],
    }),
    turn: () => ({
      title: plotNames.turn, unit: 'rad/s', digits: 2, min: -turn * 1.1, max: turn * 1.1,
      curves: [
        { name: 'command', color: theme.faint, width: 1, value: (i) => cycle(i)?.commandAngular ?? null },
        { name: 'actual', color, width: 1.75, value: (i) => cycle(i)?.angular ?? null }],
      levels: [],
    }),
    cycle: () => {
      let top = 1;
      for (let i = 0; i < run.frames.length; ++i) top = Math.max(top, (cycle(i)?.micros ?? 0) / 1e3);
      return {
        title: plotNames.cycle, unit: 'ms', digits: 2, min: 0, max: top * 1.1,
        curves: [{ name: 'actual', color, width: 1.5, value: (i) => {
          const micros = cycle(i)?.micros ?? 0;
          return micros > 0 ? micros / 1e3 : null;
        } }],
        levels: [],
      };
    },
  };
  return names.map((name) => rows[name]());
}

/** The value of a curve as text. */
export function valueText(row: PlotRow, value: number | null): string {
  if (value === null) return '–';
  const capped = row.title === plotNames.clearance && value >= FAR - 1e-6;
  return `${capped ? '> ' : ''}${value.toFixed(row.digits)} ${row.unit}`;
}
