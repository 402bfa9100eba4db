// SPDX-License-Identifier: Apache-2.0
import { EventLog } from '../data/events';
import type { Run } from '../data/run';
import { make } from '../page/dom';

/** The events of a run, newest first; a click goes to the time and the robot. */
export class EventList {
  private readonly log = new EventLog();
  private readonly list = make('ol', { class: 'events' });
  private readonly empty = make('p', { class: 'meaning' }, 'No events yet.');
  private shownEvents = 0; // of all events ever
  private run: Run | null = null;

  constructor(root: HTMLElement, private readonly go: (time: number, robot: number) => void) {
    root.append(this.empty, this.list);
  }

  /** Adds what is new. */
  follow(run: Run, whole = false): void {
    this.log.follow(run, whole);
    const { events, total } = this.log;
    if (run !== this.run) {
      this.run = run;
      this.list.replaceChildren();
      this.shownEvents = 0;
    }
    this.empty.hidden = total > 0;
    if (total === this.shownEvents) return;
    for (const event of events.slice(-(total - this.shownEvents))) {
      const button = make('button', { type: 'button', class: 'plain event' },
        make('span', { class: 'when' }, `${event.time.toFixed(1)} s`),
        make('span', { class: `mark ${event.tone}` }),
        make('span', {}, `${run.begin.robots.length > 1 ? `${run.begin.robots[event.robot]?.name ?? ''}: ` : ''}${event.text}`));
      button.addEventListener('click', () => this.go(event.time, event.robot));
      this.list.prepend(make('li', {}, button));
    }
    this.shownEvents = total;
    while (this.list.childElementCount > events.length) this.list.lastElementChild!.remove();
  }
}
