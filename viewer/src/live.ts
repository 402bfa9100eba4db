// SPDX-License-Identifier: Apache-2.0
import { type LiveMessage, type LiveState, stateWords } from './data/live_messages';
import { PaceMeter, paceText } from './data/pace';
import type { Run } from './data/run';
import { StreamReader } from './data/stream';
import { Connection } from './input/connection';
import { EditButtons } from './input/edit_buttons';
import { Files } from './input/files';
import { connectButtons, listenToKeys } from './input/keys';
import { type Transport, connect, showPlaying } from './input/playback';
import { robotActions } from './input/robot_actions';
import { openLink } from './input/share';
import { Toolbar } from './input/toolbar';
import { element } from './page/dom';
import { notify } from './page/notice';
import { isPast, markPast } from './page/present';
import { Tabs } from './page/tabs';
import { BodyEditor } from './panels/body_editor';
import { EventList } from './panels/event_list';
import { SettingsPanel } from './panels/settings_panel';
import { Legend } from './view/legend';
import { Viewer } from './view/viewer';

const WINDOW = 60; // displayed past [s]
const KEPT = 600; // past in memory [s]
const SHORT = 5; // a run up to this length may be lost without a question [s]

/** The live page: events arrive over a WebSocket, and the user's actions are sent back. */
class Live implements Transport {
  playing = true; // the world, or in the past its replay
  private readonly viewer = new Viewer();
  private readonly legend = new Legend(this.viewer);
  private readonly reader = new StreamReader((run) => this.begin(run));
  private readonly settings: SettingsPanel;
  private readonly body: BodyEditor;
  private readonly files: Files;
  private readonly toolbar: Toolbar;
  private readonly edits: EditButtons;
  private readonly events: EventList;
  private state: LiveState | null = null;
  private readonly connection: Connection;
  private run: Run | null = null;
  private following = true;
  private fresh = false; // a run has begun and is not displayed yet
  private linked = false; // the address has been followed
  private asked: number | null = null; // the time in the address, until the run has reached it
  private replayed = 1; // speed of the replayed past
  private readonly meter = new PaceMeter();
  private frozen: [number, number] = [0, 1];
  private last = 0;

  constructor() {
    const { viewer } = this;
    const send = (command: Record<string, unknown>): void => this.send(command);
    this.toolbar = new Toolbar(viewer, send);
    this.edits = new EditButtons(send);
    viewer.panel.actions = robotActions(viewer, send);
    this.files = new Files(send, notify, () => this.loss());
    new Tabs(element('tabs'), [['Robots', 'robots'], ['Events', 'events'], ['Values', 'values'], ['Settings', 'settings']]);
    const change = (assignments: string[]): void => send({ do: 'set', assignments });
    this.body = new BodyEditor((values) => this.settings.send(values));
    this.settings = new SettingsPanel(element('settings'), change, this.body.root);
    this.events = new EventList(element('events'), (time, robot) => { viewer.select(robot); this.seek(time); });
    viewer.onSeek = (time) => this.seek(time);
    viewer.span = () => this.span();
    connect(this);
    connectButtons(viewer);
    listenToKeys(viewer, this, this.toolbar);
    for (const id of ['go-live', 'past-live']) element(id).addEventListener('click', () => this.end());
    this.connection = new Connection({
      opened: () => { this.reader.restart(); this.pill('live', 'good'); },
      message: (message) => this.told(message),
      records: (bytes) => this.received(bytes),
      closed: () => this.pill('Disconnected, reconnecting', 'bad'),
    });
    requestAnimationFrame((now) => this.tick(now));
    viewer.mayBegin = (what) => this.files.mayBegin(what);
    Object.assign(window, { fairway: viewer });
  }

  /** In the present: pauses the world. In the past: replays it. */
  toggle(): void {
    if (this.following) return this.send({ do: 'pause', paused: this.playing });
    this.playing = !this.playing;
    showPlaying(this.playing);
  }

  step(direction: 1 | -1): void {
    const run = this.run;
    if (!run) return;
    if (this.following && direction > 0) return this.send({ do: 'step' });
    const index = run.frameIndex(this.viewer.time);
    const frame = run.frames[Math.min(Math.max(index + direction, 0), run.frames.length - 1)];
    if (frame) this.seek(frame.time);
  }

  seek(time: number): void {
    if (!this.run) return;
    const first = this.run.frames[0]?.time ?? 0;
    if (this.following) {
      this.frozen = this.span();
      this.playing = false;
    }
    if (time < this.frozen[0]) this.frozen = [Math.max(time, first), this.frozen[1]];
    this.viewer.time = Math.min(Math.max(time, first), this.run.duration);
    this.follow(time >= this.run.duration - 1e-6);
    this.viewer.invalidate();
  }

  start(): void {
    this.seek(this.run?.frames[0]?.time ?? 0);
  }

  end(): void {
    this.seek(Infinity);
  }

  speed(factor: number): void {
    if (!this.following) this.replayed = factor;
    else this.send({ do: 'speed', factor });
  }

  // Follows the present, or shows clearly that this is the past, in which nothing can be changed.
  private follow(following: boolean): void {
    this.following = following;
    markPast(!following);
    element('go-live').toggleAttribute('disabled', following);
    element('past').hidden = following;
    this.toolbar.enable(following);
    if (following && this.state) {
      this.playing = !this.state.paused;
      element<HTMLSelectElement>('speed').value = `${this.state.speed}`;
    } else this.replayed = Number(element<HTMLSelectElement>('speed').value);
    showPlaying(this.playing);
    this.showState();
  }

  private span(): [number, number] {
    if (!this.following) return this.frozen;
    const first = this.run?.frames[0]?.time ?? 0;
    const end = this.run?.duration ?? 0;
    const from = Math.max(first, end - WINDOW);
    return [from, Math.max(end, from + 10)];
  }

