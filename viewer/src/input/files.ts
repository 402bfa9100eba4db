// SPDX-License-Identifier: Apache-2.0
import { element, make } from '../page/dom';
import { confirmed } from '../page/confirm';
import { popover } from '../page/popovers';
import { isPast, presentOnly } from '../page/present';
import type { Send } from './tools';

type Tell = (notice: string) => void;

const base64 = async (file: File): Promise<string> => {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
};

const senses = [
  { title: 'Known map', sensing: 'map', noise: 'none' },
  { title: 'Lidar', sensing: 'lidar', noise: 'none' },
  { title: 'Noisy lidar + odometry', sensing: 'lidar', noise: 'standard' },
];

/** What people read for "name:2: resolution: expected ..., found ..." of the program. */
export function uploadRefusal(text: string): string {
  const found = /^(.*?):(\d+): ([\w ]+): expected (.*), found (.*)$/s.exec(text.trim());
  if (!found) return text;
  const [, file, row, key, expected, got] = found;
  return `${file}${/\.\w+$/.test(file!) ? '' : '.yaml'} line ${row}: ${key} must be ${expected!.replace(/^an? /, 'a ')} (got ${got}).`;
}

// A choice that is not decided yet stays visible behind its question.
const confirming = (): boolean => document.getElementById('confirm') !== null;

const isYaml = (file: File): boolean => /\.ya?ml$/i.test(file.name);

/** Choosing and uploading maps, restarting, and saving. */
export class Files {
  private readonly maps = make('select', { id: 'map-choice', 'aria-label': 'Map' });
  private readonly picker = make('input', { type: 'file', id: 'map-files', accept: '.pgm,.png,.yaml,.yml', multiple: '', hidden: '' });
  private readonly dialog = make('dialog', { id: 'resolution-dialog' });
  private readonly resolution = make('input', { type: 'number', id: 'resolution', min: '0.001', max: '10', step: 'any', value: '0.05' });
  private readonly senses = make('select', { id: 'senses', 'aria-label': 'Sensing' },
    ...senses.map(({ title }) => make('option', {}, title)));
  private readonly revert = make('button', { type: 'button', id: 'revert', title: 'Begin again with the map and the robots as they were before your changes' }, 'Discard edits');
  private names: string[] = [];
  private map = 0; // as the world has it
  private sense = 0;

  /** @param loss what would be lost if a run began now; empty for nothing. */
  constructor(send: Send, private readonly tell: Tell, private readonly loss: () => string) {
    const button = (id: string, title: string, text: string, action: () => void): HTMLElement => {
      const made = make('button', { type: 'button', id, title }, text);
      made.addEventListener('click', action);
      return made;
    };
    const row = (href: string, text: string, what: string): HTMLElement =>
      make('tr', {}, make('td', {}, make('a', { class: 'button', href, download: '' }, text)), make('td', {}, what));
    this.maps.addEventListener('change', async () => {
      const index = this.maps.selectedIndex;
      if (await this.mayBegin('Another map')) send({ do: 'map', index });
      else this.maps.selectedIndex = this.map;
    });
    this.senses.addEventListener('change', async () => {
      const { sensing, noise } = senses[this.senses.selectedIndex]!;
      if (await this.mayBegin('Other sensing')) send({ do: 'sense', sensing, noise });
      else this.senses.selectedIndex = this.sense;
    });
    this.picker.addEventListener('change', () => void this.upload([...this.picker.files ?? []]));
    this.revert.addEventListener('click', async () => {
      if (await this.mayBegin('Without your edits it')) send({ do: 'revert' });
    });
    this.askResolution();
    const root = element('files');
    root.append(presentOnly(this.maps, make('label', { class: 'senses', title: 'What the robots know; another choice begins a new run' }, 'Sensing: ', this.senses),
      button('upload', 'A map of your own: PGM or PNG, with or without its YAML file', 'Upload map', () => this.picker.click()),
      button('restart', 'Begin a new run with the present map, robots and people', 'Reset run', () => send({ do: 'restart' })),
      this.revert),
      make('button', { type: 'button', id: 'save', 'aria-expanded': 'false', 'aria-controls': 'saves' }, 'Export'),
      this.picker, this.dialog);
    root.hidden = false;
    element('saves').append(make('table', {},
      row('/scenario.zip', 'Scenario', 'Map, robots, people and settings, for fairway simulate'),
      row('/recording.mcap', 'Recording', 'The run so far, for Foxglove, Lichtblick and fairway replay'),
      row('/report.html', 'Report', 'A page of its own that plays the run so far')));
    popover('save', 'saves');
  }

  show(maps: string[], index: number, edited: boolean): void {
    // Disabled, not hidden: the map must not move under a stroke that is being drawn.
    this.revert.disabled = !edited;
    if (maps.join('\n') !== this.names.join('\n')) {
      this.names = maps;
      this.maps.replaceChildren(...maps.map((name) => make('option', {}, name)));
    }
    this.map = index;
    if (!confirming()) this.maps.selectedIndex = index;
  }

  /** Whether a new run may begin: asks where the present one would be lost. */
  async mayBegin(what: string): Promise<boolean> {
    if (isPast()) {
      this.tell('This is the past. Go live to begin a new run.');
      return false;
    }
    const loss = this.loss();
    return !loss || confirmed(`${what} begins at 0 s. ${loss}`, 'Begin a new run');
  }

  showSenses(sensing: string, noise: string): void {
    const index = senses.findIndex((s) => s.sensing === sensing && (sensing === 'map' || s.noise === noise));
    this.sense = index;
    if (!confirming() && (document.activeElement !== this.senses || index !== this.senses.selectedIndex)) this.senses.selectedIndex = index;
  }

  private askResolution(): void {
    const form = make('form', { method: 'dialog' },
      make('label', {}, 'Map resolution [m/px] ', this.resolution),
      make('button', { class: 'primary', id: 'resolution-ok', value: 'ok' }, 'Load map'),
      make('button', { id: 'resolution-cancel', value: 'cancel', formnovalidate: '' }, 'Cancel'));
    this.dialog.append(form);
  }

  private async upload(files: File[]): Promise<void> {
    this.picker.value = '';
    const yaml = files.find(isYaml);
    const image = files.find((file) => !isYaml(file));
    if (!image) return this.tell('Also select the map image (PGM or PNG).');
    if (!(await this.mayBegin('The new map'))) return;
    if (!yaml && !(await this.resolutionGiven())) return;
    const body = {
      name: image.name.replace(/\.\w+$/, ''),
      image: await base64(image),
      ...(yaml ? { yaml: await yaml.text() } : { resolution: this.resolution.valueAsNumber }),
    };
    const answer = await fetch('/map', {
      method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body),
    }).catch(() => null);
    if (!answer?.ok) this.tell(answer ? uploadRefusal(await answer.text()) : 'Upload failed: server not reachable.');
  }

  private resolutionGiven(): Promise<boolean> {
    this.dialog.returnValue = '';
    this.dialog.showModal();
    return new Promise((resolve) => {
      this.dialog.addEventListener('close', () => resolve(this.dialog.returnValue === 'ok' && this.resolution.checkValidity()), { once: true });
    });
  }
}
