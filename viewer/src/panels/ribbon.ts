// SPDX-License-Identifier: Apache-2.0
import type { Run } from '../data/run';
import { type Tone, robotWords } from '../data/words';
import { type Theme, toneColor } from '../drawing/theme';

interface Piece {
  label: string;
  tone: Tone;
  from: number;
  to: number;
}

/** The stretches of one status between two times. Adjacent frames of one status are one piece. */
export function statusPieces(run: Run, robot: number, from: number, to: number): Piece[] {
  const pieces: Piece[] = [];
  for (let i = run.frameIndex(from); i < run.frames.length; ++i) {
    const frame = run.frames[i]!;
    if (frame.time > to) break;
    const me = frame.robots[robot];
    if (!me || (me.status === null && !me.collided)) continue;
    const { label, tone } = robotWords(run, frame, robot);
    const end = run.frames[i + 1]?.time ?? frame.time;
    const last = pieces.at(-1);
    if (last?.label === label) last.to = end;
    else pieces.push({ label, tone, from: frame.time, to: end });
  }
  return pieces;
}

/** Draws the status over time: a colour, a hatching for what is not normal, and its name. */
export function drawRibbon(
  context: CanvasRenderingContext2D, pieces: Piece[], column: (time: number) => number,
  box: { left: number; right: number; height: number }, theme: Theme,
): void {
  const { left, right, height } = box;
  context.fillStyle = theme.grid;
  context.fillRect(left, 0, right - left, height);
  context.font = '600 11px system-ui, sans-serif';
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  for (const piece of pieces) {
    const x = Math.max(column(piece.from), left);
    const width = Math.min(column(piece.to), right) - x;
    if (width <= 0) continue;
    context.save();
    context.beginPath();
    context.rect(x, 0, width, height);
    context.clip();
    context.fillStyle = toneColor(piece.tone, theme);
    context.fillRect(x, 0, width, height);
    if (piece.tone !== 'good' && piece.tone !== 'done' && piece.tone !== 'idle') {
      hatch(context, x, width, height, piece.tone === 'bad' ? 5 : 9, theme);
    }
    if (context.measureText(piece.label).width + 10 < width) {
      const text = context.measureText(piece.label).width;
      context.fillStyle = toneColor(piece.tone, theme);
      context.fillRect(x + 2, 0, text + 6, height);
      context.fillStyle = theme.dark || piece.tone === 'idle' ? '#12161a' : '#ffffff';
      context.fillText(piece.label, x + 5, height / 2 + 0.5);
    }
    context.restore();
  }
}

function hatch(context: CanvasRenderingContext2D, x: number, width: number, height: number, step: number, theme: Theme): void {
  context.strokeStyle = theme.halo;
  context.lineWidth = 1.5;
  context.globalAlpha = 0.55;
  context.beginPath();
  for (let u = x - height; u < x + width; u += step) {
    context.moveTo(u, height);
    context.lineTo(u + height, 0);
  }
  context.stroke();
  context.globalAlpha = 1;
}
