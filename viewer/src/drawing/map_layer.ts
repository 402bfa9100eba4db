// SPDX-License-Identifier: Apache-2.0
import type { Point, Pose } from '../data/geometry';
import type { Grid } from '../data/grid';
import type { Camera } from './camera';
import type { Theme } from './theme';

/** Converts '#rrggbb' or '#rrggbbaa' to the memory format of an image. */
const pixel = (color: string): number => {
  const part = (at: number): number => parseInt(color.slice(at, at + 2) || 'ff', 16);
  return (part(7) << 24 | part(5) << 16 | part(3) << 8 | part(1)) >>> 0;
};

/** Colours of free, occupied and unknown cells. */
export type CellColors = (theme: Theme) => [string, string, string];

/** A map as an image of one pixel per cell, updated to any time and drawn through a camera. */
export class MapLayer {
  private readonly canvas = document.createElement('canvas');
  private grid: Grid | null = null;
  private cells = new Uint8Array(0);
  private applied = 0; // number of applied changes
  private theme: Theme | null = null;

  constructor(private readonly colors: CellColors) {}

  /** @param origin where the map's origin is drawn. */
  draw(
    context: CanvasRenderingContext2D, camera: Camera, grid: Grid, time: number, theme: Theme,
    origin: Pose = grid.frame.origin,
  ): void {
    this.bring(grid, time, theme);
    const { frame } = grid;
    context.save();
    // Cell (0, 0) is at the lower left; the image's first row is the lowest one.
    const at = camera.toScreen(origin);
    const pixels = frame.resolution * camera.scale;
    context.translate(at.x, at.y);
    context.rotate(-origin.heading);
    context.scale(pixels, -pixels);
    context.imageSmoothingEnabled = pixels * devicePixelRatio < 1;
    context.drawImage(this.canvas, 0, 0);
    context.restore();
  }

  /** The value of the cell that contains a point, as last drawn. */
  cellAt(p: Point): number | null {
    if (!this.grid) return null;
    const { origin, resolution, width, height } = this.grid.frame;
    const [dx, dy] = [p.x - origin.x, p.y - origin.y];
    const [c, s] = [Math.cos(origin.heading), Math.sin(origin.heading)];
    const [i, j] = [Math.floor((c * dx + s * dy) / resolution), Math.floor((c * dy - s * dx) / resolution)];
    return i >= 0 && j >= 0 && i < width && j < height ? this.cells[j * width + i] ?? null : null;
  }

  private bring(grid: Grid, time: number, theme: Theme): void {
    const other = grid !== this.grid;
    let until = other ? 0 : this.applied;
    const { changes } = grid;
    while (until < changes.length && changes[until]!.time <= time + 1e-9) ++until;
    while (until > 0 && changes[until - 1]!.time > time + 1e-9) --until;
    const fresh = other || until < this.applied;
    if (fresh) {
      this.grid = grid;
      this.cells = grid.cells.slice();
      this.applied = 0;
    }
    const first = this.applied;
    for (; this.applied < until; ++this.applied) this.apply(changes[this.applied]!.runs);
    if (fresh || theme !== this.theme) this.paint(theme);
    else for (let i = first; i < until; ++i) this.paintRuns(changes[i]!.runs, theme);
  }

  private apply(runs: number[]): void {
    const width = this.grid!.frame.width;
    for (let i = 0; i < runs.length; i += 4) {
      const start = runs[i]! * width + runs[i + 1]!;
      this.cells.fill(runs[i + 3]!, start, start + runs[i + 2]!);
    }
  }

  private paint(theme: Theme): void {
    this.theme = theme;
    const { width, height } = this.grid!.frame;
    this.canvas.width = width;
    this.canvas.height = height;
    const image = new ImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    const colors = this.colors(theme).map(pixel);
    for (let i = 0; i < pixels.length; ++i) pixels[i] = colors[this.cells[i]!] ?? 0;
    this.canvas.getContext('2d')!.putImageData(image, 0, 0);
  }

  private paintRuns(runs: number[], theme: Theme): void {
    const context = this.canvas.getContext('2d')!;
    const colors = this.colors(theme);
    for (let i = 0; i < runs.length; i += 4) {
      context.clearRect(runs[i + 1]!, runs[i]!, runs[i + 2]!, 1);
      context.fillStyle = colors[runs[i + 3]!]!;
      context.fillRect(runs[i + 1]!, runs[i]!, runs[i + 2]!, 1);
    }
  }
}
