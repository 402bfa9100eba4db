// SPDX-License-Identifier: Apache-2.0
import type { Frame } from '../data/frame';
import type { Run } from '../data/run';
import type { Camera } from './camera';

/** The driven path of a robot up to a frame; it grows and is not rebuilt. */
class Trail {
  private path = new Path2D();
  private first: Frame | null = null; // first frame of the path
  private next = 0; // next frame to add

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

/** Draws the driven paths of all robots: the past part strong, the rest faint. */
export class Trails {
  private readonly behind: Trail[] = [];
  private readonly whole: Trail[] = [];

  draw(
    context: CanvasRenderingContext2D, camera: Camera, run: Run, index: number, colors: string[],
  ): void {
    context.save();
    // From here on all coordinates are in the world, and widths in metres.
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
