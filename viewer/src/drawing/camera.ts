// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import type { GridFrame } from '../data/grid';

/** The part of the world that a canvas shows: x to the right, y up. Sizes are in CSS pixels. */
export class Camera {
  x = 0; // world point in the middle
  y = 0;
  scale = 20; // pixels per metre
  width = 1;
  height = 1;
  private least = 1;
  private fitted: { frame: GridFrame; automatic: boolean } | null = null;

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    if (this.fitted?.automatic) this.fit(this.fitted.frame);
  }

  toScreen(p: Point): Point {
    return {
      x: this.width / 2 + (p.x - this.x) * this.scale,
      y: this.height / 2 - (p.y - this.y) * this.scale,
    };
  }

  toWorld(p: Point): Point {
    return {
      x: this.x + (p.x - this.width / 2) / this.scale,
      y: this.y - (p.y - this.height / 2) / this.scale,
    };
  }

  /** Shows the whole map, also after the canvas changes its size. */
  fit(frame: GridFrame): void {
    const corners = gridCorners(frame);
    const xs = corners.map((c) => c.x);
    const ys = corners.map((c) => c.y);
    const [minX, maxX] = [Math.min(...xs), Math.max(...xs)];
    const [minY, maxY] = [Math.min(...ys), Math.max(...ys)];
    this.x = (minX + maxX) / 2;
    this.y = (minY + maxY) / 2;
    const margin = 16;
    const inside = (pixels: number) => Math.max(pixels - 2 * margin, 10);
    this.scale = Math.min(inside(this.width) / (maxX - minX), inside(this.height) / (maxY - minY));
    this.least = this.scale / 3;
    this.fitted = { frame, automatic: true };
  }

  /** Zooms so that the world point under `at` stays there. */
  zoom(factor: number, at: Point = { x: this.width / 2, y: this.height / 2 }): void {
    const fixed = this.toWorld(at);
    this.scale = Math.min(Math.max(this.scale * factor, this.least), 4000);
    const now = this.toWorld(at);
    this.x += fixed.x - now.x;
    this.y += fixed.y - now.y;
    this.byHand();
  }

  /** Shows a part of the world: the point in the middle, and pixels per metre. */
  look(x: number, y: number, scale: number): void {
    [this.x, this.y, this.scale] = [x, y, scale];
    this.byHand();
  }

  /** Moves a world point to the middle. */
  center(p: Point): void {
    [this.x, this.y] = [p.x, p.y];
    this.byHand();
  }

  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.byHand();
  }

  private byHand(): void {
    if (this.fitted) this.fitted.automatic = false;
  }
}

export function gridCorners(frame: GridFrame): Point[] {
  const width = frame.width * frame.resolution;
  const height = frame.height * frame.resolution;
  const [c, s] = [Math.cos(frame.origin.heading), Math.sin(frame.origin.heading)];
  return [[0, 0], [width, 0], [width, height], [0, height]].map(([u, v]) => ({
    x: frame.origin.x + c * u! - s * v!,
    y: frame.origin.y + s * u! + c * v!,
  }));
}
