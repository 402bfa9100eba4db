// SPDX-License-Identifier: Apache-2.0
import type { Run } from '../data/run';
import type { Theme } from '../drawing/theme';
import { robotWords } from '../data/words';
import { type PlotName, type PlotRow, plotRows, valueText } from './plot_rows';
import { drawRibbon, statusPieces } from './ribbon';

/** Space left and right of the plots for axes; the time slider above them has the same. */
export const plotGutter = { left: 46, right: 14 };

const RIBBON = 16;
const GAP = 16;
const AXIS = 18;
const LEAST_ROW = 16;

interface Band {
  row: PlotRow;
  top: number;
  height: number;
}

const niceStep = (span: number, count: number): number => {
  const raw = span / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  const unit = [1, 2, 5, 10].find((n) => n * power >= raw) ?? 10;
  return unit * power;
};

/** Status and curves of one robot over time. */
export class Plots {
  /** The plots that are shown below the status. */
  names: PlotName[] = ['speed', 'clearance'];
  private readonly still = document.createElement('canvas'); // everything except the cursor
  private key = '';
  private width = 0; // of the drawn plots
  private from = 0;
  private to = 1;
  private bands: Band[] = [];

  constructor(private readonly canvas: HTMLCanvasElement) {}

  /** The height that the chosen plots need [CSS pixels]. */
  height(each: number): number {
    return RIBBON + AXIS + this.names.length * (each + GAP);
  }

  /** The time under a pixel column. */
  timeAt(x: number): number {
    const share = (x - plotGutter.left) / this.room();
    return this.from + Math.min(Math.max(share, 0), 1) * (this.to - this.from);
  }

