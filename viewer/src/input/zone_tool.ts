// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import { type Rule, type Zone, corners, isInside, withCorner } from '../data/zones';
import type { Camera } from '../drawing/camera';
import type { Viewer } from '../view/viewer';
import { type Send, type Tool, line, ring } from './tools';

const REACH = 14; // of a corner [pixels]
const CLICK = 6; // longest drag that is a click [pixels]

/** What a drag changes: a corner or the whole of the chosen zone, or it makes a new one. */
type Drag = { part: 'corner'; index: number } | { part: 'whole' } | { part: 'new' };

/** Adds zones by a drag, chooses one by a click, and moves its corners or the whole of it. */
export class ZoneTool implements Tool {
  readonly hint = 'Drag to add a zone; click one to change it, then drag its corners or its inside';
  /** Of the next zone. */
  rule: Rule = { kind: 'keep_out', reference: 'contour', speed: 0.3, weight: 3, direction: 0 };
  /** The chosen zone has changed. */
  onChosen: () => void = () => {};
  private chosen: number | null = null;
  private drag: Drag | null = null;
  private from: Point = { x: 0, y: 0 };
  private to: Point = { x: 0, y: 0 };

  constructor(private readonly viewer: Viewer, private readonly send: Send) {}

  /** The chosen zone, as it is now. */
  get zone(): Zone | null {
    return this.chosen === null ? null : this.zones[this.chosen] ?? null;
  }

  /** Changes the rule of the chosen zone, or of the next one. */
  use(rule: Rule): void {
    this.rule = rule;
    if (this.zone) this.change(corners(this.zone));
  }

  remove(): void {
    if (this.chosen === null) return;
    this.send({ do: 'remove_zone', index: this.chosen });
    this.choose(null);
  }

  addCorner(): void {
    if (this.zone) this.change(withCorner(corners(this.zone)));
  }

  down(at: Point): void {
    [this.from, this.to] = [at, at];
    const polygon = this.zone ? corners(this.zone) : [];
    const reach = REACH / this.viewer.camera.scale;
    const index = polygon.findIndex((corner) => Math.hypot(corner.x - at.x, corner.y - at.y) < reach);
    if (index >= 0) this.drag = { part: 'corner', index };
    else this.drag = { part: isInside(polygon, at) ? 'whole' : 'new' };
  }

  move(at: Point): void {
    this.to = at;
    this.viewer.invalidate();
  }

  up(at: Point): void {
    this.to = at;
    const { drag } = this;
    const polygon = this.dragged();
    this.drag = null;
    this.viewer.invalidate();
    const length = Math.hypot(this.to.x - this.from.x, this.to.y - this.from.y) * this.viewer.camera.scale;
    if (length <= CLICK) this.pick(at);
    else if (drag?.part === 'new') this.add(polygon);
    else this.change(polygon);
  }

  cancel(): void {
    this.drag = null;
    this.choose(null);
  }

  draw(context: CanvasRenderingContext2D, camera: Camera): void {
    const ink = this.viewer.themes.current.ink;
    const polygon = this.drag ? this.dragged() : this.zone ? corners(this.zone) : [];
    polygon.forEach((corner, i) => {
      line(context, camera, corner, polygon[(i + 1) % polygon.length]!, ink);
      if (this.zone) ring(context, camera, corner, 5 / camera.scale, ink);
    });
  }

  private get zones(): Zone[] {
    return this.viewer.run?.zonesAt(Infinity) ?? [];
  }

  private choose(index: number | null): void {
    this.chosen = index;
    const { zone } = this;
    if (zone) {
      const { kind, reference, speed, weight, direction } = zone;
      // What the kind does not use is kept from before.
      this.rule = { kind, reference, speed: speed || this.rule.speed, weight: weight || this.rule.weight, direction };
    }
    this.onChosen();
    this.viewer.invalidate();
  }

  private pick(at: Point): void {
    const index = this.zones.findLastIndex((zone) => isInside(corners(zone), at));
    this.choose(index >= 0 ? index : null);
  }

  // The polygon that the drag would give.
  private dragged(): Point[] {
    const { from, to, drag } = this;
    if (drag?.part === 'new') return [from, { x: to.x, y: from.y }, to, { x: from.x, y: to.y }];
    const polygon = this.zone ? corners(this.zone) : [];
    const shifted = (p: Point): Point => ({ x: p.x + to.x - from.x, y: p.y + to.y - from.y });
    return polygon.map((p, i) => (drag?.part === 'whole' || (drag?.part === 'corner' && drag.index === i) ? shifted(p) : p));
  }

  private add(polygon: Point[]): void {
    const index = this.zones.length;
    this.send({ do: 'zone', zone: this.message(polygon) });
    this.choose(index); // it arrives with the next records
  }

  private change(polygon: Point[]): void {
    if (this.chosen !== null) this.send({ do: 'zone', index: this.chosen, zone: this.message(polygon) });
  }

  private message(polygon: Point[]): Record<string, unknown> {
    const { kind, reference, speed, weight, direction } = this.rule;
    const zone: Record<string, unknown> = { kind, polygon };
    if (kind === 'keep_out' || kind === 'speed_limit' || kind === 'strip') zone.reference = reference;
    if (kind === 'speed_limit') zone.speed = speed;
    if (kind === 'penalty' || kind === 'preferred') zone.weight = weight;
    if (kind === 'one_way') zone.direction = direction;
    return zone;
  }
}
