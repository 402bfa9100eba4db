// SPDX-License-Identifier: Apache-2.0
import { type Rule, type Zone, zoneNames } from '../data/zones';
import { make } from '../page/dom';
import type { ZoneTool } from './zone_tool';

const degrees = 180 / Math.PI;

/** The rule of the chosen zone or of the next one, beside the tools. */
export class ZoneOptions {
  readonly root: HTMLElement;
  private readonly kind = make('select', { id: 'zone-kind', 'aria-label': 'Kind of zone' },
    ...Object.entries(zoneNames).map(([value, text]) => make('option', { value }, text)));
  private readonly reference = make('select', { id: 'zone-reference', 'aria-label': 'Holds for' },
    make('option', { value: 'contour' }, 'whole body'), make('option', { value: 'centre' }, 'centre'));
  private readonly speed = this.number('zone-speed', '0.01', '10', '0.05');
  private readonly weight = this.number('zone-weight', '0', '20', '0.5');
  private readonly direction = this.number('zone-direction', '-180', '180', '5');
  private readonly fields: [Zone['kind'][], HTMLElement][];
  private readonly corner = make('button', { type: 'button', id: 'zone-corner' }, 'Add corner');
  private readonly remove = make('button', { type: 'button', id: 'zone-remove' }, 'Remove zone');

  constructor(private readonly tool: ZoneTool) {
    this.fields = [
      [['keep_out', 'speed_limit', 'strip'], make('label', {}, 'for', this.reference)],
      [['speed_limit'], make('label', {}, 'at most', this.speed, 'm/s')],
      [['penalty', 'preferred'], make('label', {}, 'weight', this.weight)],
      [['one_way'], make('label', {}, 'heading', this.direction, '°')],
    ];
    for (const field of [this.kind, this.reference, this.speed, this.weight, this.direction]) {
      field.addEventListener('change', () => this.changed());
    }
    this.corner.addEventListener('click', () => tool.addCorner());
    this.remove.addEventListener('click', () => tool.remove());
    this.root = make('div', { class: 'brush', id: 'zone-options', role: 'group', 'aria-label': 'Zone' },
      this.kind, ...this.fields.map(([, field]) => field), this.corner, this.remove);
    tool.onChosen = () => this.show();
    this.show();
  }

  private number(id: string, min: string, max: string, step: string): HTMLInputElement {
    return make('input', { type: 'number', id, min, max, step });
  }

  // Only what a robot can obey is sent; the server says what else is wrong.
  private changed(): void {
    const rule: Rule = {
      kind: this.kind.value as Zone['kind'],
      reference: this.reference.value as Zone['reference'],
      speed: this.valid(this.speed),
      weight: this.valid(this.weight),
      direction: this.valid(this.direction) / degrees,
    };
    if (Object.values(rule).some(Number.isNaN)) return;
    this.tool.use(rule);
    this.show();
  }

  private valid(field: HTMLInputElement): number {
    const { badInput, rangeOverflow, rangeUnderflow } = field.validity;
    return badInput || rangeOverflow || rangeUnderflow ? NaN : field.valueAsNumber;
  }

  private show(): void {
    const { kind, reference, speed, weight, direction } = this.tool.rule;
    this.kind.value = kind;
    this.reference.value = reference;
    this.speed.valueAsNumber = speed;
    this.weight.valueAsNumber = weight;
    this.direction.valueAsNumber = Math.round(direction * degrees);
    for (const [kinds, field] of this.fields) field.hidden = !kinds.includes(kind);
    this.corner.hidden = this.remove.hidden = this.tool.zone === null;
  }
}
