// SPDX-License-Identifier: Apache-2.0
import type { Pose } from './geometry';

export interface GridFrame {
  width: number;
  height: number;
  resolution: number;
  origin: Pose;
}

/** A map from a time on. Cells: 0 free, 1 occupied, 2 unknown, lowest row first. */
export interface Grid {
  slot: number;
  time: number;
  frame: GridFrame;
  cells: Uint8Array;
  changes: CellChange[];
}

/** Runs of cells: y, x, count, value. */
export interface CellChange {
  time: number;
  runs: number[];
}

/** The same map, with all changes before `time` applied. */
export function folded(grid: Grid, time: number): Grid {
  const old = grid.changes.filter((change) => change.time < time);
  if (old.length === 0) return grid;
  const cells = grid.cells.slice();
  for (const { runs } of old) {
    for (let i = 0; i < runs.length; i += 4) {
      const start = runs[i]! * grid.frame.width + runs[i + 1]!;
      cells.fill(runs[i + 3]!, start, start + runs[i + 2]!);
    }
  }
  return { ...grid, cells, changes: grid.changes.slice(old.length) };
}
