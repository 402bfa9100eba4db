// SPDX-License-Identifier: Apache-2.0
import { element } from './dom';

export type Action = () => void;

interface Open {
  panel: HTMLElement;
  opener: HTMLElement;
}

let open: Open | null = null;

/** Closes the open popover. @return whether one was open. */
export function closePopovers(refocus = true): boolean {
  if (!open) return false;
  const { panel, opener } = open;
  open = null;
  panel.hidden = true;
  opener.setAttribute('aria-expanded', 'false');
  if (refocus && panel.contains(document.activeElement)) opener.focus();
  return true;
}

/** Lets a button open and close its popover, which takes the focus. */
export function popover(button: string, panel: string): Action {
  const root = element(panel);
  const opener = element(button);
  root.tabIndex = -1;
  const toggle = (): void => {
    const opening = root.hidden;
    closePopovers();
    if (!opening) return;
    root.hidden = false;
    open = { panel: root, opener };
    opener.setAttribute('aria-expanded', 'true');
    (root.querySelector<HTMLElement>('input, button, select, a[href]') ?? root).focus({ preventScroll: true });
  };
  opener.addEventListener('click', toggle);
  return toggle;
}

// A click outside closes; the click itself still does what it does.
addEventListener('pointerdown', (event) => {
  const target = event.target as Node;
  if (open && !open.panel.contains(target) && !open.opener.contains(target)) closePopovers(false);
}, { capture: true });
// Leaving the popover by Tab closes it too.
addEventListener('focusin', (event) => {
  const target = event.target as Node;
  if (open && !open.panel.contains(target) && !open.opener.contains(target)) closePopovers(false);
});
