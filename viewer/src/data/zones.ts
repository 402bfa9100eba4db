// SPDX-License-Identifier: Apache-2.0
import type { Point } from './geometry';

/** A region of the floor with a rule, as in C++'s Zone. */
export interface Zone {
  kind: 'keep_out' | 'speed_limit' | 'penalty' | 'preferred' | 'strip' | 'one_way';
  name: string;
  polygon: [number, number][];
  reference: 'contour' | 'centre';
  speed: number;
  weight: number;
  direction: number;
}

/** What a zone asks of a robot: everything but its place. */
export type Rule = Omit<Zone, 'name' | 'polygon'>;

export const zoneNames: Record<Zone['kind'], string> = {
  keep_out: 'Keep-out', speed_limit: 'Speed limit', penalty: 'Avoided', preferred: 'Preferred',
  strip: 'Strip', one_way: 'One way',
};

export const corners = (zone: { polygon: [number, number][] }): Point[] => zone.polygon.map(([x, y]) => ({ x, y }));

/** Whether a point lies inside a polygon. */
export function isInside(polygon: Point[], at: Point): boolean {
  let inside = false;
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length]!;
    if (a.y > at.y !== b.y > at.y && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  });
  return inside;
}

/** The polygon with one more corner, in the middle of its longest side. */
export function withCorner(polygon: Point[]): Point[] {
  const next = (i: number): Point => polygon[(i + 1) % polygon.length]!;
  const lengths = polygon.map((a, i) => Math.hypot(next(i).x - a.x, next(i).y - a.y));
  const at = lengths.indexOf(Math.max(...lengths));
  const [a, b] = [polygon[at]!, next(at)];
  return [...polygon.slice(0, at + 1), { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }, ...polygon.slice(at + 1)];
}
