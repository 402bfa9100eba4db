// SPDX-License-Identifier: Apache-2.0
import type { RobotFrame } from '../data/frame';
import type { Point, Pose } from '../data/geometry';
import type { Run } from '../data/run';
import { LEAST_ROBOT } from './bodies';
import type { Pen } from './pen';

const LABEL = '600 12px system-ui, sans-serif';

/** Draws names. Where they would overlap, the selected robot's comes first, then low numbers. */
export function drawNames(pen: Pen, poses: Pose[], robots: RobotFrame[], run: Run, selected: number): void {
  const { context, camera } = pen;
  // Names cover no robot.
  const taken: { x: number; y: number; half: number }[] = poses.map((pose) => ({
    ...camera.toScreen(pose), half: Math.max(pen.pixels(run.radius), LEAST_ROBOT) - 2 }));
  const order = [selected, ...poses.keys()].filter((i, at) => at === 0 || i !== selected);
  context.font = LABEL;
  for (const i of order) {
    const pose = poses[i];
    if (!pose || robots[i]?.absent) continue;
    const name = run.begin.robots[i]!.name;
    const p = camera.toScreen(pose);
    const away = Math.max(pen.pixels(run.radius), LEAST_ROBOT) + 9;
    const half = context.measureText(name).width / 2 + 3;
    // Above, below, right or left of the robot: where no other name or robot is.
    const spots = [[0, -away], [0, away], [away + half - 4, 0], [4 - away - half, 0]]
      .map(([dx, dy]) => ({ x: p.x + dx!, y: p.y + dy!, half }));
    const free = spots.find((spot) => !taken.some((t) => Math.abs(t.x - spot.x) < t.half + spot.half && Math.abs(t.y - spot.y) < 15));
    if (!free) continue;
    taken.push(free);
    label(pen, name, free.x, free.y);
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

/** Draws a note with a background at a point of the world; long notes have several lines. */
export function drawNote(pen: Pen, text: string, at: Point, tone: 'note' | 'fault' = 'note'): void {
  const { context, camera, theme } = pen;
  context.font = '600 12px system-ui, sans-serif';
  const lines = text.split('\n');
  const width = Math.max(...lines.map((line) => context.measureText(line).width)) + 14;
  const height = 16 * lines.length + 6;
  const p = camera.toScreen(at);
  const x = Math.min(Math.max(p.x + 12, 4), Math.max(camera.width - width - 4, 4));
  const above = p.y - height - 12;
  const y = Math.min(above < 4 ? p.y + 12 : above, camera.height - height - 4);
  context.save();
  context.globalAlpha = 0.94;
  context.fillStyle = tone === 'fault' ? theme.fault : theme.note;
  context.beginPath();
  context.rect(x, y, width, height);
  context.fill();
  context.globalAlpha = 1;
  context.fillStyle = theme.noteInk;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  lines.forEach((line, i) => context.fillText(line, x + 7, y + 11 + 16 * i));
  context.restore();
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
