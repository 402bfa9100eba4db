// SPDX-License-Identifier: Apache-2.0
import type { Setting } from '../data/run';
import { readableName } from '../data/refusal';
import { make } from '../page/dom';
import { throttled } from '../page/throttle';

type Value = Setting['value'];

const PERIOD = 100; // least time between two messages of a slider [ms]

/** A setting in the panel: its name, key, meaning and control. */
export interface SettingRow {
  root: HTMLElement;
  /** Shows a value; a control that the user edits keeps its text. */
  show(value: Value): void;
  /** Shows why a value was refused, and the value that is in use. */
  refuse(text: string, value: Value): void;
  accept(): void;
  /** Whether it contains the words of a search. */
  matches(words: string[]): boolean;
  changed: boolean;
}

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
  // Otherwise small ranges are cut off at a whole step.
  return { min: Math.floor(min / step) * step, max: Math.ceil(max / step) * step, step };
}

const rounded = (value: number): string => `${+value.toPrecision(6)}`;

/** @param change receives a new value; without it the setting is read-only. */
export function settingRow(setting: Setting, change: ((value: Value) => void) | null): SettingRow {
  const key = `${setting.group}.${setting.name}`;
  const unit = make('span', { class: 'unit' }, setting.unit.replaceAll('^2', '²'));
  // Long keys may break after an underscore.
  const parts = setting.name.split('_').flatMap((part, i) => (i === 0 ? [part] : ['_', make('wbr'), part]));
  const id = `setting-${key}`;
  const name = make('label', { class: 'name', for: id }, readableName(setting.name));
  const reset = make('button', { type: 'button', class: 'plain reset', 'aria-label': `Reset ${readableName(setting.name)}`, title: `Default: ${setting.default}` }, '↺');
  const head = make('div', { class: 'row' }, name);
  if (change) head.append(reset);
  const error = make('div', { class: 'refusal', role: 'alert', id: `${id}-error` });
  error.hidden = true;
  const meaning = make('div', { class: 'meaning', id: `${id}-meaning` }, make('code', {}, ...parts), ` ${setting.meaning}`);
  const root = make('div', { class: 'setting', 'data-setting': key }, head);
  const text = `${key} ${readableName(setting.name)} ${setting.meaning}`.toLowerCase();
  let control: HTMLElement | null = null;
  let put: (value: Value, force: boolean) => void;
  const row: SettingRow = {
    root,
    changed: false,
    show(value) {
      put(value, false);
      row.changed = setting.default !== undefined && value !== setting.default;
      root.classList.toggle('changed', row.changed);
      reset.hidden = !row.changed;
    },
    refuse(why, value) {
      put(value, true);
      error.textContent = why;
      error.hidden = false;
      control?.setAttribute('aria-invalid', 'true');
      control?.setAttribute('aria-describedby', error.id);
    },
    accept() {
      error.hidden = true;
      control?.removeAttribute('aria-invalid');
      control?.setAttribute('aria-describedby', meaning.id);
    },
    matches: (words) => words.every((word) => text.includes(word)),
  };
  reset.addEventListener('click', () => change?.(setting.default!));
  if (!change) {
    const shownValue = make('span');
    head.append(make('span', {}, shownValue, ' ', unit));
    put = (value) => { shownValue.textContent = `${value}`; };
  } else if (setting.kind === 'switch') {
    const box = make('input', { type: 'checkbox', id });
    box.addEventListener('change', () => change(box.checked));
    head.append(box);
    control = box;
    put = (value) => { box.checked = value === true; };
  } else if (setting.kind === 'choice') {
    const box = make('select', { id },
      ...(setting.choices ?? []).map((choice) => make('option', { value: choice }, choice)));
    box.addEventListener('change', () => change(box.value));
    head.append(box);
    control = box;
    put = (value) => { box.value = `${value}`; };
  } else if (setting.kind === 'number' || setting.kind === 'integer') {
    const box = make('input', { type: 'text', inputmode: 'decimal', id, autocomplete: 'off' });
    const { min, max, step } = sliderRange(setting);
    const slider = make('input', { type: 'range', min: `${min}`, max: `${max}`, step: `${step}`, 'aria-label': `${readableName(setting.name)}, slider` });
    const slide = throttled(change, PERIOD);
    slider.addEventListener('input', () => { box.value = slider.value; slide(slider.valueAsNumber); });
    box.addEventListener('change', () => change(box.value.trim()));
    head.append(make('span', {}, box, ' ', unit));
    root.append(slider);
    control = box;
    put = (value, force) => {
      if (force || document.activeElement !== box) box.value = rounded(value as number);
      if (force || document.activeElement !== slider) slider.value = `${value}`;
    };
  } else {
    const box = make('input', { type: 'text', class: 'wide', id, spellcheck: 'false', placeholder: setting.kind === 'discs' ? '[[x, y, radius], ...]' : '' });
    box.addEventListener('change', () => change(box.value));
    root.append(box);
    control = box;
    put = (value, force) => { if (force || document.activeElement !== box) box.value = `${value}`; };
  }
  control?.setAttribute('aria-describedby', meaning.id);
  root.append(error, meaning);
  return row;
}
