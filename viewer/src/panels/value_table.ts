// SPDX-License-Identifier: Apache-2.0
import type { Run } from '../data/run';
import { robotWords } from '../data/words';
import type { Theme } from '../drawing/theme';
import { make } from '../page/dom';
import { type PlotName, plotRows, valueText } from './plot_rows';
import { statusPieces } from './ribbon';

const MOST_TIMES = 12;
const PERIOD = 1000; // least time between two updates of a growing run [ms]

/** The time steps of the table: at most MOST_TIMES of them, at round times. */
function times(from: number, to: number): number[] {
  const step = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find((s) => (to - from) / s < MOST_TIMES) ?? (to - from) / MOST_TIMES;
  const list: number[] = [];
  for (let t = Math.ceil(from / step - 1e-9) * step; t <= to + 1e-9; t += step) list.push(t);
  return list;
}

function table(caption: string, head: string[], rows: string[][]): HTMLElement {
  return make('table', { class: 'values' }, make('caption', {}, caption),
    make('thead', {}, make('tr', {}, ...head.map((text) => make('th', { scope: 'col' }, text)))),
    make('tbody', {}, ...rows.map(([first, ...rest]) =>
      make('tr', {}, make('th', { scope: 'row' }, first ?? ''), ...rest.map((text) => make('td', {}, text))))));
}

/** The status band and the plots as tables: for screen readers, and to read numbers. */
export class ValueTable {
  private key = '';
  private next = 0; // when a growing run is shown again [ms]

  constructor(private readonly root: HTMLElement) {}

  /** Shows the span of the plots, while the page with the table is open. */
  show(run: Run, robot: number, from: number, to: number, theme: Theme, names: PlotName[]): void {
    if (this.root.hidden) return;
    const choice = [run.begin.name, robot, names].join();
    const now = performance.now();
    if (choice === this.key && now < this.next) return;
    this.key = choice;
    this.next = now + PERIOD;
    const end = Math.min(to, run.duration);
    const name = run.begin.robots[robot]?.name ?? 'robot';
    const time = (t: number): string => `${t.toFixed(1)} s`;
    const pieces = statusPieces(run, robot, from, end);
    const curves = plotRows(run, robot, theme, names).flatMap((row) =>
      row.curves.map((curve) => ({ title: `${row.title}, ${curve.name}`, row, curve })));
    this.root.replaceChildren(
      table(`Status of ${name}`, ['From', 'To', 'Status'],
        pieces.map(({ from: a, to: b, label }) => [time(Math.max(a, from)), time(Math.min(b, end)), label])),
      table(`Values of ${name}`, ['Time', 'Status', ...curves.map(({ title }) => title)],
        times(from, end).map((t) => {
          const index = run.frameIndex(t);
          const frame = run.frames[index]!;
          return [time(t), robotWords(run, frame, robot).label, ...curves.map(({ row, curve }) => valueText(row, curve.value(index)))];
        })));
  }
}
