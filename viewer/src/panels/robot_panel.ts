// SPDX-License-Identifier: Apache-2.0
import { separation } from '../data/footprint';
import type { Moment } from '../data/moment';
import type { Run } from '../data/run';
import { type Theme, robotColor, statusTone } from '../drawing/theme';
import { make, shown } from '../page/dom';

const MOST_LONG_CARDS = 3; // with more robots only the selected one shows all values

interface Card {
  root: HTMLButtonElement;
  dot: HTMLElement;
  status: HTMLElement;
  why: HTMLElement;
  bar: HTMLElement;
  values: Record<keyof typeof titles, HTMLElement>;
}

const titles = {
  speed: 'Speed', turn: 'Turning', clearance: 'Room to walls', separation: 'Room to others',
  cycle: 'Control cycle', solver: 'Solver',
};

/** A card per robot: its status, the reason, and its speeds. */
export class RobotPanel {
  private cards: Card[] = [];
  private run: Run | null = null;

  constructor(
    private readonly root: HTMLElement,
    private readonly select: (robot: number) => void,
  ) {}

  show(run: Run, moment: Moment, selected: number, theme: Theme): void {
    if (run !== this.run) this.rebuild(run);
    this.cards.forEach((card, i) => this.update(card, i, run, moment, i === selected, theme));
  }

  private rebuild(run: Run): void {
    this.run = run;
    this.cards = run.begin.robots.map((task, i) => this.card(task.name, i));
    this.root.replaceChildren(...this.cards.map((card) => card.root));
  }

  private card(name: string, index: number): Card {
    const dot = make('span', { class: 'dot' });
    const status = make('span', { class: 'pill' });
    const why = make('div', { class: 'why' });
    const bar = make('i');
    const list = make('dl');
    const values = {} as Card['values'];
    for (const [key, title] of Object.entries(titles)) {
      const value = make('dd', { 'data-value': key });
      values[key as keyof typeof titles] = value;
      list.append(make('dt', {}, title), value);
    }
    const root = make('button', { class: 'card', type: 'button', 'data-robot': `${index}` },
      make('span', { class: 'head' }, dot, make('span', {}, name), make('span', { class: 'space' }), status),
      why, make('div', { class: 'bar' }, bar), list);
    root.addEventListener('click', () => this.select(index));
    return { root, dot, status, why, bar, values };
  }

  private update(
    card: Card, index: number, run: Run, moment: Moment, selected: boolean, theme: Theme,
  ): void {
    const robot = moment.frame.robots[index];
    if (!robot) return;
    card.root.classList.toggle('selected', selected && this.cards.length > 1);
    card.root.classList.toggle('short', !selected && this.cards.length > MOST_LONG_CARDS);
    card.root.setAttribute('aria-pressed', `${selected}`);
    card.dot.style.background = robotColor(index, theme);
    const { cycle } = robot;
    const status = robot.collided ? null : robot.status;
    card.status.textContent = robot.collided ? 'contact' : status === null ? 'waiting' : run.begin.statuses[status]!;
    card.status.className = `pill ${robot.collided ? 'bad' : status === null ? 'idle' : statusTone(status)}`;
    this.reason(card, run, index, moment);
    const most = run.setting('robot', 'linear_max') || 1;
    const speed = cycle?.linear ?? 0;
    card.bar.style.width = `${Math.min(100, 100 * Math.abs(speed) / most)}%`;
    card.values.speed.textContent = `${shown(speed)} of ${shown(most)} m/s`;
    card.values.turn.textContent = `${shown(cycle?.angular ?? 0)} rad/s`;
    card.values.clearance.textContent = cycle ? `${shown(cycle.clearance)} m` : '–';
    const gap = separation(moment.frame, index, run.body);
    card.values.separation.textContent = Number.isFinite(gap) ? `${shown(gap)} m` : 'alone';
    card.values.cycle.textContent = cycle && cycle.micros > 0 ? `${Math.round(cycle.micros)} µs` : '–';
    card.values.solver.textContent = cycle && cycle.iterations > 0 ? `${cycle.iterations} iterations` : '–';
  }

  private reason(card: Card, run: Run, index: number, moment: Moment): void {
    const robot = moment.frame.robots[index]!;
    const { cycle, plan } = robot;
    card.why.replaceChildren();
    if (robot.collided) {
      card.why.append(make('b', { class: 'bad' }, 'touched something'), ', and is out of this run');
    } else if (plan && !plan.usable) {
      card.why.append(make('b', { class: 'bad' }, plan.reason));
    } else if (cycle && cycle.limit > 0) {
      // The constraint is more specific than the limiting factor: which speed, which acceleration.
      const row = run.begin.rows[cycle.row];
      const limit = run.begin.limits[cycle.limit]!;
      const name = cycle.row > 0 && row && cycle.limit < 5 ? row : limit;
      // Red like its mark on the map.
      card.why.append('held back by: ', make('b', cycle.mark ? { class: 'bad' } : {}, name));
    } else {
      card.why.append(cycle ? 'nothing holds it back' : 'stands');
    }
  }
}
