// SPDX-License-Identifier: Apache-2.0
import type { Run } from '../data/run';
import type { Zone } from '../data/zones';
import { layerNames, type Layer } from '../drawing/layers';
import { toneColor } from '../drawing/theme';
import { statusLegend } from '../data/words';
import { element, make } from '../page/dom';
import { plotNames, type PlotName } from '../panels/plot_rows';
import { recalled, remember } from '../page/memory';
import type { Viewer } from './viewer';

/** The popover with layers, plots and the meaning of all marks and colours. */
export class Legend {
  private readonly map = make('div', { class: 'legend' });
  private readonly status = make('div', { class: 'legend' });
  private zones: Zone[] | null = null; // as last seen

  constructor(private readonly viewer: Viewer) {
    const root = element('layers');
    const layers = make('fieldset', {}, make('legend', {}, 'Layers'));
    for (const [layer, title] of Object.entries(layerNames)) {
      const box = make('input', { type: 'checkbox', 'data-layer': layer });
      box.checked = viewer.layers[layer as Layer];
      box.addEventListener('change', () => {
        viewer.layers[layer as Layer] = box.checked;
        viewer.invalidate();
      });
      layers.append(make('label', {}, box, title));
    }
    root.append(layers, this.plots(), make('fieldset', {}, make('legend', {}, 'Map'), this.map),
      make('fieldset', {}, make('legend', {}, 'Status band'), this.status));
    viewer.onLook = () => this.update();
    this.update();
  }

  /** Sets the layers, for example from a link. */
  use(names: string[]): void {
    for (const box of element('layers').querySelectorAll<HTMLInputElement>('[data-layer]')) {
      box.checked = names.includes(box.dataset.layer!);
      this.viewer.layers[box.dataset.layer as Layer] = box.checked;
    }
    this.viewer.invalidate();
  }

  /** The first zone of a run brings the layer of the zones. */
  follow(run: Run): void {
    const zones = run.zonesAt(Infinity);
    if (zones !== this.zones) this.update();
    this.zones = zones;
  }

  private plots(): HTMLElement {
    const chosen = recalled('plots')?.split(',').filter((name) => name in plotNames) as PlotName[] | undefined;
    if (chosen) this.viewer.plots.names = chosen;
    const set = make('fieldset', {}, make('legend', {}, 'Plots'));
    const boxes: HTMLInputElement[] = [];
    for (const [name, title] of Object.entries(plotNames)) {
      const box = make('input', { type: 'checkbox', 'data-plot': name });
      box.checked = this.viewer.plots.names.includes(name as PlotName);
      box.addEventListener('change', () => {
        this.viewer.plots.names = boxes.filter((b) => b.checked).map((b) => b.dataset.plot as PlotName);
        remember('plots', this.viewer.plots.names.join());
        this.resize();
      });
      boxes.push(box);
      set.append(make('label', {}, box, title));
    }
    this.resize();
    return set;
  }

  // The plots take as much height as they need, and less on small screens (page.css).
  private resize(): void {
    const { names } = this.viewer.plots;
    element('plots').style.setProperty('--rows', `${names.length}`);
    this.viewer.invalidate();
  }

  private update(): void {
    const { viewer } = this;
    const theme = viewer.themes.current;
    const lidar = viewer.run?.lidar ?? false;
    const entries: [string, string, string?][] = [
      ['Path', theme.path, 'dashed'], ['Active rectangle', theme.current], ['Prediction', theme.prediction],
      ['Moving obstacle (clearance)', theme.body], ['Active constraint', theme.limit], ['Trail', theme.faint, 'thin'],
    ];
    if (lidar) entries.push(['True wall, drawn over the corridor', theme.occupied], ['Lidar points', theme.scan], ['Mapped obstacle', theme.believed], ['Tracked object', theme.tracked, 'dashed']);
    const marks = (): HTMLElement[] => entries.map(([text, color, kind]) => {
      const mark = make('i', kind ? { class: kind } : {});
      mark.style.borderTopColor = color;
      return make('span', {}, mark, text);
    });
    element('legend').replaceChildren(...marks());
    this.map.replaceChildren(...marks(), make('span', { class: 'meaning' }, 'Dashed circles: a moving obstacle in one second, and a robot at the end of its prediction.'),
      ...(lidar ? [make('span', { class: 'meaning' }, 'The corridor of a robot with a lidar crosses walls that it has not seen yet.')] : []));
    this.status.replaceChildren(...(viewer.run ? statusLegend(viewer.run) : []).map(([tone, text]) => {
      const mark = make('i', { class: `block ${tone}` });
      mark.style.background = toneColor(tone, theme);
      return make('span', {}, mark, text);
    }));
    const zones = viewer.run?.zonesAt(Infinity).length ?? 0;
    element('layers').querySelector('[data-layer="zones"]')!.closest('label')!.hidden = zones === 0;
    // Only a robot with a lidar has these layers.
    element('layers').querySelector('[data-layer="scan"]')!.closest('label')!.hidden = !lidar;
  }
}
