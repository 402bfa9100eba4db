// SPDX-License-Identifier: Apache-2.0
import { explanationOf } from '../data/explanation';
import { separation } from '../data/footprint';
import type { Moment } from '../data/moment';
import type { Run } from '../data/run';
import { hasGoal, robotWords } from '../data/words';
import { type Theme, robotColor } from '../drawing/theme';
import { make, shown } from '../page/dom';
import { FAR } from './plot_rows';

const MOST_CARDS = 3; // with more robots there is a table, and one card for the selected robot

interface Card {
  root: HTMLElement;
  name: HTMLButtonElement;
  dot: HTMLElement;
  status: HTMLElement;
  why: HTMLElement;
  detail: HTMLElement;
  help: HTMLElement;
  bar: HTMLElement;
  values: Record<keyof typeof titles, HTMLElement>;
  /** Buttons of the live page; shown below the values. */
  actions: HTMLElement | null;
}

const titles = {
  speed: 'Speed', turn: 'Angular velocity', clearance: 'Obstacle clearance',
  separation: 'Clearance to people/robots', goal: 'Goal', cycle: 'Cycle time', solver: 'Solver iterations',
};

/** Makes the buttons of a robot's card. */
export type RobotActions = (robot: number) => HTMLElement;

const far = (value: number): string => (value >= FAR - 1e-6 ? `> ${FAR} m` : `${shown(value)} m`);

/** A card per robot: its status, the reason, and its values. With many robots also a table. */
export class RobotPanel {
  /** Buttons for the cards; the live page has them. */
  actions: RobotActions | null = null;
  private cards: Card[] = [];
  private rows: Map<string, HTMLElement>[] = [];
  private key = '';
  private run: Run | null = null;

  constructor(
    private readonly root: HTMLElement,
    private readonly select: (robot: number) => void,
  ) {}

  show(run: Run, moment: Moment, selected: number, theme: Theme): void {
    const present = moment.frame.robots.flatMap((robot, i) => (robot.absent ? [] : [i]));
    const key = present.join();
    if (run !== this.run || key !== this.key) {
      this.run = run;
      this.key = key;
      this.rebuild(run, present);
    }
    const table = present.length > MOST_CARDS;
    for (const i of present) {
      const card = this.cards[i]!;
      card.root.hidden = table && i !== selected;
      if (!card.root.hidden) this.update(card, i, run, moment, i === selected, theme);
      if (table) this.row(i, run, moment, i === selected, theme);
    }
  }

  private rebuild(run: Run, present: number[]): void {
    this.cards = [];
    this.rows = [];
    this.root.replaceChildren();
    const table = present.length > MOST_CARDS;
    for (const i of present) {
      this.cards[i] = this.card(run.begin.robots[i]!.name, i, table);
      this.root.append(this.cards[i]!.root);
    }
    if (table) this.root.append(this.table(run, present));
  }

  private table(run: Run, present: number[]): HTMLElement {
    const head = ['Robot', 'Status', 'm/s', 'Clear.'].map((text) => make('th', { scope: 'col' }, text));
    const body = make('tbody');
    for (const i of present) {
      const dot = make('span', { class: 'dot' });
      const name = make('button', { type: 'button', 'data-robot': `${i}`, class: 'plain' }, dot, run.begin.robots[i]!.name);
      name.addEventListener('click', () => this.select(i));
      const cells = new Map<string, HTMLElement>([['name', name], ['dot', dot]]);
      const row = make('tr', {}, make('td', {}, name));
      for (const key of ['status', 'speed', 'clearance']) {
        const cell = make('td');
        cells.set(key, cell);
        row.append(cell);
      }
      row.addEventListener('click', () => this.select(i));
      cells.set('row', row);
      this.rows[i] = cells;
      body.append(row);
    }
    return make('table', { class: 'fleet', 'aria-label': 'All robots' }, make('thead', {}, make('tr', {}, ...head)), body);
  }

  private row(index: number, run: Run, moment: Moment, selected: boolean, theme: Theme): void {
    const cells = this.rows[index]!;
    const robot = moment.frame.robots[index]!;
    const words = robotWords(run, moment.frame, index);
    cells.get('row')!.classList.toggle('selected', selected);
    cells.get('name')!.setAttribute('aria-pressed', `${selected}`);
    cells.get('dot')!.style.background = robotColor(index, theme);
    const status = cells.get('status')!;
    status.textContent = words.label;
    status.className = words.tone;
    cells.get('speed')!.textContent = shown(robot.cycle?.linear ?? 0);
    cells.get('clearance')!.textContent = robot.cycle ? far(robot.cycle.clearance).replace(' m', '') : '–';
  }

