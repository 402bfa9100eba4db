// SPDX-License-Identifier: Apache-2.0
import type { Setting } from '../data/run';
import { friendlyRefusal } from '../data/refusal';
import { capitalised } from '../data/words';
import { make } from '../page/dom';
import { presentOnly } from '../page/present';
import { type SettingRow, settingRow } from './setting_row';

/** Receives settings that change together, as "group.name=value". */
export type Change = (assignments: string[]) => void;

const groupNames: Record<string, string> = {
  mpc: 'Controller',
};

const AT_ONCE = 20; // most assignments of one change

/** The settings with search; on the live page they can be changed. */
export class SettingsPanel {
  private list: Setting[] | null = null;
  private readonly rows = new Map<string, SettingRow>();
  private readonly search = make('input', { type: 'search', id: 'setting-search', placeholder: 'Search settings', 'aria-label': 'Search settings' });
  private readonly only = make('input', { type: 'checkbox', id: 'settings-changed' });
  private readonly reset = make('button', { type: 'button', id: 'settings-reset' }, 'Reset all');
  private readonly body = make('div');
  private wanted: Record<string, unknown> = {}; // the values that were sent last

  /** @param change the action of a control; without it the settings are read-only. */
  constructor(root: HTMLElement, private readonly change: Change | null, before: HTMLElement | null = null) {
    this.search.addEventListener('input', () => this.filter());
    this.only.addEventListener('change', () => this.filter());
    this.reset.addEventListener('click', () => this.resetAll());
    this.reset.hidden = !change;
    root.append(...(before ? [presentOnly(before)] : []),
      make('div', { class: 'setting-tools' }, this.search, make('label', {}, this.only, ' Changed only'), presentOnly(this.reset)),
      presentOnly(this.body));
  }

  /** The present settings. All earlier refusals are history. @return whether they are new. */
  show(list: Setting[]): boolean {
    if (list === this.list) return false;
    const fresh = this.list === null || this.list.length !== list.length;
    this.list = list;
    if (fresh) this.rebuild(list);
    for (const setting of list) {
      const row = this.rows.get(`${setting.group}.${setting.name}`);
      row?.show(setting.value);
      row?.accept();
    }
    this.filter();
    return true;
  }

  /** Shows at these settings why they were refused. @return whether one of them is shown. */
  refuse(names: string[], text: string): boolean {
    const why = friendlyRefusal(text, this.list ?? [], this.wanted);
    // The setting that the text is about comes first; otherwise all that were sent.
    const about = names.filter((name) => text.startsWith(`${name}:`));
    let found = false;
    for (const name of about.length > 0 ? about : names) {
      const setting = this.list?.find((s) => `${s.group}.${s.name}` === name);
      const row = this.rows.get(name);
      if (!setting || !row) continue;
      row.refuse(why, setting.value);
      found = true;
    }
    for (const name of names) {
      const setting = this.list?.find((s) => `${s.group}.${s.name}` === name);
      if (setting && !about.includes(name) && about.length > 0) this.rows.get(name)?.show(setting.value);
    }
    return found;
  }

  /** Sends settings that are valid together only. */
  send(values: Record<string, Setting['value']>): void {
    this.wanted = values;
    this.change?.(Object.entries(values).map(([key, value]) => `${key}=${value}`));
  }

  private resetAll(): void {
    const changed = (this.list ?? []).filter((s) => this.rows.get(`${s.group}.${s.name}`)?.changed);
    for (let i = 0; i < changed.length; i += AT_ONCE) {
      this.send(Object.fromEntries(changed.slice(i, i + AT_ONCE).map((s) => [`${s.group}.${s.name}`, s.default!])));
    }
  }

  private rebuild(list: Setting[]): void {
    this.rows.clear();
    const groups = new Map<string, HTMLDetailsElement>();
    for (const setting of list) {
      const key = `${setting.group}.${setting.name}`;
      let details = groups.get(setting.group);
      if (!details) {
        details = make('details', { 'data-group': setting.group },
          make('summary', {}, groupNames[setting.group] ?? capitalised(setting.group)));
        groups.set(setting.group, details);
      }
      const row = settingRow(setting, this.change ? (value) => this.send({ [key]: value }) : null);
      this.rows.set(key, row);
      details.append(row.root);
    }
    const kept = new Set([...this.body.querySelectorAll('details[open]')].map((d) => (d as HTMLElement).dataset.group));
    for (const [name, details] of groups) details.open = kept.has(name);
    this.body.replaceChildren(...groups.values());
  }

  // A search opens the groups in which it finds something, and hides the others.
  private filter(): void {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const searching = words.length > 0 || this.only.checked;
    for (const details of this.body.querySelectorAll<HTMLDetailsElement>('details')) {
      let some = false;
      for (const element of details.querySelectorAll<HTMLElement>('.setting')) {
        const row = this.rows.get(element.dataset.setting!)!;
        element.hidden = !row.matches(words) || (this.only.checked && !row.changed);
        some ||= !element.hidden;
      }
      details.hidden = !some;
      if (searching && some) details.open = true;
    }
  }
}
