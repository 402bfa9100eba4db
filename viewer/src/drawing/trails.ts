// SPDX-License-Identifier: Apache-2.0
import type { Frame } from '../data/frame';
import type { Run } from '../data/run';
import type { Camera } from './camera';

/** The way of a robot up to a frame, as a path that grows instead of being made anew. */
class Trail {
  private path = new Path2D();
  private first: Frame | null = null; // where it begins
  private next = 0; // the frame to add next

  constructor(private readonly robot: number) {}

  upTo(run: Run, index: number): Path2D {
    if (this.first !== run.frames[0] || index + 1 < this.next) {
      this.path = new Path2D();
      this.first = run.frames[0] ?? null;
      this.next = 0;
    }
    for (; this.next <= index; ++this.next) {
      const at = run.frames[this.next]?.robots[this.robot];
      if (!at) continue;
      if (this.next === 0) this.path.moveTo(at.x, at.y);
      else this.path.lineTo(at.x, at.y);
    }
    return this.path;
  }
}

/** The ways of all robots: what lies behind them strong, all of it faint. */
export class Trails {
  private readonly behind: Trail[] = [];
  private readonly whole: Trail[] = [];

  draw(
    context: CanvasRenderingContext2D, camera: Camera, run: Run, index: number, colors: string[],
  ): void {
    context.save();
    // World coordinates from here on; widths are in metres too.
    const origin = camera.toScreen({ x: 0, y: 0 });
    context.translate(origin.x, origin.y);
    context.scale(camera.scale, -camera.scale);
    context.lineJoin = 'round';
    colors.forEach((color, robot) => {
      context.strokeStyle = color;
      context.globalAlpha = 0.22;
      context.lineWidth = 1.5 / camera.scale;
      context.stroke((this.whole[robot] ??= new Trail(robot)).upTo(run, run.frames.length - 1));
      context.globalAlpha = 0.9;
      context.lineWidth = 2.25 / camera.scale;
      context.stroke((this.behind[robot] ??= new Trail(robot)).upTo(run, index));
    });
    context.restore();
  }
}
