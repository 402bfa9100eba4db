// SPDX-License-Identifier: Apache-2.0
import { element, make } from '../page/dom';
import type { Viewer } from '../view/viewer';

interface PaneMessage {
  fairway: 'time';
  time: number;
}

/** Whether this page is the second one of a comparison, inside another page. */
export const isPane = (): boolean => window.parent !== window && location.hash === '#pane';

/** Lets the page that contains this one choose the time. */
export function followParent(seek: (time: number) => void): void {
  document.body.classList.add('pane');
  addEventListener('message', ({ source, data }: MessageEvent<PaneMessage>) => {
    if (source === window.parent && data?.fairway === 'time' && Number.isFinite(data.time)) seek(data.time);
  });
}

/** Shows a second report beside this one, at the same time. */
export function connectCompare(viewer: Viewer): void {
  const button = element('compare');
  const picker = make('input', { type: 'file', id: 'compare-file', accept: '.html', hidden: '' });
  const pane = make('iframe', { id: 'pane', title: 'The other run', sandbox: 'allow-scripts' });
  let sent = NaN;
  let url = '';
  const close = (): void => {
    pane.remove();
    URL.revokeObjectURL(url);
    url = '';
    document.body.classList.remove('comparing');
    button.textContent = 'Compare';
  };
  button.hidden = false;
  button.after(picker);
  button.addEventListener('click', () => (url ? close() : picker.click()));
  picker.addEventListener('change', async () => {
    const file = picker.files?.[0];
    picker.value = '';
    if (!file) return;
    const text = await file.text();
    if (!text.includes('<script id="run"')) return viewer.say(`${file.name} is no report of Fairway.`);
    url = URL.createObjectURL(new Blob([text], { type: 'text/html' }));
    pane.src = `${url}#pane`;
    pane.addEventListener('load', () => { sent = NaN; viewer.invalidate(); });
    element('stage').after(pane);
    document.body.classList.add('comparing');
    button.textContent = 'Close comparison';
    viewer.say(`${viewer.run?.begin.name ?? 'This run'} on the left, ${file.name} on the right, at the same time.`);
  });
  const drawn = viewer.onDrawn;
  viewer.onDrawn = () => {
    drawn();
    if (!url || viewer.time === sent) return;
    sent = viewer.time;
    pane.contentWindow?.postMessage({ fairway: 'time', time: sent } satisfies PaneMessage, '*');
  };
}
