// SPDX-License-Identifier: Apache-2.0
import type { Setting } from '../data/run';
import { make } from '../page/dom';

type Change = (group: string, name: string, value: number | boolean | string) => void;

const groupNames: Record<string, string> = {
  mpc: 'Controller',
};

const capitalised = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** A slider covers the useful part of its range; ranges like 0 to 1e6 would be unusable. */
function sliderRange(setting: Setting): { min: number; max: number; step: number } {
  const value = setting.value as number;
  const reach = value === 0 ? 1 : 4 * Math.abs(value);
  const low = setting.min ?? -reach;
  const high = setting.max ?? reach;
  const max = Math.max(Math.min(high, reach), value);
  const min = Math.min(Math.max(low, -reach), value);
  const span = max - min;
  const step = setting.kind === 'integer' ? 1 : 10 ** Math.floor(Math.log10(span / 100));
  return { min, max, step };
}

/** All settings with their units: a table on the replay page, controls on the live page. */
export class SettingsPanel {
  private list: Setting[] | null = null;
  private readonly defaults = new Map<string, Setting['value']>();
  private readonly setters = new Map<string, (value: Setting['value']) => void>();

  /** @param change the action of a control; without it the settings are read-only. */
  constructor(
    private readonly root: HTMLElement,
    private readonly change: Change | null,
  ) {}

  show(list: Setting[]): void {
    if (list === this.list) return;
    const fresh = this.list === null || this.list.length !== list.length;
    this.list = list;
    if (fresh) this.rebuild(list);
    for (const setting of list) this.setters.get(`${setting.group}.${setting.name}`)?.(setting.value);
  }

  /** Rebuilds the panel with sliders around other values. */
  reset(): void {
    this.list = null;
  }

  private rebuild(list: Setting[]): void {
    this.setters.clear();
    const groups = new Map<string, HTMLDetailsElement>();
    for (const setting of list) {
      const key = `${setting.group}.${setting.name}`;
      if (!this.defaults.has(key)) this.defaults.set(key, setting.value);
      let details = groups.get(setting.group);
      if (!details) {
        details = make('details', { 'data-group': setting.group },
          make('summary', {}, groupNames[setting.group] ?? capitalised(setting.group)));
        groups.set(setting.group, details);
      }
      details.append(this.row(setting, key));
    }
    const kept = new Set([...this.root.querySelectorAll('details[open]')]
      .map((d) => (d as HTMLElement).dataset.group));
    for (const [name, details] of groups) details.open = kept.has(name);
    this.root.replaceChildren(make('h2', {}, 'Settings'), ...groups.values());
  }

  private row(setting: Setting, key: string): HTMLElement {
    const unit = make('span', { class: 'unit' }, setting.unit.replaceAll('^2', '²'));
    // Long names may break after an underscore.
    const parts = setting.name.split('_').flatMap((part, i) => (i === 0 ? [part] : ['_', make('wbr'), part]));
    const name = make('span', { class: 'name' }, ...parts);
    const head = make('div', { class: 'row' }, name);
    const row = make('div', { class: 'setting', title: setting.meaning, 'data-setting': key }, head);
    const changed = (value: Setting['value']): void => {
      row.classList.toggle('changed', value !== this.defaults.get(key));
    };
    if (!this.change) {
      const text = make('span');
      head.append(make('span', {}, text, ' ', unit));
      this.setters.set(key, (value) => { text.textContent = `${value}`; changed(value); });
      return row;
    }
    const send = (value: Setting['value']): void => this.change!(setting.group, setting.name, value);
    if (setting.kind === 'switch') {
      const box = make('input', { type: 'checkbox', 'aria-label': key });
      box.addEventListener('change', () => send(box.checked));
      head.append(box);
      this.setters.set(key, (value) => { box.checked = value === true; changed(value); });
    } else if (setting.kind === 'choice') {
      const box = make('select', { 'aria-label': key },
        ...(setting.choices ?? []).map((choice) => make('option', { value: choice }, choice)));
      box.addEventListener('change', () => send(box.value));
      head.append(box);
      this.setters.set(key, (value) => { box.value = `${value}`; changed(value); });
    } else if (setting.kind === 'discs') {
      const box = make('input', { type: 'text', class: 'wide', 'aria-label': key, placeholder: '[[x, y, radius], ...]', spellcheck: 'false' });
      box.addEventListener('change', () => send(box.value));
      row.append(box);
      this.setters.set(key, (value) => { if (document.activeElement !== box) box.value = `${value}`; changed(value); });
    } else {
      this.number(setting, key, row, head, unit, send, changed);
    }
    return row;
  }

  private number(
    setting: Setting, key: string, row: HTMLElement, head: HTMLElement, unit: HTMLElement,
    send: (value: number) => void, changed: (value: Setting['value']) => void,
  ): void {
    const { min, max, step } = sliderRange(setting);
    const bounds: Record<string, string> = {};
    if (setting.min !== undefined) bounds.min = `${setting.min}`;
    if (setting.max !== undefined) bounds.max = `${setting.max}`;
    const box = make('input', { type: 'number', step: 'any', 'aria-label': `${key} [${setting.unit}]`, ...bounds });
    const slider = make('input', {
      type: 'range', min: `${min}`, max: `${max}`, step: `${step}`, 'aria-label': key });
    slider.addEventListener('input', () => {
      box.value = slider.value;
      send(slider.valueAsNumber);
    });
    box.addEventListener('change', () => {
      if (Number.isFinite(box.valueAsNumber) && box.checkValidity()) send(box.valueAsNumber);
    });
    head.append(make('span', {}, box, ' ', unit));
    row.append(slider);
    this.setters.set(key, (value) => {
      if (document.activeElement !== box) box.value = `${+(value as number).toPrecision(6)}`;
      if (document.activeElement !== slider) slider.value = `${value}`;
      changed(value);
    });
  }
}