  /** @param paper the size and the pixels per unit to draw with, if not the canvas's own. */
  draw(
    run: Run, robot: number, time: number, from: number, to: number, theme: Theme,
    paper?: { width: number; height: number; ratio: number },
  ): void {
    const { width, height, ratio } = paper ?? {
      width: this.canvas.clientWidth, height: this.canvas.clientHeight, ratio: devicePixelRatio };
    if (width < 100 || height < RIBBON + AXIS) return;
    this.width = width;
    [this.from, this.to] = [from, Math.max(to, from + 1e-3)];
    const key = [width, height, ratio, run.frames.length, run.duration, robot, from, to, theme.dark, this.names].join();
    if (key !== this.key) {
      this.key = key;
      this.still.width = Math.round(width * ratio);
      this.still.height = Math.round(height * ratio);
      const context = this.still.getContext('2d')!;
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      this.drawStill(context, run, robot, width, height, theme);
    }
    if (this.canvas.width !== this.still.width || this.canvas.height !== this.still.height) {
      this.canvas.width = this.still.width;
      this.canvas.height = this.still.height;
    }
    const context = this.canvas.getContext('2d')!;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.still, 0, 0);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.planned(context, run, robot, time, theme);
    const x = this.column(time);
    context.strokeStyle = theme.ink;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, height - AXIS);
    context.stroke();
  }

  /** All values at a time, as text: for the pointer, and instead of the picture. */
  describe(run: Run, robot: number, time: number): string[] {
    const index = run.frameIndex(time);
    const frame = run.frames[index];
    if (!frame) return [];
    const lines = [`${frame.time.toFixed(1)} s: ${robotWords(run, frame, robot).label}`];
    for (const { row } of this.bands) {
      lines.push(`${row.title}: ${row.curves.map((curve) => `${curve.name} ${valueText(row, curve.value(index))}`).join(', ')}`);
    }
    return lines;
  }

  private room(): number {
    return Math.max(this.width - plotGutter.left - plotGutter.right, 1);
  }

  private column(time: number): number {
    return plotGutter.left + (time - this.from) / (this.to - this.from) * this.room();
  }

  private drawStill(
    context: CanvasRenderingContext2D, run: Run, robot: number, width: number, height: number, theme: Theme,
  ): void {
    context.clearRect(0, 0, width, height);
    drawRibbon(context, statusPieces(run, robot, this.from, this.to), (time) => this.column(time),
      { left: plotGutter.left, right: plotGutter.left + this.room(), height: RIBBON }, theme);
    this.times(context, height - AXIS, theme);
    // A small screen has space for some of the plots, or for the status only.
    const rows = plotRows(run, robot, theme, this.names);
    let each = 0;
    for (; rows.length > 0; rows.pop()) {
      each = (height - AXIS - RIBBON) / rows.length - GAP;
      if (each >= LEAST_ROW) break;
    }
    this.bands = rows.map((row, i) => ({ row, top: RIBBON + GAP + i * (each + GAP), height: each }));
    for (const band of this.bands) {
      this.frame(context, band, theme);
      for (const level of band.row.levels) this.level(context, band, level.value, level.color);
      for (const curve of band.row.curves) this.curve(context, run, band, curve.color, curve.width, curve.value);
    }
  }

  // The speed that the controller plans from `time` on.
  private planned(context: CanvasRenderingContext2D, run: Run, robot: number, time: number, theme: Theme): void {
    const band = this.bands.find(({ row }) => row.title === 'Speed');
    const points = run.frames[run.frameIndex(time)]?.robots[robot]?.cycle?.prediction ?? [];
    const step = run.setting('mpc', 'step_length');
    if (!band || points.length < 2 || !(step > 0)) return;
    context.save();
    context.beginPath();
    context.rect(plotGutter.left, 0, this.room() + plotGutter.right, band.top + band.height);
    context.clip();
    context.strokeStyle = theme.prediction;
    context.lineWidth = 2;
    context.setLineDash([5, 3]);
    context.beginPath();
    for (let k = 0; k + 1 < points.length; ++k) {
      const v = Math.hypot(points[k + 1]!.x - points[k]!.x, points[k + 1]!.y - points[k]!.y) / step;
      const y = this.heightOf(band, v);
      if (k === 0) context.moveTo(this.column(time), y);
      context.lineTo(this.column(time + (k + 0.5) * step), y);
    }
    context.stroke();
    context.restore();
  }

  private times(context: CanvasRenderingContext2D, top: number, theme: Theme): void {
    const step = niceStep(this.to - this.from, this.room() / 80);
    context.font = '11px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'top';
    for (let t = Math.ceil(this.from / step - 1e-9) * step; t <= this.to + 1e-9; t += step) {
      const x = this.column(t);
      context.fillStyle = theme.grid;
      context.fillRect(x - 0.5, RIBBON + GAP, 1, top - RIBBON - GAP);
      context.fillStyle = theme.faint;
      const text = `${+t.toFixed(2)} s`;
      const half = context.measureText(text).width / 2;
      context.fillText(text, Math.min(x, this.width - half - 6), top + 4);
    }
  }

  // The axis, and the title with the names of the curves above the plot.
  private frame(context: CanvasRenderingContext2D, band: Band, theme: Theme): void {
    const { row, top } = band;
    context.font = '11px system-ui, sans-serif';
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    const step = niceStep(row.max - row.min, band.height / 24);
    for (let v = Math.ceil(row.min / step - 1e-9) * step; v <= row.max + 1e-9; v += step) {
      const y = this.heightOf(band, v);
      context.fillStyle = theme.grid;
      context.fillRect(plotGutter.left, y - 0.5, this.room(), 1);
      context.fillStyle = theme.faint;
      context.fillText(`${+v.toFixed(2)}`, plotGutter.left - 6, y);
    }
    context.textAlign = 'left';
    let x = plotGutter.left;
    const y = top - 7;
    const word = (text: string, color: string): void => {
      context.fillStyle = color;
      context.fillText(text, x, y);
      x += context.measureText(text).width + 8;
    };
    word(`${row.title} [${row.unit}]`, theme.ink);
    const key = (name: string, color: string, dash: number[]): void => {
      if (x + 40 + context.measureText(name).width > this.width) return;
      context.save();
      context.strokeStyle = color;
      context.lineWidth = 2;
      context.setLineDash(dash);
      context.beginPath();
      context.moveTo(x, y);
      context.lineTo(x + 16, y);
      context.stroke();
      context.restore();
      x += 20;
      word(name, theme.faint);
    };
    for (const { name, color } of row.curves) key(name, color, []);
    for (const { name, value, color } of row.levels) if (Number.isFinite(value)) key(name, color, [4, 4]);
    if (row.title === 'Speed') key('planned', theme.prediction, [5, 3]);
  }

  private heightOf({ row, top, height }: Band, value: number): number {
    const share = (Math.min(Math.max(value, row.min), row.max) - row.min) / (row.max - row.min);
    return top + (1 - share) * height;
  }

  private level(context: CanvasRenderingContext2D, band: Band, value: number, color: string): void {
    if (!Number.isFinite(value)) return;
    const y = this.heightOf(band, value);
    context.save();
    context.strokeStyle = color;
    context.globalAlpha = 0.7;
    context.setLineDash([4, 4]);
    context.beginPath();
    context.moveTo(plotGutter.left, y);
    context.lineTo(plotGutter.left + this.room(), y);
    context.stroke();
    context.restore();
  }

  private curve(
    context: CanvasRenderingContext2D, run: Run, band: Band, color: string, width: number,
    value: (index: number) => number | null,
  ): void {
    context.strokeStyle = color;
    context.lineWidth = width;
    context.lineJoin = 'round';
    context.beginPath();
    let drawing = false;
    for (let i = run.frameIndex(this.from); i < run.frames.length; ++i) {
      const { time } = run.frames[i]!;
      if (time > this.to) break;
      const v = time < this.from ? null : value(i);
      if (v === null) {
        drawing = false;
        continue;
      }
      const [x, y] = [this.column(time), this.heightOf(band, v)];
      if (drawing) context.lineTo(x, y);
      else context.moveTo(x, y);
      drawing = true;
    }
    context.stroke();
  }
}
