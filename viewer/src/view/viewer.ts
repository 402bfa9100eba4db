// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import { explanationOf } from '../data/explanation';
import { type Moment, gridAt, momentAt, robotAt } from '../data/moment';
import type { Run } from '../data/run';
import { robotWords } from '../data/words';
import { Camera } from '../drawing/camera';
import { type Layers } from '../drawing/layers';
import { drawNote } from '../drawing/lettering';
import { Pen } from '../drawing/pen';
import { Scene } from '../drawing/scene';
import { Themes } from '../drawing/theme';
import { element, shown } from '../page/dom';
import { Plots } from '../panels/plots';
import { RobotPanel } from '../panels/robot_panel';
import { ValueTable } from '../panels/value_table';
import { Gestures } from './gestures';
import { MapCursor } from './map_cursor';
import { listenToPlots } from './plot_pointer';

/** Draws on the map after everything else, for example the preview of a tool. */
export type Overlay = (context: CanvasRenderingContext2D, camera: Camera) => void;

const paper: [number, number] = [703, 446]; // size of the map on paper [CSS pixels]
const PAPER_PLOTS = 190; // height of the plots on paper
const DESCRIBED = 250; // least time between two texts for screen readers [ms]
const FLASH = 5000; // how long a message is shown on the map [ms]

/** The map, the plots and the robots' cards at one time of a run. Other modules change the time. */
export class Viewer {
  readonly camera = new Camera();
  readonly themes = new Themes();
  readonly gestures: Gestures;
  readonly cursor: MapCursor;
  readonly map = element<HTMLCanvasElement>('map');
  readonly slider = element<HTMLInputElement>('time');
  readonly layers: Layers = {
    path: true, corridor: true, prediction: true, trail: true, limit: true, velocity: true, seen: true,
    scan: true, names: true, reasons: true, zones: true,
  };
  readonly plots = new Plots(element<HTMLCanvasElement>('plots'));
  readonly panel = new RobotPanel(element('robots'), (robot) => this.select(robot));
  run: Run | null = null;
  time = 0;
  selected = 0;
  moment: Moment | null = null;
  overlay: Overlay = () => {};
  /** The camera stays on the selected robot. */
  follow = false;
  /** Position of the pointer on the map. */
  hover: Point | null = null;
  /** The time span of the plots and the slider. */
  span: () => [number, number] = () => [0, this.run?.duration ?? 1];
  /** The user selected a time. */
  onSeek: (time: number) => void = () => {};
  /** After each picture. */
  onDrawn: () => void = () => {};
  /** The layers or the theme have changed. */
  onLook: () => void = () => {};
  /** Whether a new run may begin, which ends the present one; asks where something would be lost. */
  mayBegin: (what: string) => Promise<boolean> = () => Promise.resolve(true);
  /** Number of pictures drawn, for measurements. */
  drawn = 0;
  firstDrawn = 0; // time of the first picture since the page was requested [ms]

  private readonly scene = new Scene();
  private readonly values = new ValueTable(element('values'));
  private dirty = true;
  private described = 0; // when [ms]
  private sayTimer = 0;
  private later = 0; // timer of the next description
  private shownTo = 0; // end of the slider
  private flash: { at: Point; text: string; until: number } | null = null;

  constructor() {
    const pick = (at: Point): void => {
      if (!this.moment || !this.run) return;
      const robot = robotAt(this.moment, at, this.run.radius, 12 / this.camera.scale);
      if (robot !== null) this.select(robot);
    };
    this.gestures = new Gestures(this.map, this.camera, () => this.invalidate(), pick, () => { this.setFollow(false); });
    this.cursor = new MapCursor(this.map, this.camera, () => this.gestures.tool, pick, (at, text) => {
      this.hover = at;
      if (text) this.say(text);
      this.invalidate();
    });
    this.map.addEventListener('pointermove', (event) => {
      const box = this.map.getBoundingClientRect();
      this.hover = this.camera.toWorld({ x: event.clientX - box.left, y: event.clientY - box.top });
      this.invalidate();
    });
    this.map.addEventListener('pointerleave', () => { this.hover = null; this.invalidate(); });
    new ResizeObserver(() => this.resize()).observe(this.map.parentElement!);
    new ResizeObserver(() => this.invalidate()).observe(element('plots'));
    this.themes.onChange(() => { this.onLook(); this.invalidate(); });
    this.slider.addEventListener('input', () => this.onSeek(this.slider.valueAsNumber));
    listenToPlots(this, element<HTMLCanvasElement>('plots'));
    this.resize();
  }

  show(run: Run, keepView = false): void {
    this.run = run;
    this.selected = Math.min(this.selected, Math.max(run.begin.robots.length - 1, 0));
    if (!keepView) this.fit();
    this.onLook();
    this.invalidate();
  }

  select(robot: number): void {
    this.selected = robot;
    this.invalidate();
  }

  setFollow(follow: boolean): void {
    if (follow === this.follow) return;
    this.follow = follow;
    element('follow').setAttribute('aria-pressed', `${follow}`);
    this.invalidate();
  }

  fit(): void {
    this.setFollow(false);
    const grid = this.run && gridAt(this.run, 0, this.time);
    if (grid) this.camera.fit(grid.frame);
    this.invalidate();
  }

