// SPDX-License-Identifier: Apache-2.0
import type { Pose } from '../data/geometry';
import type { Run } from '../data/run';
import { LEAST_ROBOT } from './bodies';
import type { Pen } from './pen';

const LABEL = '600 12px system-ui, sans-serif';

/** Draws names. Where they would overlap, the selected robot's comes first, then low numbers. */
export function drawNames(pen: Pen, poses: Pose[], run: Run, selected: number): void {
  const { context, camera } = pen;
  const taken: { x: number; y: number; half: number }[] = [];
  const order = [selected, ...poses.keys()].filter((i, at) => at === 0 || i !== selected);
  context.font = LABEL;
  for (const i of order) {
    const pose = poses[i];
    if (!pose) continue;
    const name = run.begin.robots[i]!.name;
    const p = camera.toScreen(pose);
    const spot = { x: p.x, y: p.y - Math.max(pen.pixels(run.radius), LEAST_ROBOT) - 9, half: context.measureText(name).width / 2 + 3 };
    const covered = taken.some((t) => Math.abs(t.x - spot.x) < t.half + spot.half && Math.abs(t.y - spot.y) < 15);
    if (covered) continue;
    taken.push(spot);
    label(pen, name, spot.x, spot.y);
  }
}

function label({ context, theme }: Pen, text: string, x: number, y: number): void {
  context.font = LABEL;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = theme.halo;
  context.strokeText(text, x, y);
  context.fillStyle = theme.ink;
  context.fillText(text, x, y);
}

/** Draws a scale bar in metres at the lower left. */
export function drawScaleBar(pen: Pen): void {
  const { context, camera, theme } = pen;
  const lengths = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
  const metres = lengths.filter((m) => pen.pixels(m) <= 130).at(-1) ?? 0.1;
  const [x, y] = [16, camera.height - 16];
  context.fillStyle = theme.outside;
  context.globalAlpha = 0.75;
  context.fillRect(x - 8, y - 22, pen.pixels(metres) + 16, 32);
  context.globalAlpha = 1;
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + pen.pixels(metres), y);
  context.lineTo(x + pen.pixels(metres), y - 4);
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  context.stroke();
  context.font = '12px system-ui, sans-serif';
  context.textAlign = 'left';
  context.textBaseline = 'bottom';
  context.fillStyle = theme.ink;
  context.fillText(`${metres} m`, x + 3, y - 3);
}
