// SPDX-License-Identifier: Apache-2.0
import { unpack } from './data/bytes';
import { StreamReader } from './data/stream';
import { connectCompare, followParent, isPane } from './input/compare';
import { connectButtons, listenToKeys } from './input/keys';
import { type Transport, connect, showPlaying } from './input/playback';
import { openLink } from './input/share';
import { Toolbar } from './input/toolbar';
import { element } from './page/dom';
import { Tabs } from './page/tabs';
import { EventList } from './panels/event_list';
import { SettingsPanel } from './panels/settings_panel';
import { showSummary } from './panels/summary';
import { Legend } from './view/legend';
import { Viewer } from './view/viewer';

class Replay implements Transport {
  playing = false;
  private factor = 1;
  private last = 0; // time of the last picture [ms]

  constructor(private readonly viewer: Viewer) {
    const tick = (now: number): void => {
      this.advance(Math.min((now - this.last) / 1e3, 0.25));
      this.last = now;
      viewer.render();
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  toggle(): void {
    if (!this.playing && this.viewer.time >= this.end_()) this.seek(0);
    this.play(!this.playing);
  }

  step(direction: 1 | -1): void {
    this.play(false);
    const run = this.viewer.run!;
    const index = run.frameIndex(this.viewer.time);
    // A step back from between two frames leads to the earlier one.
    const between = direction < 0 && this.viewer.time > run.frames[index]!.time + 1e-6;
    const to = Math.min(Math.max(index + (between ? 0 : direction), 0), run.frames.length - 1);
    this.seek(run.frames[to]!.time);
  }

  seek(time: number): void {
    this.viewer.time = Math.min(Math.max(time, 0), this.end_());
    this.viewer.invalidate();
  }

  start(): void {
    this.seek(0);
  }

  end(): void {
    this.play(false);
    this.seek(this.end_());
  }

  speed(factor: number): void {
    this.factor = factor;
  }

  private end_(): number {
    return this.viewer.run?.duration ?? 0;
  }

  private play(playing: boolean): void {
    this.playing = playing;
    showPlaying(playing);
  }

  private advance(seconds: number): void {
    if (!this.playing) return;
    this.seek(this.viewer.time + this.factor * seconds);
    if (this.viewer.time >= this.end_()) this.play(false);
  }
}

/** The replay page: the page itself contains the run. */
export async function startReplay(packed: string): Promise<void> {
  const reader = new StreamReader();
  reader.push(await unpack(packed));
  const { run } = reader;
  if (!run || run.frames.length === 0) throw new Error('this page holds no run');
  const viewer = new Viewer();
  element('title').textContent = run.begin.name;
  document.title = `${run.begin.name} – Fairway`;
  const replay = new Replay(viewer);
  viewer.onSeek = (time) => replay.seek(time);
  const legend = new Legend(viewer);
  connect(replay);
  connectButtons(viewer);
  listenToKeys(viewer, replay, new Toolbar(viewer, null));
  new Tabs(element('tabs'), [['Robots', 'robots'], ['Events', 'events'], ['Values', 'values'], ['Summary', 'summary'], ['Settings', 'settings']]);
  showSummary(element('summary'), run);
  new SettingsPanel(element('settings'), null).show(run.settings);
  new EventList(element('events'), (time, robot) => { viewer.select(robot); replay.seek(time); }).follow(run, true);
  viewer.show(run);
  if (isPane()) followParent((time) => replay.seek(time));
  else connectCompare(viewer);
  const asked = openLink(viewer, legend);
  if (asked !== null) replay.seek(asked);
  // For measurements and tests.
  Object.assign(window, { fairway: viewer });
}
