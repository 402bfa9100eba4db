// SPDX-License-Identifier: Apache-2.0
import { element, icon, make } from '../page/dom';
import type { Viewer } from '../view/viewer';
import { BrushTool, PersonTool } from './edit_tools';
import { MeasureTool, PlaceTool, type Send, type Tool } from './tools';
import { ZoneOptions } from './zone_options';
import { ZoneTool } from './zone_tool';

interface Entry {
  id: string;
  title: string;
  key: string;
  hint: string;
  icon: string;
  tool: Tool | null;
}

const PAN = 'Drag to move the map, click to select a robot';

// Pictures of 16 x 16 units, drawn as paths.
const icons = {
  pan: 'M8 1l2 2H9v4h4V6l2 2-2 2V9H9v4h1l-2 2-2-2h1V9H3v1L1 8l2-2v1h4V3H6z',
  measure: 'M1 11L11 1l4 4L5 15zM4 10l1 1M6 8l1.5 1.5M8 6l1 1M10 4l1.5 1.5',
  goal: 'M8 1a6 6 0 100 12A6 6 0 008 1zm0 2.2a3.8 3.8 0 110 7.6 3.8 3.8 0 010-7.6zM8 5.5a1.5 1.5 0 100 3 1.5 1.5 0 000-3z',
  pose: 'M8 1l5 13-5-3-5 3z',
  wall: 'M2 12L11 3l2 2-9 9H2z',
  erase: 'M6 2l8 6-4 5H5L2 10z',
  person: 'M8 1a2.5 2.5 0 110 5 2.5 2.5 0 010-5zM4 8h8v3h-1.5v4h-5v-4H4z',
  zone: 'M2 3l7-2 5 5-3 8-8-2zM4 5l1 6 5 1 2-5-3-3z',
  robot: 'M3 5h7v7H3zM11 2h1.5v2.5H15V6h-2.5v2.5H11V6H8.5V4.5H11z',
};

/** The tools of a page, one of which is active. Without `send` the world cannot be changed. */
export class Toolbar {
  private chosen: Entry;
  private readonly entries: Entry[];
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly brushes: BrushTool[] = [];
  private readonly size: HTMLElement;
  private zones: ZoneOptions | null = null;
  private enabled = true;

  constructor(private readonly viewer: Viewer, send: Send | null) {
    const tool = (id: keyof typeof icons, title: string, key: string, made: Tool | null): Entry =>
      ({ id, title, key, hint: made?.hint ?? PAN, icon: icons[id], tool: made });
    this.entries = [tool('pan', 'Pan', 'm', null), tool('measure', 'Measure', 'r', new MeasureTool(viewer))];
    if (send) this.entries.push(...this.editing(send, tool));
    this.chosen = this.entries[0]!;
    this.size = this.brushSize();
    this.build();
    this.choose(this.chosen);
    viewer.overlay = (context, camera) => this.chosen.tool?.draw(context, camera);
  }

  /** The keys that select tools. */
  get keys(): Record<string, () => void> {
    return Object.fromEntries(this.entries.map((entry) => [entry.key, () => this.choose(entry)]));
  }

  get help(): [string, string][] {
    return [[this.entries.map((entry) => entry.key.toUpperCase()).join(' '),
      this.entries.map((entry) => entry.title.toLowerCase()).join(', ')]];
  }

  /** Cancels what a tool has begun; else returns to panning. @return whether there was something. */
  escape(): boolean {
    if (this.viewer.cursor.cancel()) return true;
    if (this.chosen === this.entries[0]) return false;
    this.choose(this.entries[0]!);
    return true;
  }

  /** Only the present can be changed: tools that change it are off in the past. */
  enable(enabled: boolean): void {
    if (enabled === this.enabled) return;
    this.enabled = enabled;
    for (const entry of this.entries.slice(2)) this.buttons.get(entry.id)!.disabled = !enabled;
    if (!enabled && this.entries.indexOf(this.chosen) >= 2) this.choose(this.entries[0]!);
  }

  private editing(send: Send, tool: (id: keyof typeof icons, title: string, key: string, made: Tool) => Entry): Entry[] {
    const { viewer } = this;
    const robot = (): number => viewer.selected;
    const wall = new BrushTool(viewer, 'Drag to draw obstacles', true, send);
    const erase = new BrushTool(viewer, 'Drag to erase obstacles and people', false, send);
    this.brushes.push(wall, erase);
    const zone = new ZoneTool(viewer, send);
    this.zones = new ZoneOptions(zone);
    const withHeading = (turn: number | null) => (turn === null ? {} : { heading: turn });
    const pose = (turn: number | null): number => turn ?? viewer.moment?.poses[robot()]?.heading ?? 0;
    return [
      tool('goal', 'Goal', 'g', new PlaceTool(viewer, 'Click to set the goal; drag to set its heading',
        (at, turn) => send({ do: 'goal', robot: robot(), x: at.x, y: at.y, ...withHeading(turn) }))),
      tool('pose', 'Set pose', 'b', new PlaceTool(viewer, 'Click to move the robot there; drag to set its heading',
        (at, turn) => send({ do: 'pose', robot: robot(), x: at.x, y: at.y, heading: pose(turn) }))),
      tool('wall', 'Draw obstacle', 'o', wall),
      tool('erase', 'Erase', 'e', erase),
      tool('person', 'Person', 'p', new PersonTool(viewer, 'Click to add a person, drag to move one', send)),
      tool('zone', 'Zone', 'z', zone),
      tool('robot', 'Add robot', 'n', new PlaceTool(viewer, 'Click to add a robot; drag to set its heading',
        (at, turn) => send({ do: 'add_robot', x: at.x, y: at.y, heading: turn ?? 0 }))),
    ];
  }

  private build(): void {
    const root = element('tools');
    const row = make('div', { class: 'group' });
    for (const entry of this.entries) {
      const button = make('button', {
        type: 'button', id: `tool-${entry.id}`, 'aria-label': entry.title, title: `${entry.title}: ${entry.hint} (${entry.key.toUpperCase()})`,
      }, icon(entry.icon), make('span', {}, entry.title));
      button.addEventListener('click', () => this.choose(entry));
      this.buttons.set(entry.id, button);
      row.append(button);
    }
    root.append(row, this.size);
    if (this.zones) root.append(this.zones.root);
  }

  private brushSize(): HTMLElement {
    const slider = make('input', { type: 'range', id: 'brush', min: '0.03', max: '1', step: '0.01', value: '0.15', 'aria-label': 'Brush radius [m]' });
    const text = make('span', {}, '0.15 m');
    slider.addEventListener('input', () => {
      for (const brush of this.brushes) brush.radius = slider.valueAsNumber;
      text.textContent = `${slider.valueAsNumber.toFixed(2)} m`;
    });
    return make('label', { class: 'brush' }, 'Brush radius', slider, text);
  }

  private choose(entry: Entry): void {
    if (this.buttons.get(entry.id)!.disabled) return;
    this.chosen.tool?.cancel();
    this.chosen = entry;
    this.viewer.gestures.tool = entry.tool;
    this.viewer.map.classList.toggle('tool', entry.tool !== null);
    for (const [id, button] of this.buttons) button.setAttribute('aria-pressed', `${id === entry.id}`);
    this.size.hidden = !(entry.tool instanceof BrushTool);
    if (this.zones) this.zones.root.hidden = !(entry.tool instanceof ZoneTool);
    this.viewer.say(entry.hint);
    this.viewer.invalidate();
  }
}
