// SPDX-License-Identifier: Apache-2.0
import { type Footprint, coveringRadius } from '../data/footprint';
import { make } from '../page/dom';
import { BodyPreview } from './body_preview';
import { type Values, around, presets } from './robot_presets';

type Disc = Footprint['discs'][number];

const discsText = (discs: Disc[]): string => discs.map(({ x, y, radius }) => `${x} ${y} ${radius}`).join('\n');

/** One disc per line: x, y and radius; null where a line is no disc. */
export function readDiscs(text: string): Disc[] | null {
  const lines = text.split('\n').map((line) => line.trim()).filter(Boolean);
  const discs = lines.map((line) => line.split(/[\s,;]+/).map(Number));
  if (discs.length === 0 || discs.some((d) => d.length !== 3 || !d.every(Number.isFinite) || !(d[2]! > 0))) return null;
  return discs.map(([x, y, radius]) => ({ x: x!, y: y!, radius: radius! }));
}

/** Edits the body of the robots: settings that are valid together only are one change. */
export class BodyEditor {
  readonly root: HTMLElement;
  private readonly shape = make('select', { id: 'body-shape', 'aria-label': 'Shape of the body' },
    make('option', { value: 'disc' }, 'Disc'), make('option', { value: 'rectangle' }, 'Rectangle'), make('option', { value: 'discs' }, 'Several discs'));
  private readonly preset = make('select', { id: 'body-preset', 'aria-label': 'Preset' }, make('option', {}, 'Preset …'),
    ...presets.map(({ name }) => make('option', {}, name)));
  private readonly radius = this.number('body-radius');
  private readonly length = this.number('body-length');
  private readonly width = this.number('body-width');
  private readonly discs = make('textarea', { id: 'body-discs', rows: '4', spellcheck: 'false', placeholder: 'x y radius' });
  private readonly preview = new BodyPreview();
  private readonly note = make('p', { class: 'meaning', role: 'status' });
  private readonly apply = make('button', { type: 'button', class: 'primary', id: 'body-apply' }, 'Apply');
  private extra: Values = {}; // what a preset sets besides the body
  private edited = false;

  constructor(private readonly send: (values: Values) => void) {
    const field = (box: HTMLElement, text: string, kind = 'field'): HTMLElement => make('label', { class: kind }, text, box);
    this.root = make('details', { id: 'body-editor' }, make('summary', {}, 'Body editor'),
      make('div', { class: 'body-editor' }, this.preview.canvas,
        make('div', {}, this.preset, this.shape, field(this.radius, 'Radius [m]'), field(this.length, 'Length [m]'), field(this.width, 'Width [m]'),
          field(this.discs, 'A disc per line: x, y, radius [m]', 'field tall'), this.apply)),
      this.note, make('p', { class: 'meaning' }, 'For robots with two driven wheels. Polygons, cars, tricycles and mecanum bases come with a scenario that has ',
        make('code', {}, 'robot:'), ', such as those of scenarios/robots.'));
    for (const box of [this.shape, this.radius, this.length, this.width, this.discs]) {
      box.addEventListener('input', () => { this.edited = true; this.draw(); });
    }
    this.preset.addEventListener('change', () => this.choose());
    this.apply.addEventListener('click', () => {
      const body = this.body();
      if (!body) return;
      this.edited = false;
      this.send({ ...this.extra, ...values(body) });
      this.extra = {};
    });
  }

  /** The present body, unless the user edits it. */
  show(body: Footprint): void {
    if (this.edited) return;
    this.fill(body);
    this.draw();
  }

  /** The last change was refused: the user goes on editing. */
  refused(text: string): void {
    this.edited = true;
    this.note.textContent = text;
  }

  private number(id: string): HTMLInputElement {
    return make('input', { type: 'number', id, min: '0.01', max: '20', step: '0.01' });
  }

  private choose(): void {
    const chosen = presets[this.preset.selectedIndex - 1];
    if (!chosen) return;
    const { 'robot.radius': radius, 'robot.length': length, 'robot.width': width, 'robot.discs': discs, ...extra } = chosen.values;
    const list = (JSON.parse(discs as string) as [number, number, number][]).map(([x, y, r]) => ({ x, y, radius: r }));
    this.fill({ radius: radius as number, length: length as number, width: width as number, discs: list });
    this.extra = extra;
    this.edited = true;
    this.draw();
  }

  private fill({ radius, length, width, discs }: Footprint): void {
    this.shape.value = discs.length > 0 ? 'discs' : length > 0 ? 'rectangle' : 'disc';
    this.radius.value = `${+radius.toFixed(3)}`;
    this.length.value = `${length || 2 * +radius.toFixed(3)}`;
    this.width.value = `${width || 2 * +radius.toFixed(3)}`;
    this.discs.value = discsText(discs.length > 0 ? discs : [{ x: 0, y: 0, radius: +radius.toFixed(3) }]);
  }

  /** The body that the fields describe; null while they are no body. */
  private body(): Footprint | null {
    const positive = (...list: number[]): boolean => list.every((n) => Number.isFinite(n) && n > 0);
    if (this.shape.value === 'discs') {
      const discs = readDiscs(this.discs.value);
      const body = { radius: 0, length: 0, width: 0, discs: discs ?? [] };
      return discs && { ...body, radius: Math.ceil(1000 * coveringRadius(body)) / 1000 };
    }
    if (this.shape.value === 'rectangle') {
      const [length, width] = [this.length.valueAsNumber, this.width.valueAsNumber];
      return positive(length, width) ? { radius: around(length, width), length, width, discs: [] } : null;
    }
    const radius = this.radius.valueAsNumber;
    return positive(radius) ? { radius, length: 0, width: 0, discs: [] } : null;
  }

  private draw(): void {
    const shape = this.shape.value;
    this.radius.parentElement!.hidden = shape !== 'disc';
    this.length.parentElement!.hidden = this.width.parentElement!.hidden = shape !== 'rectangle';
    this.discs.parentElement!.hidden = shape !== 'discs';
    const body = this.body();
    this.apply.disabled = !body;
    this.note.textContent = body
      ? `Circumscribed radius ${coveringRadius(body).toFixed(2)} m: paths keep this disc free.`
      : shape === 'discs' ? 'Enter x, y and a positive radius in each line.' : 'Enter positive numbers.';
    this.preview.draw(body);
  }
}

function values({ radius, length, width, discs }: Footprint): Values {
  return {
    'robot.radius': radius, 'robot.length': length, 'robot.width': width,
    'robot.discs': JSON.stringify(discs.map((d) => [d.x, d.y, d.radius])).replaceAll(',', ', '),
  };
}
