// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import type { Camera } from '../drawing/camera';
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
const PERIOD = 40; // least time between two messages of a drag [ms]

/** Limits calls to one per period; the last one is never lost. */
export function throttled<T extends unknown[]>(call: (...args: T) => void, period = PERIOD): (...args: T) => void {
  let waiting: T | null = null;
  let timer = 0;
  const fire = (): void => {
    timer = 0;
    if (!waiting) return;
    const args = waiting;
    waiting = null;
    timer = window.setTimeout(fire, period);
    call(...args);
  };
  return (...args) => {
    waiting = args;
    if (!timer) fire();
  };
}

function ring(context: CanvasRenderingContext2D, camera: Camera, at: Point, metres: number, color: string): void {
  const p = camera.toScreen(at);
  context.beginPath();
  context.arc(p.x, p.y, Math.max(metres * camera.scale, 2), 0, 2 * Math.PI);
  context.strokeStyle = color;
  context.lineWidth = 2;
  context.setLineDash([4, 4]);
  context.stroke();
  context.setLineDash([]);
}

function line(context: CanvasRenderingContext2D, camera: Camera, from: Point, to: Point, color: string): void {
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

/** Draws obstacles, or erases them and people. */
export class BrushTool implements Tool {
  radius = 0.15;
  private last: Point | null = null;
  private readonly paint: (to: Point) => void;

  constructor(
    private readonly viewer: Viewer,
    readonly hint: string,
    private readonly blocked: boolean,
    send: Send,
  ) {
    this.paint = throttled((to: Point) => {
      const from = this.last ?? to;
      this.last = to;
      send({ do: 'paint', from, to, radius: this.radius, blocked: this.blocked });
      if (!this.blocked) this.wipeBodies(to, send);
    });
  }

  down(at: Point): void {
    this.last = at;
    this.paint(at);
  }

  move(at: Point): void {
    this.paint(at);
  }

  up(at: Point): void {
    this.paint(at);
  }

  cancel(): void {
    this.last = null;
  }

  draw(context: CanvasRenderingContext2D, camera: Camera): void {
    const { hover, themes } = this.viewer;
    if (hover) ring(context, camera, hover, this.radius, this.blocked ? themes.current.ink : themes.current.limit);
  }

  private wipeBodies(at: Point, send: Send): void {
    const bodies = this.viewer.run?.frames.at(-1)?.bodies ?? [];
    const hit = bodies.findIndex((b) => Math.hypot(b.x - at.x, b.y - at.y) < Math.max(this.radius, b.radius / 2));
    if (hit >= 0) send({ do: 'remove_body', body: hit });
  }
}

/** Moves people by a drag, and adds one where there is none. */
export class PersonTool implements Tool {
  private body: number | null = null;
  private target: Point | null = null;
  private readonly walk: (target: Point) => void;

  constructor(
    private readonly viewer: Viewer,
    readonly hint: string,
    private readonly send: Send,
  ) {
    this.walk = throttled((target: Point) => {
      if (this.body !== null) send({ do: 'walk', body: this.body, x: target.x, y: target.y });
    });
  }

  down(at: Point): void {
    const bodies = this.viewer.run?.frames.at(-1)?.bodies ?? [];
    const reach = 14 / this.viewer.camera.scale;
    const hit = bodies.findIndex((b) => Math.hypot(b.x - at.x, b.y - at.y) < b.radius + reach);
    this.body = hit >= 0 ? hit : bodies.length;
    if (hit < 0) this.send({ do: 'walk', x: at.x, y: at.y });
  }

  move(at: Point): void {
    this.target = at;
    this.walk(at);
    this.viewer.invalidate();
  }

  up(at: Point): void {
    if (this.target) this.walk(at);
    this.target = null;
    this.viewer.invalidate();
  }

  cancel(): void {
    this.body = this.target = null;
  }

  draw(context: CanvasRenderingContext2D, camera: Camera): void {
    const body = this.body === null ? null : this.viewer.run?.frames.at(-1)?.bodies[this.body];
    if (!body || !this.target) return;
    line(context, camera, body, this.target, this.viewer.themes.current.body);
    ring(context, camera, this.target, body.radius, this.viewer.themes.current.body);
  }
}

