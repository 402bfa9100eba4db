// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import type { Camera } from '../drawing/camera';
import { drawNote } from '../drawing/lettering';
import { Pen } from '../drawing/pen';
import { robotColor } from '../drawing/theme';
import type { PointerTool } from '../view/gestures';
import type { Viewer } from '../view/viewer';

export type Send = (command: Record<string, unknown>) => void;

/** A tool that also draws a preview of its action. */
export interface Tool extends PointerTool {
  readonly hint: string;
  draw(context: CanvasRenderingContext2D, camera: Camera): void;
}

const DRAG = 14; // a longer drag sets a heading [pixels]

export function ring(context: CanvasRenderingContext2D, camera: Camera, at: Point, metres: number, color: string): void {
  const p = camera.toScreen(at);
  context.beginPath();
  context.arc(p.x, p.y, Math.max(metres * camera.scale, 2), 0, 2 * Math.PI);
  context.strokeStyle = color;
  context.lineWidth = 2;
  context.setLineDash([4, 4]);
  context.stroke();
  context.setLineDash([]);
}

export function line(context: CanvasRenderingContext2D, camera: Camera, from: Point, to: Point, color: string): void {
  const [a, b] = [camera.toScreen(from), camera.toScreen(to)];
  context.beginPath();
  context.moveTo(a.x, a.y);
  context.lineTo(b.x, b.y);
  context.strokeStyle = color;
  context.lineWidth = 2;
  context.setLineDash([5, 4]);
  context.stroke();
  context.setLineDash([]);
}

/** Selects a position by a click, with a heading by a drag. */
export class PlaceTool implements Tool {
  private from: Point | null = null;
  private to: Point | null = null;

  constructor(
    private readonly viewer: Viewer,
    readonly hint: string,
    private readonly done: (at: Point, heading: number | null) => void,
  ) {}

  down(at: Point): void {
    [this.from, this.to] = [at, at];
  }

  move(at: Point): void {
    this.to = at;
    this.viewer.invalidate();
  }

  up(at: Point): void {
    const from = this.from;
    this.to = at;
    const heading = this.heading();
    this.cancel();
    if (from) this.done(from, heading);
  }

  cancel(): void {
    this.from = this.to = null;
    this.viewer.invalidate();
  }

  draw(context: CanvasRenderingContext2D, camera: Camera): void {
    if (!this.from || !this.to) return;
    const color = robotColor(this.viewer.selected, this.viewer.themes.current);
    ring(context, camera, this.from, this.viewer.run?.radius ?? 0.25, color);
    if (this.heading() !== null) line(context, camera, this.from, this.to, color);
  }

  private heading(): number | null {
    if (!this.from || !this.to) return null;
    const [dx, dy] = [this.to.x - this.from.x, this.to.y - this.from.y];
    return Math.hypot(dx, dy) * this.viewer.camera.scale > DRAG ? Math.atan2(dy, dx) : null;
  }
}

/** Measures the distance and the direction between two points of the map. */
export class MeasureTool implements Tool {
  readonly hint = 'Drag to measure a distance';
  private from: Point | null = null;
  private to: Point | null = null;

  constructor(private readonly viewer: Viewer) {}

  down(at: Point): void {
    [this.from, this.to] = [at, at];
    this.viewer.invalidate();
  }

  move(at: Point): void {
    this.to = at;
    this.viewer.invalidate();
  }

  // The result remains until the next measurement.
  up(at: Point): void {
    this.to = at;
    this.viewer.say(this.text());
    this.viewer.invalidate();
  }

  cancel(): void {
    this.from = this.to = null;
    this.viewer.invalidate();
  }

  draw(context: CanvasRenderingContext2D, camera: Camera): void {
    if (!this.from || !this.to) return;
    const theme = this.viewer.themes.current;
    line(context, camera, this.from, this.to, theme.ink);
    ring(context, camera, this.from, 0, theme.ink);
    ring(context, camera, this.to, 0, theme.ink);
    drawNote(new Pen(context, camera, theme), this.text(), this.to);
  }

  private text(): string {
    const [dx, dy] = [this.to!.x - this.from!.x, this.to!.y - this.from!.y];
    return `${Math.hypot(dx, dy).toFixed(2)} m, ${(Math.atan2(dy, dx) * 180 / Math.PI).toFixed(0)}°`;
  }
}