  private send(command: Record<string, unknown>): void {
    // Only the emergency stop acts also while the page shows the past.
    if (isPast() && command.do !== 'halt') this.viewer.say('This is the past. Go live to change the world.');
    else if (!this.connection.send(command)) this.viewer.say('Disconnected: the change was not sent.');
  }

  // What a new run would lose; nothing worth a question in the first seconds.
  private loss(): string {
    const seconds = this.run?.duration ?? 0;
    return seconds > SHORT ? `The run of ${seconds.toFixed(1)} s will be lost; Export saves it.` : '';
  }

  private pill(text: string, tone: string): void {
    const pill = element('connection');
    pill.textContent = text;
    pill.className = `pill ${tone}`;
    pill.hidden = false;
  }

  private told({ state, notice, refused }: LiveMessage): void {
    if (notice) notify(notice);
    if (refused) this.refuse(refused);
    if (!state) return;
    if (state.speed !== this.state?.speed || state.paused) this.meter.reset();
    this.state = state;
    if (this.following) {
      this.playing = !state.paused;
      showPlaying(this.playing);
    }
    const speed = element<HTMLSelectElement>('speed');
    if (document.activeElement !== speed && this.following) speed.value = `${state.speed}`;
    this.files.show(state.maps, state.map, state.edited);
    this.files.showSenses(state.sensing, state.noise);
    this.showState();
  }

  private refuse({ text, at, settings }: NonNullable<LiveMessage['refused']>): void {
    if (settings) {
      this.settings.refuse(settings, text);
      if (settings.includes('robot.length')) this.body.refused(text);
    } else if (at) this.viewer.tellAt(at, text);
    else notify(text);
  }

  private showState(): void {
    const { state } = this;
    if (!state) return;
    this.edits.show(state.undo, state.redo, state.halted, this.following);
    if (!this.connection.isOpen) return;
    const [text, tone] = stateWords(state, this.following ? null : this.viewer.time, this.meter.pace);
    this.pill(text, tone);
  }

  private begin(run: Run): void {
    this.run = run;
    this.fresh = true;
  }

  private received(bytes: Uint8Array): void {
    this.reader.push(bytes);
    const { run, viewer } = this;
    if (!run || run.frames.length === 0) return;
    this.measure(run);
    if (this.fresh) {
      this.fresh = false;
      this.follow(true);
      element('title').textContent = run.begin.name;
      document.title = `${run.begin.name} – Fairway`;
      const before = viewer.run?.grids[0]?.[0]?.frame;
      const now = run.grids[0]?.[0]?.frame;
      viewer.time = run.duration;
      viewer.show(run, JSON.stringify(before) === JSON.stringify(now));
    }
    if (!this.linked) {
      this.linked = true;
      this.asked = openLink(viewer, this.legend);
    }
    // The past arrives in pieces: a time can be looked at once the run is that long.
    if (this.asked !== null && run.duration > this.asked) {
      this.seek(this.asked);
      this.asked = null;
    }
    if (this.settings.show(run.settings)) this.body.show(run.body);
    this.events.follow(run);
    this.legend.follow(run);
    if (run.frames.length > 1000 && run.duration - run.frames[0]!.time > 1.2 * KEPT) {
      run.forget(run.duration - KEPT);
    }
    viewer.invalidate();
  }

  // A paused world has no pace, and one that is late says so.
  private measure(run: Run): void {
    const { meter, state } = this;
    if (!state || state.paused || state.waiting) return meter.reset();
    const before = paceText(meter.pace, state.speed);
    meter.add(run.duration, performance.now() / 1e3);
    if (this.following && paceText(meter.pace, state.speed) !== before) this.showState();
  }

  private tick(now: number): void {
    const seconds = Math.min((now - this.last) / 1e3, 0.25);
    this.last = now;
    if (this.run && this.run.frames.length > 0) {
      if (this.following) this.showPresent(this.run, seconds);
      else this.showPast(this.run, seconds);
    }
    this.viewer.render();
    requestAnimationFrame((next) => this.tick(next));
  }

  // Displays the present with a short delay, so that motion between cycles is smooth.
  private showPresent(run: Run, seconds: number): void {
    const { viewer } = this;
    const factor = this.state?.speed ?? 1;
    const end = run.duration;
    const lag = end - viewer.time;
    const period = end - (run.frames.at(-2)?.time ?? end);
    if (lag < 0 || lag > 0.6 * Math.max(factor, 1)) viewer.time = end;
    else if (lag > 0) {
      // The displayed time is never ahead of the received data, and its delay does not grow.
      const pace = lag > 1.5 * period ? 1.15 : 1;
      viewer.time = Math.min(viewer.time + pace * factor * seconds, end);
      viewer.invalidate();
    }
  }

  private showPast(run: Run, seconds: number): void {
    const { viewer } = this;
    const [from, to] = this.frozen;
    if (this.playing && seconds > 0) {
      viewer.time = Math.min(viewer.time + this.replayed * seconds, run.duration);
      if (viewer.time > to) this.frozen = [from, viewer.time];
      viewer.invalidate();
      if (viewer.time >= run.duration) return this.follow(true);
    }
    const text = `Viewing ${viewer.time.toFixed(1)} s; the world is at ${run.duration.toFixed(1)} s. Tools are off.`;
    const root = element('past-text');
    if (root.textContent !== text) {
      root.textContent = text;
      this.showState();
    }
  }
}

/** Connects to the server that this page came from. */
export async function startLive(): Promise<void> {
  if (!location.protocol.startsWith('http')) throw new Error('it holds no run, and it was not opened from a server');
  new Live();
}
