// SPDX-License-Identifier: Apache-2.0
import { type Footprint, coveringRadius } from '../data/footprint';
import { make } from '../page/dom';

const SIDE = 150; // half of the picture [pixels]

/** A picture of a body with its heading to the right, in the disc around it. */
export class BodyPreview {
  readonly canvas = make('canvas', { width: `${2 * SIDE}`, height: `${2 * SIDE}`, role: 'img', class: 'preview' });

  draw(body: Footprint | null): void {
    const context = this.canvas.getContext('2d')!;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, 2 * SIDE, 2 * SIDE);
    this.canvas.setAttribute('aria-label', body ? describe(body) : 'No valid body');
    if (!body) return;
    const around = coveringRadius(body);
    const scale = 0.85 * SIDE / around;
    const style = getComputedStyle(document.documentElement);
    context.setTransform(scale, 0, 0, -scale, SIDE, SIDE); // y points up, as on the map
    context.strokeStyle = style.getPropertyValue('--faint');
    context.setLineDash([6 / scale, 6 / scale]);
    context.lineWidth = 2 / scale;
    context.beginPath();
    context.arc(0, 0, around, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
    context.fillStyle = style.getPropertyValue('--accent');
    const { discs, length, width, radius } = body;
    for (const { x, y, radius: r } of discs.length > 0 ? discs : length > 0 ? [] : [{ x: 0, y: 0, radius }]) {
      context.beginPath();
      context.arc(x, y, r, 0, 2 * Math.PI);
      context.fill();
    }
    if (discs.length === 0 && length > 0) context.fillRect(-length / 2, -width / 2, length, width);
    // The heading.
    const size = discs.length > 0 ? 0.5 * discs[0]!.radius : length > 0 ? Math.min(length, width) / 2 : radius;
    context.fillStyle = style.getPropertyValue('--panel');
    context.beginPath();
    for (const [x, y] of [[0.8, 0], [-0.5, -0.5], [-0.2, 0], [-0.5, 0.5]] as const) context.lineTo(x * size, y * size);
    context.fill();
  }
}

function describe({ length, width, radius, discs }: Footprint): string {
  if (discs.length > 0) return `${discs.length} discs`;
  return length > 0 ? `Rectangle of ${length} by ${width} m` : `Disc of radius ${radius} m`;
}
