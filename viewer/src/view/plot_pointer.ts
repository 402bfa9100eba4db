// SPDX-License-Identifier: Apache-2.0
import { element, make } from '../page/dom';
import type { Viewer } from './viewer';

/** The pointer on the plots: a press goes to a time, and the values under the pointer are shown. */
export function listenToPlots(viewer: Viewer, canvas: HTMLCanvasElement): void {
  const values = element('plot-values');
  const at = (event: PointerEvent): { x: number; time: number } => {
    const box = canvas.getBoundingClientRect();
    const x = event.clientX - box.left;
    return { x, time: viewer.plots.timeAt(x) };
  };
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    viewer.onSeek(at(event).time);
  });
  canvas.addEventListener('pointermove', (event) => {
    const { x, time } = at(event);
    if (canvas.hasPointerCapture(event.pointerId)) viewer.onSeek(time);
    if (!viewer.run) return;
    values.replaceChildren(...viewer.plots.describe(viewer.run, viewer.selected, time).map((line) => make('div', {}, line)));
    values.hidden = false;
    const left = x + 14 + values.offsetWidth > canvas.clientWidth ? x - 14 - values.offsetWidth : x + 14;
    values.style.left = `${Math.max(left, 4)}px`;
  });
  canvas.addEventListener('pointerleave', () => { values.hidden = true; });
}
