// SPDX-License-Identifier: Apache-2.0
import { element, make } from '../page/dom';
import type { Viewer } from '../view/viewer';
import { BrushTool, PersonTool, PlaceTool, type Send, type Tool } from './tools';

interface Entry {
  id: string;
  title: string;
  key: string;
  tool: Tool | null;
}

/** The tools of the live page, one of which is active. */
export class Toolbar {
  private chosen: Entry;
  private readonly entries: Entry[];
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly brushes: BrushTool[];
  private readonly size: HTMLElement;

  constructor(private readonly viewer: Viewer, send: Send) {
    const robot = (): number => viewer.selected;
    const wall = new BrushTool(viewer, 'Drag to draw obstacles', true, send);
    const erase = new BrushTool(viewer, 'Drag to wipe off obstacles and people', false, send);
    this.brushes = [wall, erase];
    const withHeading = (turn: number | null) => (turn === null ? {} : { heading: turn });
    const pose = (turn: number | null): number => turn ?? viewer.moment?.poses[robot()]?.heading ?? 0;
    this.entries = [
      { id: 'hand', title: 'Move', key: 'm', tool: null },
      { id: 'goal', title: 'Goal', key: 'g', tool: new PlaceTool(viewer, 'Click where the robot shall go; drag for a heading',
        (at, turn) => send({ do: 'goal', robot: robot(), x: at.x, y: at.y, ...withHeading(turn) })) },
      { id: 'start', title: 'Start', key: 'b', tool: new PlaceTool(viewer, 'Click where the robot begins; drag for a heading',
        (at, turn) => send({ do: 'start', robot: robot(), x: at.x, y: at.y, heading: pose(turn) })) },
      { id: 'wall', title: 'Wall', key: 'o', tool: wall },
      { id: 'erase', title: 'Erase', key: 'e', tool: erase },
      { id: 'person', title: 'Person', key: 'p', tool: new PersonTool(viewer, 'Click to place a person; drag to lead one', send) },
      { id: 'robot', title: '+ Robot', key: 'n', tool: new PlaceTool(viewer, 'Click where one more robot begins; drag for a heading',
        (at, turn) => send({ do: 'add_robot', x: at.x, y: at.y, heading: turn ?? 0 })) },
    ];
    this.chosen = this.entries[1]!;
    this.size = this.brushSize();
    this.build(send);
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

  private build(send: Send): void {
    const root = element('tools');
    for (const entry of this.entries) {
      const button = make('button', {
        type: 'button', id: `tool-${entry.id}`, title: `${entry.tool?.hint ?? 'Drag to move the map'} (${entry.key.toUpperCase()})`,
      }, entry.title);
      button.addEventListener('click', () => this.choose(entry));
      this.buttons.set(entry.id, button);
      if (['goal', 'wall', 'person', 'robot'].includes(entry.id)) root.append(make('i'));
      root.append(button);
    }
    const remove = make('button', { type: 'button', id: 'remove-robot', title: 'Take the chosen robot away' }, '− Robot');
    remove.addEventListener('click', () => send({ do: 'remove_robot', robot: this.viewer.selected }));
    root.append(remove, this.size);
    root.hidden = false;
  }

  private brushSize(): HTMLElement {
    const slider = make('input', { type: 'range', id: 'brush', min: '0.03', max: '1', step: '0.01', value: '0.15', 'aria-label': 'Brush radius [m]' });
    const text = make('span', {}, '0.15 m');
    slider.addEventListener('input', () => {
      for (const brush of this.brushes) brush.radius = slider.valueAsNumber;
      text.textContent = `${slider.valueAsNumber.toFixed(2)} m`;
    });
    return make('label', { class: 'brush' }, slider, text);
  }

  private choose(entry: Entry): void {
    this.chosen.tool?.cancel();
    this.chosen = entry;
    this.viewer.gestures.tool = entry.tool;
    this.viewer.map.classList.toggle('tool', entry.tool !== null);
    for (const [id, button] of this.buttons) button.setAttribute('aria-pressed', `${id === entry.id}`);
    this.size.hidden = !(entry.tool instanceof BrushTool);
    element('hint').textContent = entry.tool?.hint ?? 'Drag to move the map';
    this.viewer.invalidate();
  }
}
