// SPDX-License-Identifier: Apache-2.0
import { icon, make, element } from '../page/dom';
import type { Send } from './tools';

/** Undo, redo and the emergency stop, beside the tools of the live page. */
export class EditButtons {
  private readonly undo = this.button('undo', 'Undo', 'Ctrl+Z', 'M7 3L2 7.5 7 12V9c4 0 6 1 7 4 0-5-3-7-7-7z');
  private readonly redo = this.button('redo', 'Redo', 'Ctrl+Y', 'M9 3l5 4.5L9 12V9c-4 0-6 1-7 4 0-5 3-7 7-7z');
  private readonly halt = make('button', { type: 'button', id: 'halt', 'aria-pressed': 'false' }, 'Emergency stop');
  private halted = false;

  constructor(send: Send) {
    this.undo.addEventListener('click', () => send({ do: 'undo' }));
    this.redo.addEventListener('click', () => send({ do: 'redo' }));
    this.halt.addEventListener('click', () => send({ do: 'halt', halted: !this.halted }));
    element('edits').append(this.undo, this.redo, this.halt);
    element('edits').hidden = false;
    addEventListener('keydown', (event) => {
      if (!(event.ctrlKey || event.metaKey) || (event.target as HTMLElement).matches('input:not([type=range]):not([type=checkbox]), textarea')) return;
      const key = event.key.toLowerCase();
      if (key !== 'z' && key !== 'y') return;
      event.preventDefault();
      (key === 'y' || event.shiftKey ? this.redo : this.undo).click(); // nothing while it is disabled
    });
  }

  show(undo: string, redo: string, halted: boolean, present: boolean): void {
    this.undo.disabled = !undo || !present;
    this.redo.disabled = !redo || !present;
    this.undo.title = `Undo ${undo} (Ctrl+Z)`;
    this.redo.title = `Redo ${redo} (Ctrl+Y)`;
    this.halted = halted;
    this.halt.textContent = halted ? 'Release stop' : 'Emergency stop';
    this.halt.setAttribute('aria-pressed', `${halted}`);
  }

  private button(id: string, title: string, key: string, path: string): HTMLButtonElement {
    return make('button', { type: 'button', id, 'aria-label': title, title: `${title} (${key})`, disabled: '' }, icon(path));
  }
}
