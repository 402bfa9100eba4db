// SPDX-License-Identifier: Apache-2.0
import { element } from './dom';

export type Action = () => void;

/** Closes the open popover. */
export function closePopovers(): void {
  for (const open of document.querySelectorAll<HTMLElement>('.popover')) open.hidden = true;
  for (const opener of document.querySelectorAll('[aria-controls]')) {
    if (opener.getAttribute('aria-controls') !== 'panel') opener.setAttribute('aria-expanded', 'false');
  }
}

/** Lets a button open and close its popover. */
export function popover(button: string, panel: string): Action {
  const root = element(panel);
  const opener = element(button);
  const toggle = (): void => {
    const opening = root.hidden;
    closePopovers();
    root.hidden = !opening;
    opener.setAttribute('aria-expanded', `${opening}`);
  };
  opener.addEventListener('click', toggle);
  return toggle;
}
