// SPDX-License-Identifier: Apache-2.0
import { type Zone, corners as cornersOf } from '../data/zones';
import type { Pen } from './pen';

const looks: Record<Zone['kind'], { text: (zone: Zone) => string; dash: number[]; strength: number }> = {
  keep_out: { text: () => 'keep-out', dash: [], strength: 0.16 },
  speed_limit: { text: ({ speed }) => `at most ${speed} m/s`, dash: [8, 4], strength: 0.08 },
  penalty: { text: () => 'avoided', dash: [3, 4], strength: 0.08 },
  preferred: { text: () => 'preferred', dash: [3, 4], strength: 0.08 },
  strip: { text: () => 'strip', dash: [10, 3, 2, 3], strength: 0.05 },
  one_way: { text: () => 'one way', dash: [8, 4], strength: 0.08 },
};

/** Draws the zones of the floor: outline, rule, and the direction of a one-way zone. */
export function drawZones(pen: Pen, zones: Zone[]): void {
  const { context, theme } = pen;
  for (const zone of zones) {
    const look = looks[zone.kind];
    const corners = cornersOf(zone);
    const color = zone.kind === 'keep_out' ? theme.fault : theme.tracked;
    pen.trace(corners, true);
    pen.fill(color, look.strength);
    pen.stroke(color, 1.5, 0.9, look.dash);
    const middle = { x: 0, y: 0 };
    for (const { x, y } of corners) {
      middle.x += x / corners.length;
      middle.y += y / corners.length;
    }
    if (zone.kind === 'one_way') pen.arrow(middle, zone.direction, 28 / pen.camera.scale, color);
    const text = look.text(zone);
    const p = pen.at(middle);
    context.font = '600 11px system-ui, sans-serif';
    // Only where there is space for it.
    const width = Math.max(...corners.map((c) => pen.at(c).x)) - Math.min(...corners.map((c) => pen.at(c).x));
    if (context.measureText(text).width + 6 > width) continue;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.lineWidth = 3;
    context.strokeStyle = theme.halo;
    context.strokeText(text, p.x, p.y);
    context.fillStyle = color;
    context.fillText(text, p.x, p.y);
  }
}
