// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import type { Camera } from '../drawing/camera';

/** The reaction of a tool to a pointer on the map; world coordinates. */
export interface PointerTool {
  down(at: Point): void;
  move(at: Point): void;
  up(at: Point): void;
  cancel(): void;
}

const CLICK = 5; // largest movement of a click [pixels]

/** Panning, pinching and wheel zoom on the map; an active tool receives single pointers. */
export class Gestures {
  tool: PointerTool | null = null;
  private readonly pointers = new Map<number, Point>();
  private moved = 0;
  private busy = false; // the tool handles the pointer

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly camera: Camera,
    private readonly changed: () => void,
    private readonly clicked: (at: Point) => void,
    private readonly panned: () => void,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.lost(event));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
  }

  private at(event: PointerEvent | WheelEvent): Point {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, this.at(event));
    if (this.pointers.size === 1) {
      this.moved = 0;
      // The middle and right buttons always pan.
      if (this.tool && event.button === 0) {
        this.busy = true;
        this.tool.down(this.camera.toWorld(this.at(event)));
      }
    } else if (this.busy) {
      this.busy = false;
      this.tool?.cancel();
    }
  }

  private move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    const now = this.at(event);
    if (!before) return;
    if (this.busy) {
      this.tool?.move(this.camera.toWorld(now));
      this.pointers.set(event.pointerId, now);
      return;
    }
    if (this.pointers.size === 1) {
      this.moved += Math.hypot(now.x - before.x, now.y - before.y);
      if (this.moved > CLICK) {
        this.panned();
        this.camera.pan(now.x - before.x, now.y - before.y);
      }
    } else if (this.pointers.size === 2) {
      this.moved = Infinity;
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)![1];
      const middle = { x: (now.x + other.x) / 2, y: (now.y + other.y) / 2 };
      const span = (p: Point): number => Math.hypot(p.x - other.x, p.y - other.y);
      this.camera.zoom(span(now) / Math.max(span(before), 1), middle);
      this.camera.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    }
    this.pointers.set(event.pointerId, now);
    this.changed();
  }

  private up(event: PointerEvent): void {
    const known = this.pointers.delete(event.pointerId);
    if (!known) return;
    const at = this.camera.toWorld(this.at(event));
    if (this.busy) {
      this.busy = false;
      this.tool?.up(at);
    } else if (this.moved <= CLICK && this.pointers.size === 0 && event.button === 0) {
      this.clicked(at);
    }
  }

  private lost(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    if (this.busy) this.tool?.cancel();
    this.busy = false;
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    this.camera.zoom(Math.exp(-event.deltaY * lines * 0.0015), this.at(event));
    this.changed();
  }
}
