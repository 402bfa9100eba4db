// SPDX-License-Identifier: Apache-2.0
import { separation } from '../data/footprint';
import type { Run } from '../data/run';
import { make, shown } from '../page/dom';
import { FAR } from './plot_rows';

interface Facts {
  name: string;
  outcome: string;
  tone: string;
  time: number;
  length: number;
  room: number;
  gap: number;
}

function facts(run: Run, robot: number): Facts {
  const { body } = run;
  const reached = run.begin.statuses.indexOf('goal reached');
  const result: Facts = {
    name: run.begin.robots[robot]!.name, outcome: 'Not reached', tone: 'wait', time: run.duration,
    length: 0, room: Infinity, gap: Infinity,
  };
  let arrived: number | null = null;
  let last: { x: number; y: number } | null = null;
  for (const frame of run.frames) {
    const me = frame.robots[robot];
    if (!me) continue;
    if (last) result.length += Math.hypot(me.x - last.x, me.y - last.y);
    last = me;
    if (me.cycle) result.room = Math.min(result.room, me.cycle.clearance);
    result.gap = Math.min(result.gap, separation(frame, robot, body));
    if (me.cycle && me.cycle.status !== reached) arrived = null;
    if (me.cycle && me.cycle.status === reached) arrived ??= frame.time;
    if (me.collided) {
      Object.assign(result, { outcome: 'Collision', tone: 'bad', time: frame.time });
      return result;
    }
  }
  if (arrived !== null) Object.assign(result, { outcome: 'Goal reached', tone: 'good', time: arrived });
  return result;
}

/** The result of the run, robot by robot. */
export function showSummary(root: HTMLElement, run: Run): void {
  const cards = run.begin.robots.map((_, i) => {
    const fact = facts(run, i);
    const list = make('dl');
    const add = (title: string, text: string): void => {
      list.append(make('dt', {}, title), make('dd', {}, text));
    };
    add('Time', `${shown(fact.time, 1)} s`);
    add('Distance travelled', `${shown(fact.length, 1)} m`);
    add('Mean speed', `${shown(fact.length / Math.max(fact.time, 1e-9))} m/s`);
    add('Min. obstacle clearance', fact.room >= FAR - 1e-6 ? `> ${FAR} m` : `${shown(fact.room, 3)} m`);
    if (Number.isFinite(fact.gap)) add('Min. clearance to people/robots', `${shown(fact.gap, 3)} m`);
    return make('section', { class: 'card' },
      make('span', { class: 'head' }, make('span', {}, `Run summary: ${fact.name}`),
        make('span', { class: 'space' }), make('span', { class: `pill ${fact.tone}` }, fact.outcome)),
      list);
  });
  root.replaceChildren(...cards);
}
