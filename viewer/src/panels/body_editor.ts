// SPDX-License-Identifier: Apache-2.0
import type { Footprint } from '../data/footprint';
import { coveringRadius } from '../data/footprint';
import type { Setting } from '../data/run';
import { make } from '../page/dom';

type Values = Record<string, Setting['value']>;

const presets: [name: string, values: Values][] = [
  ['Vacuum robot, disc 0.35 m', { 'robot.radius': 0.175, 'robot.length': 0, 'robot.width': 0, 'robot.discs': '[]' }],
  ['TurtleBot, disc 0.36 m', { 'robot.radius': 0.18, 'robot.length': 0, 'robot.width': 0, 'robot.discs': '[]' }],
  ['Jackal, 0.51 × 0.43 m', { 'robot.radius': 0.34, 'robot.length': 0.51, 'robot.width': 0.43, 'robot.discs': '[]' }],
  ['Delivery cart, 0.9 × 0.6 m', { 'robot.radius': 0.55, 'robot.length': 0.9, 'robot.width': 0.6, 'robot.discs': '[]' }],
  ['Pallet truck, 1.6 × 0.7 m', { 'robot.radius': 0.88, 'robot.length': 1.6, 'robot.width': 0.7, 'robot.discs': '[]' }],
];

const SIDE = 150; // of the preview [pixels]

/** Edits the body of the robots: settings that are valid together only are one change. */
export class BodyEditor {
  readonly root: HTMLElement;
  private readonly shape = make('select', { id: 'body-shape', 'aria-label': 'Shape of the body' },
    make('option', { value: 'disc' }, 'Disc'), make('option', { value: 'rectangle' }, 'Rectangle'));
  private readonly preset = make('select', { id: 'body-preset', 'aria-label': 'Preset' }, make('option', {}, 'Preset …'),
    ...presets.map(([name]) => make('option', {}, name)));
  private readonly radius = this.number('body-radius', 'Radius [m]');
  private readonly length = this.number('body-length', 'Length [m]');
  private readonly width = this.number('body-width', 'Width [m]');
  private readonly preview = make('canvas', { width: `${2 * SIDE}`, height: `${2 * SIDE}`, role: 'img', class: 'preview' });
  private readonly note = make('p', { class: 'meaning', role: 'status' });
  private readonly apply = make('button', { type: 'button', class: 'primary', id: 'body-apply' }, 'Apply');
  private edited = false;

  constructor(private readonly send: (values: Values) => void) {
    const field = (box: HTMLInputElement, text: string): HTMLElement => make('label', { class: 'field' }, text, box);
    this.root = make('details', { id: 'body-editor' }, make('summary', {}, 'Body editor'),
      make('div', { class: 'body-editor' }, this.preview,
        make('div', {}, this.preset, this.shape, field(this.radius, 'Radius [m]'), field(this.length, 'Length [m]'), field(this.width, 'Width [m]'), this.apply)),
      this.note);
    for (const box of [this.shape, this.radius, this.length, this.width]) {
      box.addEventListener('input', () => { this.edited = true; this.draw(); });
    }
    this.preset.addEventListener('change', () => {
      const values = presets[this.preset.selectedIndex - 1]?.[1];
      if (!values) return;
      this.fill({ radius: values['robot.radius'] as number, length: values['robot.length'] as number, width: values['robot.width'] as number, discs: [] });
      this.edited = true;
      this.draw();
    });
    this.apply.addEventListener('click', () => {
      this.edited = false;
      this.send(this.values());
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

  private number(id: string, label: string): HTMLInputElement {
    return make('input', { type: 'number', id, min: '0.01', max: '20', step: '0.01', 'aria-label': label });
  }

  private fill({ radius, length, width }: Footprint): void {
    this.shape.value = length > 0 ? 'rectangle' : 'disc';
    this.radius.value = `${+radius.toFixed(3)}`;
    this.length.value = `${length || 2 * +radius.toFixed(3)}`;
    this.width.value = `${width || 2 * +radius.toFixed(3)}`;
  }

  private body(): Footprint {
    const rectangle = this.shape.value === 'rectangle';
    const [length, width] = rectangle ? [this.length.valueAsNumber, this.width.valueAsNumber] : [0, 0];
    const radius = rectangle ? Math.ceil(500 * Math.hypot(length, width)) / 1000 : this.radius.valueAsNumber;
    return { radius, length, width, discs: [] };
  }

  private values(): Values {
    const { radius, length, width } = this.body();
    return { 'robot.radius': radius, 'robot.length': length, 'robot.width': width, 'robot.discs': '[]' };
  }

  private draw(): void {
    const rectangle = this.shape.value === 'rectangle';
    this.radius.parentElement!.hidden = rectangle;
    this.length.parentElement!.hidden = this.width.parentElement!.hidden = !rectangle;
    const body = this.body();
    const valid = [body.radius, body.length, body.width].every(Number.isFinite) && body.radius > 0;
    this.apply.disabled = !valid;
    const around = valid ? coveringRadius(body) : 1;
    this.note.textContent = valid
      ? `Circumscribed radius ${around.toFixed(2)} m: paths keep this disc free.` : 'Enter positive numbers.';
    this.preview.setAttribute('aria-label', rectangle ? `Rectangle of ${body.length} by ${body.width} m` : `Disc of radius ${body.radius} m`);
    const context = this.preview.getContext('2d')!;
    const scale = 0.85 * SIDE / around;
    const style = getComputedStyle(document.documentElement);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, 2 * SIDE, 2 * SIDE);
    if (!valid) return;
    context.translate(SIDE, SIDE);
    context.strokeStyle = style.getPropertyValue('--faint');
    context.setLineDash([6, 6]);
    context.lineWidth = 2;
    context.beginPath();
    context.arc(0, 0, around * scale, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
    context.fillStyle = style.getPropertyValue('--accent');
    context.beginPath();
    if (rectangle) context.rect(-body.length * scale / 2, -body.width * scale / 2, body.length * scale, body.width * scale);
    else context.arc(0, 0, body.radius * scale, 0, 2 * Math.PI);
    context.fill();
    // The heading, to the right.
    const size = Math.min(rectangle ? Math.min(body.length, body.width) / 2 : body.radius, around) * scale;
    context.fillStyle = style.getPropertyValue('--panel');
    context.beginPath();
    context.moveTo(0.8 * size, 0);
    context.lineTo(-0.5 * size, 0.5 * size);
    context.lineTo(-0.2 * size, 0);
    context.lineTo(-0.5 * size, -0.5 * size);
    context.fill();
  }
}
