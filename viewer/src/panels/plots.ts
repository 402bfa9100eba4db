// SPDX-License-Identifier: Apache-2.0
import { separation } from '../data/footprint';
import type { Run } from '../data/run';
import { type Theme, robotColor, statusTone, toneColor } from '../drawing/theme';

/** Space left and right of the plots for axes; the time slider above them has the same. */
export const plotGutter = { left: 46, right: 14 };

const RIBBON = 10;
const GAP = 13;
const AXIS = 18;
const LEAST_ROW = 16;
const FAR = 2; // largest measured clearance [m]

interface Row {
  top: number;
  height: number;
  min: number;
  max: number;
}

const niceStep = (span: number, count: number): number => {
  const raw = span / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  const unit = [1, 2, 5, 10].find((n) => n * power >= raw) ?? 10;
  return unit * power;
};

/** Status, speed and distances of one robot over time. */
export class Plots {
  private readonly still = document.createElement('canvas'); // everything except the cursor
  private key = '';
  private width = 0; // of the drawn plots
  private from = 0;
  private to = 1;

  constructor(private readonly canvas: HTMLCanvasElement) {}

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
    const key = [width, height, ratio, run.frames.length, robot, from, to, theme.dark].join();
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
    const x = this.column(time);
    context.strokeStyle = theme.ink;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, height - AXIS);
    context.stroke();
  }

  private room(): number {
    return Math.max(this.width - plotGutter.left - plotGutter.right, 1);
  }

  private column(time: number): number {
    return plotGutter.left + (time - this.from) / (this.to - this.from) * this.room();
  }

  private drawStill(
    context: CanvasRenderingContext2D, run: Run, robot: number, width: number, height: number,
    theme: Theme,
  ): void {
    context.clearRect(0, 0, width, height);
    const each = (height - AXIS - RIBBON - 2 * GAP) / 2;
    this.ribbon(context, run, robot, theme);
    this.times(context, height - AXIS, theme);
    if (each < LEAST_ROW) return; // a small screen has space for the status only
    const most = run.setting('robot', 'linear_max') || 1;
    const least = Math.min(0, run.setting('robot', 'linear_min') || 0);
    const speed: Row = { top: RIBBON + GAP, height: each, min: least * 1.1, max: most * 1.15 };
    const room: Row = { top: RIBBON + 2 * GAP + each, height: each, min: 0, max: FAR };
    const name = (text: string, row: Row): void => this.frame(context, row, text, theme);
    name('speed [m/s]', speed);
    name('room [m]', room);
    const color = robotColor(robot, theme);
    this.level(context, speed, most, theme.limit);
    this.level(context, room, run.setting('prediction', 'obstacle_margin'), theme.body);
    const { body } = run;
    const cycle = (i: number) => run.frames[i]!.robots[robot]?.cycle;
    this.curve(context, run, speed, theme.faint, 1, (i) => cycle(i)?.commandLinear ?? null);
    this.curve(context, run, speed, color, 1.75, (i) => cycle(i)?.linear ?? null);
    this.curve(context, run, room, color, 1.75, (i) => cycle(i)?.clearance ?? null);
    this.curve(context, run, room, theme.body, 1.5, (i) => {
      const gap = separation(run.frames[i]!, robot, body);
      return gap <= FAR ? gap : null;
    });
  }

  private ribbon(context: CanvasRenderingContext2D, run: Run, robot: number, theme: Theme): void {
    context.fillStyle = theme.grid;
    context.fillRect(plotGutter.left, 0, this.room(), RIBBON);
    const { frames } = run;
    // Adjacent frames of one colour are one rectangle, because seams between them would be visible.
    let piece = null as { color: string; from: number; to: number } | null;
    const finish = (): void => {
      if (!piece) return;
      const x = Math.max(this.column(piece.from), plotGutter.left);
      context.fillStyle = piece.color;
      context.fillRect(x, 0, Math.min(this.column(piece.to), this.column(this.to)) - x, RIBBON);
    };
    for (let i = run.frameIndex(this.from); i < frames.length; ++i) {
      const frame = frames[i]!;
      if (frame.time > this.to) break;
      const me = frame.robots[robot];
      if (!me || (me.status === null && !me.collided)) continue;
      const color = me.collided ? theme.limit : toneColor(statusTone(me.status!), theme);
      const end = frames[i + 1]?.time ?? frame.time;
      if (piece?.color === color) piece.to = end;
      else {
        finish();
        piece = { color, from: frame.time, to: end };
      }
    }
    finish();
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
      context.fillText(text, Math.min(x, this.width - half - 2), top + 4);
    }
  }

  private frame(context: CanvasRenderingContext2D, row: Row, text: string, theme: Theme): void {
    context.font = '11px system-ui, sans-serif';
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    const step = niceStep(row.max - row.min, row.height / 24);
    for (let v = Math.ceil(row.min / step - 1e-9) * step; v <= row.max + 1e-9; v += step) {
      const y = this.height(row, v);
      context.fillStyle = theme.grid;
      context.fillRect(plotGutter.left, y - 0.5, this.room(), 1);
      context.fillStyle = theme.faint;
      context.fillText(`${+v.toFixed(2)}`, plotGutter.left - 6, y);
    }
    if (context.measureText(text).width > row.height + GAP) return;
    context.save();
    context.translate(9, row.top + row.height / 2);
    context.rotate(-Math.PI / 2);
    context.textAlign = 'center';
    context.fillStyle = theme.faint;
    context.fillText(text, 0, 0);
    context.restore();
  }

  private height(row: Row, value: number): number {
    const share = (Math.min(Math.max(value, row.min), row.max) - row.min) / (row.max - row.min);
    return row.top + (1 - share) * row.height;
  }

  private level(context: CanvasRenderingContext2D, row: Row, value: number, color: string): void {
    if (!Number.isFinite(value)) return;
    const y = this.height(row, value);
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
    context: CanvasRenderingContext2D, run: Run, row: Row, color: string, width: number,
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
      const [x, y] = [this.column(time), this.height(row, v)];
      if (drawing) context.lineTo(x, y);
      else context.moveTo(x, y);
      drawing = true;
    }
    context.stroke();
  }
}
