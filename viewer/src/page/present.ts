// SPDX-License-Identifier: Apache-2.0
import { make } from './dom';

/** Whether the page shows the past, in which nothing can be changed. */
export const isPast = (): boolean => document.body.classList.contains('past');

/** A group of controls that change the world: all of them are off while the page shows the past. */
export function presentOnly(...controls: (Node | string)[]): HTMLFieldSetElement {
  const set = make('fieldset', { class: 'present-only' }, ...controls);
  set.disabled = isPast();
  return set;
}

/** Shows clearly whether this is the past, and switches the controls of the present off or on. */
export function markPast(past: boolean): void {
  document.body.classList.toggle('past', past);
  for (const set of document.querySelectorAll<HTMLFieldSetElement>('fieldset.present-only')) set.disabled = past;
}
