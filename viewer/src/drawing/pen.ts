// SPDX-License-Identifier: Apache-2.0
import { type Point, type Pose, placed } from '../data/geometry';
import type { Camera } from './camera';
import type { Theme } from './theme';

const TAU = 2 * Math.PI;

/** Draws shapes in the world: positions and radii in metres, line widths in pixels. */
export class Pen {
  private frame: Pose | null = null; // frame of all positions; null for the world's

  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly camera: Camera,
    readonly theme: Theme,
  ) {}

  /** Calls `draw` with all positions given in `frame`, for example a robot's own frame. */
  within(frame: Pose | null, draw: () => void): void {
    this.frame = frame;
    draw();
    this.frame = null;
  }

  pixels(metres: number): number {
    return metres * this.camera.scale;
  }

  /** The position of a point on the canvas. */
  at(p: Point): Point {
    return this.camera.toScreen(this.frame ? placed(this.frame, p) : p);
  }

  /** Begins a path through these points. */
  trace(points: readonly Point[], close = false): void {
    this.context.beginPath();
    points.forEach((p, i) => {
      const at = this.at(p);
      if (i === 0) this.context.moveTo(at.x, at.y);
      else this.context.lineTo(at.x, at.y);
    });
    if (close) this.context.closePath();
  }

  /** Begins one path around several polygons, given in the frame `pose`. */
  polygons(pose: Pose, polygons: readonly [number, number][][]): void {
    this.context.beginPath();
    for (const polygon of polygons) {
      polygon.forEach(([x, y], i) => {
        const at = this.at(placed(pose, { x, y }));
        if (i === 0) this.context.moveTo(at.x, at.y);
        else this.context.lineTo(at.x, at.y);
      });
      this.context.closePath();
    }
  }

  /** Begins a path around a disc, which is enlarged if it would be too small to see. */
  disc(center: Point, radius: number): void {
    const at = this.at(center);
    this.context.beginPath();
    this.context.arc(at.x, at.y, Math.max(this.pixels(radius), 0.5), 0, TAU);
  }

  /** Begins one path around several discs, given in the frame `pose`. */
  discs(pose: Pose, discs: readonly (Point & { radius: number })[]): void {
    this.context.beginPath();
    for (const disc of discs) {
      const at = this.at(placed(pose, disc));
      const radius = this.pixels(disc.radius);
      this.context.moveTo(at.x + radius, at.y);
      this.context.arc(at.x, at.y, radius, 0, TAU);
    }
  }

  stroke(color: string, width: number, alpha = 1, dash: number[] = []): void {
    const { context } = this;
    context.save();
    context.strokeStyle = color;
    context.lineWidth = width;
    context.globalAlpha = alpha;
    context.lineJoin = 'round';
    context.lineCap = 'round';
    context.setLineDash(dash);
    context.stroke();
    context.restore();
  }

  fill(color: string, alpha = 1): void {
    const { context } = this;
    context.save();
    context.fillStyle = color;
    context.globalAlpha = alpha;
    context.fill();
    context.restore();
  }

  /** Draws an arrow from a position towards a heading; the tip is slightly beyond `length`. */
  arrow(from: Point, heading: number, length: number, color: string): void {
    const ahead = (distance: number, turn = 0): Point => ({
      x: from.x + distance * Math.cos(heading + turn),
      y: from.y + distance * Math.sin(heading + turn),
    });
    this.trace([from, ahead(length)]);
    this.stroke(color, 2);
    this.trace([ahead(0.72 * length, 0.28), ahead(1.08 * length), ahead(0.72 * length, -0.28)], true);
    this.fill(color);
  }
}
