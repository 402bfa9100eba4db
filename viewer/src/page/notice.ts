// SPDX-License-Identifier: Apache-2.0
import { element } from './dom';

let timer = 0;

/** Shows a notice over the map for some seconds; screen readers read it at once. */
export function notify(text: string): void {
  const root = element('notice');
  root.textContent = text;
  root.hidden = false;
  clearTimeout(timer);
  timer = window.setTimeout(() => { root.hidden = true; }, 8000);
}
