// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import { type Moment, gridAt, momentAt, robotAt } from '../data/moment';
import type { Run } from '../data/run';
import { Camera } from '../drawing/camera';
import { type Layer, type Layers, layerNames } from '../drawing/layers';
import { Scene } from '../drawing/scene';
import { Themes } from '../drawing/theme';
import { element, make, shown } from '../page/dom';
import { Plots } from '../panels/plots';
import { RobotPanel } from '../panels/robot_panel';
import { Gestures } from './gestures';

/** Draws on the map after everything else, for example the preview of a tool. */
export type Overlay = (context: CanvasRenderingContext2D, camera: Camera) => void;

const paper: [number, number] = [703, 446]; // size of the map on paper [CSS pixels]
const PAPER_PLOTS = 168; // height of the plots on paper

/** The map, the plots and the robots' cards at one time of a run. Other modules change the time. */
export class Viewer {
  readonly camera = new Camera();
  readonly themes = new Themes();
  readonly gestures: Gestures;
  readonly map = element<HTMLCanvasElement>('map');
  readonly slider = element<HTMLInputElement>('time');
  readonly layers: Layers = {
    path: true, corridor: true, prediction: true, trail: true, limit: true, velocity: true, seen: true,
    scan: true, names: true,
  };
  run: Run | null = null;
  time = 0;
  selected = 0;
  moment: Moment | null = null;
  overlay: Overlay = () => {};
  /** Position of the pointer on the map. */
  hover: Point | null = null;
  /** The time span of the plots and the slider. */
  span: () => [number, number] = () => [0, this.run?.duration ?? 1];
  /** The user selected a time. */
  onSeek: (time: number) => void = () => {};
  /** Number of pictures drawn, for measurements. */
  drawn = 0;
  firstDrawn = 0; // time of the first picture since the page was requested [ms]

  private readonly scene = new Scene();
  private readonly plots = new Plots(element<HTMLCanvasElement>('plots'));
  private readonly panel = new RobotPanel(element('robots'), (robot) => this.select(robot));
  private dirty = true;
  private shownTo = 0; // end of the slider

  constructor() {
    this.gestures = new Gestures(this.map, this.camera, () => this.invalidate(), (at) => {
      if (!this.moment || !this.run) return;
      const robot = robotAt(this.moment, at, this.run.radius, 12 / this.camera.scale);
      if (robot !== null) this.select(robot);
    });
    this.map.addEventListener('pointermove', (event) => {
      const box = this.map.getBoundingClientRect();
      this.hover = this.camera.toWorld({ x: event.clientX - box.left, y: event.clientY - box.top });
      this.invalidate();
    });
    this.map.addEventListener('pointerleave', () => { this.hover = null; this.invalidate(); });
    new ResizeObserver(() => this.resize()).observe(element('stage'));
    new ResizeObserver(() => this.invalidate()).observe(element('plots'));
    this.themes.onChange(() => { this.legend(); this.invalidate(); });
    this.slider.addEventListener('input', () => this.onSeek(this.slider.valueAsNumber));
    this.listenToPlots(element('plots'));
    this.layerSwitches();
    this.legend();
    this.resize();
  }

  show(run: Run, keepView = false): void {
    this.run = run;
    this.selected = Math.min(this.selected, Math.max(run.begin.robots.length - 1, 0));
    if (!keepView) this.fit();
    this.legend();
    // Only a robot with a lidar has these layers.
    element('layers').querySelector('[data-layer="scan"]')!.closest('label')!.hidden = !run.lidar;
    this.invalidate();
  }

  select(robot: number): void {
    this.selected = robot;
    this.invalidate();
  }

  fit(): void {
    const grid = this.run && gridAt(this.run, 0, this.time);
    if (grid) this.camera.fit(grid.frame);
    this.invalidate();
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
    this.drawMap(devicePixelRatio);
    const [from, to] = this.span();
    this.plots.draw(this.run, this.selected, this.time, from, to, this.themes.current);
    this.panel.show(this.run, this.moment, this.selected, this.themes.current);
    this.slider.min = `${from}`;
    if (to !== this.shownTo) this.slider.max = `${(this.shownTo = to)}`;
    this.slider.valueAsNumber = this.time;
    this.slider.setAttribute('aria-valuetext', `${shown(this.time, 1)} seconds`);
    element('clock').textContent = `${shown(this.time, 1)} of ${shown(this.run.duration, 1)} s`;
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
    const context = this.map.getContext('2d', { alpha: false })!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.scene.draw(context, this.camera, this.themes.current, this.layers, this.run!, this.moment!,
      this.selected);
    this.overlay(context, this.camera);
  }

  private resize(): void {
    const stage = element('stage');
    this.camera.resize(Math.max(stage.clientWidth, 1), Math.max(stage.clientHeight, 1));
    this.invalidate();
  }

  private listenToPlots(canvas: HTMLElement): void {
    const seek = (event: PointerEvent): void => {
      const box = canvas.getBoundingClientRect();
      this.onSeek(this.plots.timeAt(event.clientX - box.left));
    };
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (canvas.hasPointerCapture(event.pointerId)) seek(event);
    });
  }

  private layerSwitches(): void {
    const root = element('layers');
    for (const [layer, title] of Object.entries(layerNames)) {
      const box = make('input', { type: 'checkbox', 'data-layer': layer });
      box.checked = this.layers[layer as Layer];
      box.addEventListener('change', () => {
        this.layers[layer as Layer] = box.checked;
        this.invalidate();
      });
      root.append(make('label', {}, box, title));
    }
  }

  private legend(): void {
    const theme = this.themes.current;
    const entries: [string, string][] = [
      ['path', theme.path], ['rectangle it is in', theme.current], ['prediction', theme.prediction],
      ['moving, and room to it', theme.body], ['what limits', theme.limit]];
    if (this.run?.lidar) entries.push(['lidar', theme.scan], ['seen as occupied, or moving', theme.believed]);
    element('legend').replaceChildren(...entries.map(([text, color]) => {
      const mark = make('i');
      mark.style.borderTopColor = color;
      mark.classList.toggle('dashed', text === 'path');
      return make('span', {}, mark, text);
    }));
  }
}
