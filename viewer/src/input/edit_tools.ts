// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import type { Camera } from '../drawing/camera';
import type { Viewer } from '../view/viewer';
import { throttled } from '../page/throttle';
import { type Send, type Tool, line, ring } from './tools';

const PERIOD = 40; // least time between two messages of a drag [ms]

let strokes = 0; // parts of one stroke are undone together

/** Draws obstacles, or erases them and people. */
export class BrushTool implements Tool {
  radius = 0.15;
  private last: Point | null = null;
  private stroke = 0;
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
      send({ do: 'paint', from, to, radius: this.radius, blocked: this.blocked, stroke: this.stroke });
      if (!this.blocked) this.wipeBodies(to, send);
    }, PERIOD);
  }

  down(at: Point): void {
    this.stroke = 1 + (Date.now() + strokes++) % 99_999;
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
    if (hover) ring(context, camera, hover, this.radius, this.blocked ? themes.current.ink : themes.current.fault);
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
    }, PERIOD);
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

