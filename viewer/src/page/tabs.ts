// SPDX-License-Identifier: Apache-2.0
import { element, make } from './dom';

/** Tabs of the side panel: one page is visible at a time. */
export class Tabs {
  private readonly buttons: HTMLButtonElement[] = [];

  /** @param pages title and id of the element of each page. */
  constructor(root: HTMLElement, private readonly pages: readonly (readonly [title: string, id: string])[]) {
    root.setAttribute('role', 'tablist');
    pages.forEach(([title, id], i) => {
      const button = make('button', { type: 'button', role: 'tab', id: `tab-${id}`, 'aria-controls': id }, title);
      button.addEventListener('click', () => this.choose(i));
      button.addEventListener('keydown', (event) => this.key(event, i));
      const page = element(id);
      page.setAttribute('role', 'tabpanel');
      page.setAttribute('aria-labelledby', button.id);
      this.buttons.push(button);
      root.append(button);
    });
    this.choose(0);
  }

  choose(index: number): void {
    this.pages.forEach(([, id], i) => {
      element(id).hidden = i !== index;
      this.buttons[i]!.setAttribute('aria-selected', `${i === index}`);
      this.buttons[i]!.tabIndex = i === index ? 0 : -1;
    });
  }

  private key(event: KeyboardEvent, index: number): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (index + step + this.pages.length) % this.pages.length;
    this.choose(next);
    this.buttons[next]!.focus();
  }
}