  private card(name: string, index: number, table: boolean): Card {
    const dot = make('span', { class: 'dot' });
    const status = make('span', { class: 'pill' });
    const why = make('div', { class: 'why' });
    const detail = make('div', { class: 'why detail' });
    const help = make('details', { class: 'why' });
    const bar = make('i');
    const list = make('dl');
    const values = {} as Card['values'];
    for (const [key, title] of Object.entries(titles)) {
      const value = make('dd', { 'data-value': key });
      values[key as keyof typeof titles] = value;
      list.append(make('dt', {}, title), value);
    }
    // In the table each robot has its button already.
    const attributes: Record<string, string> = { type: 'button', class: 'plain' };
    if (!table) attributes['data-robot'] = `${index}`;
    const button = make('button', attributes, dot, make('span', {}, name));
    button.addEventListener('click', () => this.select(index));
    const actions = this.actions?.(index) ?? null;
    const root = make('section', { class: 'card', 'aria-label': name },
      make('div', { class: 'head' }, button, make('span', { class: 'space' }), status),
      why, detail, help, make('div', { class: 'bar' }, bar), list, actions);
    return { root, name: button, dot, status, why, detail, help, bar, values, actions };
  }

  private update(card: Card, index: number, run: Run, moment: Moment, selected: boolean, theme: Theme): void {
    const robot = moment.frame.robots[index];
    if (!robot) return;
    card.root.classList.toggle('selected', selected && this.cards.length > 1);
    card.name.setAttribute('aria-pressed', `${selected}`);
    card.dot.style.background = robotColor(index, theme);
    const { cycle } = robot;
    const words = robotWords(run, moment.frame, index);
    card.status.textContent = words.label;
    card.status.className = `pill ${words.tone}`;
    card.status.title = words.guide?.meaning ?? '';
    this.reason(card, run, index, moment);
    this.guide(card, words.guide?.remedy ? words.guide : null);
    const most = run.setting('robot', 'linear_max') || 1;
    const speed = cycle?.linear ?? 0;
    card.bar.style.width = `${Math.min(100, 100 * Math.abs(speed) / most)}%`;
    card.values.speed.textContent = `${shown(speed)} / ${shown(most)} m/s`;
    card.values.turn.textContent = `${shown(cycle?.angular ?? 0)} rad/s`;
    card.values.clearance.textContent = cycle ? far(cycle.clearance) : '–';
    const gap = separation(moment.frame, index, run.body);
    card.values.separation.textContent = Number.isFinite(gap) ? `${shown(gap)} m` : 'none';
    const goal = hasGoal(run, robot, index) ? robot.goal ?? robot.plan?.goal : null;
    card.values.goal.textContent = goal ? `${shown(goal.x)}, ${shown(goal.y)} m` : 'none';
    card.values.cycle.textContent = cycle && cycle.micros > 0 ? `${Math.round(cycle.micros)} µs` : '–';
    card.values.solver.textContent = cycle && cycle.iterations > 0 ? `${cycle.iterations}` : '–';
    if (card.actions) card.actions.dataset.collided = `${robot.collided}`;
  }

  private reason(card: Card, run: Run, index: number, moment: Moment): void {
    const { lead, reason, detail, fault } = explanationOf(run, moment.frame, index);
    const text = `${lead ? `${lead}: ` : ''}${reason}`;
    if (card.why.textContent !== text) {
      card.why.replaceChildren(lead ? `${lead}: ` : '', make('b', fault ? { class: 'bad' } : {}, reason));
    }
    if (card.detail.textContent !== detail) card.detail.textContent = detail;
    card.detail.hidden = detail === '';
  }

  // What the status means and what to do, from the table of `fairway statuses`.
  private guide(card: Card, guide: { meaning: string; causes: string; remedy: string } | null): void {
    const key = guide?.meaning ?? '';
    if (card.help.dataset.key === key) return;
    card.help.dataset.key = key;
    card.help.hidden = !guide;
    if (!guide) return;
    card.help.replaceChildren(make('summary', {}, 'What this means'), make('p', {}, guide.meaning));
    if (guide.causes) card.help.append(make('p', {}, `Usual causes: ${guide.causes}`));
    card.help.append(make('p', {}, `What to do: ${guide.remedy}`));
  }
}