  /** Shows a message at a place on the map for some seconds, for example why a click had no effect. */
  tellAt(at: Point, text: string): void {
    this.flash = { at, text, until: performance.now() + FLASH };
    this.say(text);
    setTimeout(() => this.invalidate(), FLASH + 50);
    this.invalidate();
  }

  /** Shows a message below the map; screen readers read it. */
  say(text: string): void {
    element('hint').textContent = text;
    // A low screen has no line below the map: there the message floats over it for a while.
    const strip = element('strip');
    strip.classList.toggle('fresh', text !== '');
    clearTimeout(this.sayTimer);
    this.sayTimer = window.setTimeout(() => strip.classList.remove('fresh'), FLASH);
  }

  invalidate(): void {
    this.dirty = true;
  }

  /** Draws if anything has changed. */
  render(): void {
    if (!this.dirty || !this.run) return;
    this.dirty = false;
    this.moment = momentAt(this.run, this.time);
    if (!this.moment) return;
    // A robot that was removed cannot be selected.
    if (this.moment.frame.robots[this.selected]?.absent) {
      this.selected = Math.max(this.moment.frame.robots.findIndex((robot) => !robot.absent), 0);
    }
    const pose = this.moment.poses[this.selected];
    if (this.follow && pose) this.camera.center(pose);
    this.drawMap(devicePixelRatio);
    const [from, to] = this.span();
    this.plots.draw(this.run, this.selected, this.time, from, to, this.themes.current);
    this.panel.show(this.run, this.moment, this.selected, this.themes.current);
    this.values.show(this.run, this.selected, from, to, this.themes.current, this.plots.names);
    this.slider.min = `${from}`;
    if (to !== this.shownTo) this.slider.max = `${(this.shownTo = to)}`;
    this.slider.valueAsNumber = this.time;
    this.slider.setAttribute('aria-valuetext', `${shown(this.time, 1)} seconds`);
    element('clock').textContent = `${shown(this.time, 1)} / ${shown(this.run.duration, 1)} s`;
    this.describe();
    this.onDrawn();
    if (this.drawn++ === 0) this.firstDrawn = performance.now();
  }

  /** Draws for paper, light and sharp; afterwards for the screen again. */
  print(begins: boolean): void {
    this.themes.use(begins ? 'light' : 'chosen');
    if (!begins) {
      this.resize();
      return;
    }
    this.camera.resize(...paper);
    this.moment = this.run && momentAt(this.run, this.time);
    if (!this.run || !this.moment) return;
    this.drawMap(3);
    const [from, to] = this.span();
    const size = { width: paper[0], height: PAPER_PLOTS, ratio: 3 };
    this.plots.draw(this.run, this.selected, this.time, from, to, this.themes.current, size);
    this.panel.show(this.run, this.moment, this.selected, this.themes.current);
  }

  private drawMap(ratio: number): void {
    const [width, height] = [this.camera.width * ratio, this.camera.height * ratio].map(Math.round);
    if (this.map.width !== width || this.map.height !== height) {
      this.map.width = width!;
      this.map.height = height!;
    }
    const theme = this.themes.current;
    const context = this.map.getContext('2d', { alpha: false })!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.scene.draw(context, this.camera, theme, this.layers, this.run!, this.moment!, this.selected);
    this.overlay(context, this.camera);
    this.cursor.draw(context, theme.ink, theme.halo);
    if (this.flash && performance.now() > this.flash.until) this.flash = null;
    if (this.flash) drawNote(new Pen(context, this.camera, theme), this.flash.text, this.flash.at, 'fault');
  }

  // The text alternatives of both canvases, and the coordinates below the map.
  private describe(): void {
    const { run, moment, selected } = this;
    if (!run || !moment) return;
    const name = run.begin.robots[selected]?.name ?? 'robot';
    const why = explanationOf(run, moment.frame, selected);
    const lead = why.lead ? `${why.lead}: ` : '';
    this.coordinates();
    // Screen readers need no 60 descriptions a second.
    const now = performance.now();
    if (now < this.described + DESCRIBED && this.drawn > 0) {
      this.later ||= window.setTimeout(() => { this.later = 0; this.invalidate(); }, DESCRIBED);
      return;
    }
    this.described = now;
    this.map.setAttribute('aria-label', `Map with ${moment.frame.robots.length} robots and ${moment.frame.bodies.length} people. `
      + `${name} at ${shown(moment.poses[selected]?.x ?? NaN)}, ${shown(moment.poses[selected]?.y ?? NaN)} m: `
      + `${robotWords(run, moment.frame, selected).label}. ${lead}${why.reason}. ${why.detail}`);
    const plots = this.plots.describe(run, selected, this.time).join('. ');
    element('plots').setAttribute('aria-label', `${name} over time. At ${plots}`);
  }

  // The coordinates and the cell under the pointer, below the map.
  private coordinates(): void {
    let where = '';
    if (this.hover) {
      const cell = this.scene.cellName(this.hover);
      where = `x ${shown(this.hover.x)}, y ${shown(this.hover.y)} m${cell ? ` · ${cell}` : ''}`;
    }
    element('where').textContent = where;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.map.parentElement!;
    this.camera.resize(Math.max(clientWidth, 1), Math.max(clientHeight, 1));
    this.invalidate();
  }
}
