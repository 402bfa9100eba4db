// SPDX-License-Identifier: Apache-2.0
import { element, make } from '../page/dom';
import { popover } from '../page/popovers';
import type { Send } from './tools';

type Tell = (notice: string) => void;

const base64 = async (file: File): Promise<string> => {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
};

const senses = [
  { title: 'the map', sensing: 'map', noise: 'none' },
  { title: 'their lidar', sensing: 'lidar', noise: 'none' },
  { title: 'lidar with errors', sensing: 'lidar', noise: 'standard' },
];

const isYaml = (file: File): boolean => /\.ya?ml$/i.test(file.name);

/** Choosing and uploading maps, restarting, and saving. */
export class Files {
  private readonly maps = make('select', { id: 'map-choice', 'aria-label': 'Map' });
  private readonly picker = make('input', { type: 'file', id: 'map-files', accept: '.pgm,.png,.yaml,.yml', multiple: '', hidden: '' });
  private readonly dialog = make('dialog', { id: 'resolution-dialog' });
  private readonly resolution = make('input', { type: 'number', id: 'resolution', min: '0.001', max: '10', step: 'any', value: '0.05' });
  private readonly senses = make('select', { id: 'senses', 'aria-label': 'What the robots know' },
    ...senses.map(({ title }) => make('option', {}, title)));
  private names: string[] = [];

  constructor(send: Send, private readonly tell: Tell) {
    const button = (id: string, title: string, text: string, action: () => void): HTMLElement => {
      const made = make('button', { type: 'button', id, title }, text);
      made.addEventListener('click', action);
      return made;
    };
    const row = (href: string, text: string, what: string): HTMLElement =>
      make('tr', {}, make('td', {}, make('a', { class: 'button', href, download: '' }, text)), make('td', {}, what));
    this.maps.addEventListener('change', () => send({ do: 'map', index: this.maps.selectedIndex }));
    this.senses.addEventListener('change', () => {
      const { sensing, noise } = senses[this.senses.selectedIndex]!;
      send({ do: 'sense', sensing, noise });
    });
    this.picker.addEventListener('change', () => void this.upload([...this.picker.files ?? []]));
    this.askResolution();
    const root = element('files');
    root.append(this.maps, make('label', { class: 'senses', title: 'What the robots know; a choice begins a new run' }, 'Robots know ', this.senses),
      button('upload', 'A map of your own: PGM or PNG, with or without its YAML file', 'Upload', () => this.picker.click()),
      button('restart', 'Begin again', 'Restart', () => send({ do: 'restart' })),
      make('button', { type: 'button', id: 'save', 'aria-expanded': 'false', 'aria-controls': 'saves' }, 'Save'),
      this.picker, this.dialog);
    root.hidden = false;
    element('saves').append(make('table', {},
      row('/scenario.zip', 'Scenario', 'Map, robots, people and settings, for fairway simulate'),
      row('/recording.mcap', 'Recording', 'The run so far, for Foxglove, Lichtblick and fairway replay'),
      row('/report.html', 'Report', 'A page of its own that plays the run so far')));
    popover('save', 'saves');
  }

  show(maps: string[], index: number): void {
    if (maps.join('\n') !== this.names.join('\n')) {
      this.names = maps;
      this.maps.replaceChildren(...maps.map((name) => make('option', {}, name)));
    }
    this.maps.selectedIndex = index;
  }

  showSenses(sensing: string, noise: string): void {
    const index = senses.findIndex((s) => s.sensing === sensing && (sensing === 'map' || s.noise === noise));
    if (document.activeElement !== this.senses || index !== this.senses.selectedIndex) this.senses.selectedIndex = index;
  }

  private askResolution(): void {
    const form = make('form', { method: 'dialog' },
      make('label', {}, 'Metres per pixel ', this.resolution),
      make('button', { class: 'primary', id: 'resolution-ok', value: 'ok' }, 'Use the map'));
    this.dialog.append(form);
  }

  private async upload(files: File[]): Promise<void> {
    this.picker.value = '';
    const yaml = files.find(isYaml);
    const image = files.find((file) => !isYaml(file));
    if (!image) return this.tell('Choose the map\'s picture too: a PGM or PNG file');
    if (!yaml && !(await this.resolutionGiven())) return;
    const body = {
      name: image.name.replace(/\.\w+$/, ''),
      image: await base64(image),
      ...(yaml ? { yaml: await yaml.text() } : { resolution: this.resolution.valueAsNumber }),
    };
    const answer = await fetch('/map', {
      method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body),
    }).catch(() => null);
    if (!answer?.ok) this.tell(answer ? await answer.text() : 'The map did not arrive');
  }

  private resolutionGiven(): Promise<boolean> {
    this.dialog.returnValue = '';
    this.dialog.showModal();
    return new Promise((resolve) => {
      this.dialog.addEventListener('close', () => resolve(this.dialog.returnValue === 'ok' && this.resolution.checkValidity()), { once: true });
    });
  }
}
