// SPDX-License-Identifier: Apache-2.0

/** The element of the page with this id. */
export function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found as T;
}

type Child = Node | string | null;

/** Makes an element: `make('b', {class: 'x'}, 'text')`. Text is never read as HTML. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children.filter((child) => child !== null));
  return made;
}

/** Formats a number with fixed digits. */
export const shown = (value: number, digits = 2): string =>
  // Adding zero turns a negative zero into a positive one.
  Number.isFinite(value) ? (Number(value.toFixed(digits)) + 0).toFixed(digits) : '–';

/** A small picture from the path of an SVG of 16 x 16 units. */
export function icon(path: string): SVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  for (const [name, value] of [['class', 'icon'], ['viewBox', '0 0 16 16'], ['aria-hidden', 'true']]) svg.setAttribute(name!, value!);
  const shape = document.createElementNS(space, 'path');
  shape.setAttribute('d', path);
  svg.append(shape);
  return svg;
}
