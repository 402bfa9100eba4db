// SPDX-License-Identifier: Apache-2.0
import type { Point } from '../data/geometry';
import type { Camera } from '../drawing/camera';
import type { PointerTool } from './gestures';

const STEP = 16; // of an arrow key [pixels]
const FINE = 2; // with Shift

/**
 * The pointer of the keyboard: arrow keys move a cross over the map, Enter acts where it is as a
 * click would, and Shift + Enter begins and ends a drag.
 */
export class MapCursor {
  /** Its place in the world; null until the first arrow key. */
  at: Point | null = null;
  private dragging = false;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly camera: Camera,
    private readonly tool: () => PointerTool | null,
    private readonly clicked: (at: Point) => void,
    private readonly moved: (at: Point | null, text: string) => void,
  ) {
    canvas.addEventListener('keydown', (event) => this.key(event));
    canvas.addEventListener('blur', () => this.leave());
    canvas.addEventListener('pointerdown', () => this.leave());
  }

  /** Ends a drag without its effect. @return whether there was one. */
  cancel(): boolean {
    if (!this.dragging) return false;
    this.dragging = false;
    this.tool()?.cancel();
    return true;
  }

  draw(context: CanvasRenderingContext2D, ink: string, halo: string): void {
    if (!this.at) return;
    const p = this.camera.toScreen(this.at);
    for (const [color, width] of [[halo, 4], [ink, 1.75]] as const) {
      context.strokeStyle = color;
      context.lineWidth = width;
      context.beginPath();
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
        context.moveTo(p.x + 4 * dx, p.y + 4 * dy);
        context.lineTo(p.x + 14 * dx, p.y + 14 * dy);
      }
      context.stroke();
    }
  }

  private leave(): void {
    this.cancel();
    if (!this.at) return;
    this.at = null;
    this.moved(null, '');
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const direction = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (direction) this.move(direction[0]!, direction[1]!, event.shiftKey ? FINE : STEP);
    else if (event.key === 'Enter') this.act(event.shiftKey);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private move(dx: number, dy: number, step: number): void {
    const { camera } = this;
    const p = this.at ? camera.toScreen(this.at) : { x: camera.width / 2, y: camera.height / 2 };
    if (this.at) {
      p.x += dx * step;
      p.y += dy * step;
    }
    // The map follows a cross that would leave it.
    const margin = 24;
    const over = (value: number, size: number): number => Math.min(value - margin, 0) + Math.max(value - size + margin, 0);
    const [ox, oy] = [over(p.x, camera.width), over(p.y, camera.height)];
    if (ox !== 0 || oy !== 0) camera.pan(-ox, -oy);
    this.at = camera.toWorld({ x: p.x - ox, y: p.y - oy });
    if (this.dragging) this.tool()?.move(this.at);
    this.moved(this.at, '');
  }

  private act(drag: boolean): void {
    const { at } = this;
    const tool = this.tool();
    if (!at) return this.move(0, 0, 0);
    if (!tool) return this.clicked(at);
    if (drag && !this.dragging) {
      this.dragging = true;
      tool.down(at);
      return this.moved(at, 'Drag begun. Move with the arrow keys; Enter ends it, Escape cancels it.');
    }
    if (!this.dragging) tool.down(at);
    this.dragging = false;
    tool.up(at);
    this.moved(at, 'Done');
  }
}
