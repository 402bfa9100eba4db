// SPDX-License-Identifier: Apache-2.0
import type { Run } from './data/run';
import { StreamReader } from './data/stream';
import { Files } from './input/files';
import { connectButtons, listenToKeys } from './input/keys';
import { type Transport, connect, showPlaying } from './input/playback';
import { Toolbar } from './input/toolbar';
import { throttled } from './input/tools';
import { element } from './page/dom';
import { SettingsPanel } from './panels/settings_panel';
import { Viewer } from './view/viewer';

interface State {
  paused: boolean;
  speed: number;
  map: number;
  maps: string[];
  sensing: 'map' | 'lidar';
  noise: 'none' | 'standard';
}

const WINDOW = 60; // displayed past [s]
const KEPT = 600; // past in memory [s]

/** The live page: events arrive over a WebSocket, and the user's actions are sent back. */
class Live implements Transport {
  playing = true;
  private readonly viewer = new Viewer();
  private readonly reader = new StreamReader((run) => this.begin(run));
  private readonly settings: SettingsPanel;
  private readonly files: Files;
  private socket: WebSocket | null = null;
  private run: Run | null = null;
  private following = true;
  private fresh = false; // a run has begun and is not displayed yet
  private factor = 1;
  private retry = 250; // until the next attempt to connect [ms]
  private frozen: [number, number] = [0, 1];
  private last = 0;
  private noticeTimer = 0;

  constructor() {
    const { viewer } = this;
    const send = (command: Record<string, unknown>): void => this.send(command);
    const toolbar = new Toolbar(viewer, send);
    viewer.camera.insetTop = 48;
    this.files = new Files(send, (notice) => this.tell(notice));
    const change = throttled((assignment: string) => send({ do: 'set', assignment }), 100);
    this.settings = new SettingsPanel(element('settings'),
      (group, name, value) => change(`${group}.${name}=${value}`));
    viewer.onSeek = (time) => this.seek(time);
    viewer.span = () => this.span();
    connect(this);
    connectButtons(viewer);
    listenToKeys(viewer, this, toolbar.keys, toolbar.help);
    element('go-live').addEventListener('click', () => this.end());
    this.open();
    requestAnimationFrame((now) => this.tick(now));
    Object.assign(window, { fairway: viewer });
  }

  toggle(): void {
    this.send({ do: 'pause', paused: this.playing });
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
    if (this.following) this.frozen = this.span();
    if (time < this.frozen[0]) this.frozen = [Math.max(time, first), this.frozen[1]];
    this.following = time >= this.run.duration - 1e-6;
    this.viewer.time = Math.min(Math.max(time, first), this.run.duration);
    element('go-live').hidden = this.following;
    this.viewer.invalidate();
  }

  start(): void {
    this.seek(this.run?.frames[0]?.time ?? 0);
  }

  end(): void {
    this.seek(Infinity);
  }

  speed(factor: number): void {
    this.send({ do: 'speed', factor });
  }

  private span(): [number, number] {
    if (!this.following) return this.frozen;
    const first = this.run?.frames[0]?.time ?? 0;
    const end = this.run?.duration ?? 0;
    const from = Math.max(first, end - WINDOW);
    return [from, Math.max(end, from + 10)];
  }

  private open(): void {
    const url = new URL('/live', location.href);
    url.protocol = 'ws:';
    const socket = new WebSocket(url);
    socket.binaryType = 'arraybuffer';
    socket.addEventListener('open', () => {
      this.retry = 250;
      this.reader.restart();
      this.pill('live', 'good');
    });
    socket.addEventListener('message', ({ data }) => {
      if (typeof data === 'string') this.told(JSON.parse(data) as { state?: State; notice?: string });
      else this.received(new Uint8Array(data as ArrayBuffer));
    });
    socket.addEventListener('close', () => {
      this.pill('connection lost, trying again', 'bad');
      setTimeout(() => this.open(), this.retry);
      this.retry = Math.min(this.retry * 2, 5000);
    });
    this.socket = socket;
  }

  private send(command: Record<string, unknown>): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(command));
  }

  private pill(text: string, tone: string): void {
    const pill = element('connection');
    pill.textContent = text;
    pill.className = `pill ${tone}`;
    pill.hidden = false;
  }

  private tell(notice: string): void {
    const root = element('notice');
    root.textContent = notice;
    root.hidden = false;
    clearTimeout(this.noticeTimer);
    this.noticeTimer = window.setTimeout(() => { root.hidden = true; }, 6000);
  }

  private told({ state, notice }: { state?: State; notice?: string }): void {
    if (notice) this.tell(notice);
    if (!state) return;
    this.playing = !state.paused;
    this.factor = state.speed;
    showPlaying(this.playing);
    this.pill(state.paused ? 'paused' : 'live', state.paused ? 'warn' : 'good');
    const speed = element<HTMLSelectElement>('speed');
    if (document.activeElement !== speed) speed.value = `${state.speed}`;
    this.files.show(state.maps, state.map);
    this.files.showSenses(state.sensing, state.noise);
  }

  private begin(run: Run): void {
    this.run = run;
    this.fresh = true;
  }

  private received(bytes: Uint8Array): void {
    this.reader.push(bytes);
    const { run, viewer } = this;
    if (!run || run.frames.length === 0) return;
    if (this.fresh) {
      this.fresh = false;
      this.following = true;
      element('go-live').hidden = true;
      element('title').textContent = run.begin.name;
      document.title = `${run.begin.name} – Fairway`;
      const before = viewer.run?.grids[0]?.[0]?.frame;
      const now = run.grids[0]?.[0]?.frame;
      viewer.time = run.duration;
      viewer.show(run, JSON.stringify(before) === JSON.stringify(now));
    }
    this.settings.show(run.settings);
    if (run.frames.length > 1000 && run.duration - run.frames[0]!.time > 1.2 * KEPT) {
      run.forget(run.duration - KEPT);
    }
    viewer.invalidate();
  }

  // Displays the present with a short delay, so that motion between cycles is smooth.
  private tick(now: number): void {
    const seconds = Math.min((now - this.last) / 1e3, 0.25);
    this.last = now;
    const { run, viewer } = this;
    if (run && this.following && run.frames.length > 0) {
      const end = run.duration;
      const lag = end - viewer.time;
      const period = end - (run.frames.at(-2)?.time ?? end);
      if (lag < 0 || lag > 0.6 * Math.max(this.factor, 1)) viewer.time = end;
      else if (lag > 0) {
        // The displayed time is never ahead of the received data, and its delay does not grow.
        const pace = lag > 1.5 * period ? 1.15 : 1;
        viewer.time = Math.min(viewer.time + pace * this.factor * seconds, end);
        viewer.invalidate();
      }
    }
    viewer.render();
    requestAnimationFrame((next) => this.tick(next));
  }
}

/** Connects to the server that this page came from. */
export async function startLive(): Promise<void> {
  if (!location.protocol.startsWith('http')) throw new Error('it holds no run, and nobody serves it');
  new Live();
}
