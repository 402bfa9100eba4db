// SPDX-License-Identifier: Apache-2.0
import { element, make } from '../page/dom';
import { recalled, remember } from '../page/memory';
import { type Action, closePopovers, popover } from '../page/popovers';
import type { Viewer } from '../view/viewer';
import type { Transport } from './playback';
import { connectShare } from './share';
import type { Toolbar } from './toolbar';

const help: [string, string][] = [
  ['Space', 'play or pause'], ['← →', 'one step'], ['Shift ← →', 'one second'],
  ['Home End', 'start, end'], ['+ −', 'zoom'], ['F', 'show the whole map'],
  ['W A S D', 'move the map'], ['C', 'follow the robot'], ['1 to 9', 'choose a robot'], ['L', 'layers'],
  ['T', 'light or dark'], ['?', 'this list'], ['Escape', 'close, cancel, pan'],
  ['↑ ↓ ← →', 'on the map: move the cursor (Shift: finely)'], ['Enter', 'on the map: click at the cursor'],
  ['Shift Enter', 'on the map: begin or end a drag'],
  ['wheel pinch', 'zoom'], ['drag', 'move the map'], ['click', 'choose a robot, or a time'],
];

/** All keys of both pages. */
export function listenToKeys(
  viewer: Viewer, transport: Transport, toolbar: Toolbar,
): void {
  const extraHelp = toolbar.help;
  const extra = toolbar.keys;
  const rows = [...help, ...extraHelp];
  element('help').append(make('table', {}, ...rows.map(([key, what]) =>
    make('tr', {}, make('td', {}, ...key.split(' ').flatMap((k) => [make('kbd', {}, k), ' '])),
      make('td', {}, what)))));
  const letters = make('input', { type: 'checkbox', id: 'letters' });
  letters.checked = recalled('letters') !== 'off';
  letters.addEventListener('change', () => remember('letters', letters.checked ? 'on' : 'off'));
  element('help').prepend(make('label', {}, letters, 'Single-key shortcuts'));
  const toggleHelp = popover('show-help', 'help');
  const toggleLayers = popover('show-layers', 'layers');
  const redraw = (change: Action): Action => () => { change(); viewer.invalidate(); };
  const pan = (dx: number, dy: number): Action => redraw(() => viewer.camera.pan(dx, dy));
  const actions: Record<string, Action> = {
    ' ': () => transport.toggle(),
    ArrowLeft: () => transport.step(-1),
    ArrowRight: () => transport.step(1),
    'Shift+ArrowLeft': () => transport.seek(viewer.time - 1),
    'Shift+ArrowRight': () => transport.seek(viewer.time + 1),
    Home: () => transport.start(),
    End: () => transport.end(),
    '+': redraw(() => viewer.camera.zoom(1.3)),
    '=': redraw(() => viewer.camera.zoom(1.3)),
    '-': redraw(() => viewer.camera.zoom(1 / 1.3)),
    f: () => viewer.fit(),
    '0': () => viewer.fit(),
    w: pan(0, 60), s: pan(0, -60), a: pan(60, 0), d: pan(-60, 0),
    l: toggleLayers,
    t: () => viewer.themes.toggle(),
    '?': toggleHelp,
    c: () => viewer.setFollow(!viewer.follow),
    Escape: () => { if (!closePopovers()) toolbar.escape(); },
    ...extra,
  };
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as HTMLElement;
    const types = target.matches('input:not([type=range]):not([type=checkbox]), select, textarea');
    if (types && event.key === 'Escape') return closePopovers() ? undefined : target.blur();
    if (types || (event.key === ' ' && target.matches('button, summary'))) return;
    // The time slider's own keys would move it too little.
    const moves = event.key.startsWith('Arrow') || event.key === 'Home' || event.key === 'End';
    if (moves && target.matches('input[type=range]') && target.id !== 'time') return;
    if (event.key.length === 1 && event.key !== ' ' && !letters.checked) return;
    const digit = Number(event.key);
    if (digit >= 1 && viewer.run && digit <= viewer.run.begin.robots.length) viewer.select(digit - 1);
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = actions[event.shiftKey && moves ? `Shift+${name}` : name];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

/** The other buttons of both pages. */
export function connectButtons(viewer: Viewer): void {
  const zoom = (factor: number) => () => { viewer.camera.zoom(factor); viewer.invalidate(); };
  element('zoom-in').addEventListener('click', zoom(1.3));
  element('zoom-out').addEventListener('click', zoom(1 / 1.3));
  element('fit').addEventListener('click', () => viewer.fit());
  element('follow').addEventListener('click', () => viewer.setFollow(!viewer.follow));
  connectShare(viewer);
  popover('show-menu', 'menu');
  element('theme').addEventListener('click', () => viewer.themes.toggle());
  const panel = element('panel');
  const plots = element('show-plots');
  plots.addEventListener('click', () => {
    const hidden = document.body.classList.toggle('no-plots');
    plots.setAttribute('aria-expanded', `${!hidden}`);
  });
  element('show-panel').addEventListener('click', (event) => {
    panel.hidden = !panel.hidden;
    (event.currentTarget as HTMLElement).setAttribute('aria-expanded', `${!panel.hidden}`);
  });
  element('print').addEventListener('click', () => print());
  addEventListener('beforeprint', () => viewer.print(true));
  addEventListener('afterprint', () => viewer.print(false));
}
