// SPDX-License-Identifier: Apache-2.0
import type { Tone } from '../data/words';
import { recalled, remember } from '../page/memory';

/** Colours of the canvases; those of the page around them are in page.css. */
export interface Theme {
  dark: boolean;
  outside: string;
  free: string;
  occupied: string;
  unknown: string;
  ink: string;
  faint: string;
  grid: string;
  path: string;
  corridor: string;
  current: string;
  prediction: string;
  body: string;
  believed: string;
  tracked: string;
  scan: string;
  fog: string; // over unknown cells, with its opacity
  limit: string;
  fault: string;
  halo: string;
  note: string; // background of labels on the map
  noteInk: string;
}

// Blue is the corridor, orange are people, magenta is the prediction, gold is the active
// constraint. Red is for faults only. Robots have colours between these.
const light: Theme = {
  dark: false,
  outside: '#e9ecef', free: '#ffffff', occupied: '#39424c', unknown: '#d3d8dd',
  ink: '#1b232b', faint: '#5d6975', grid: '#e3e7eb',
  path: '#596673', corridor: '#56b4e9', current: '#0072b2', prediction: '#b0478a',
  body: '#d55e00', believed: '#a8741a', tracked: '#00707a', scan: '#8a2be2', fog: '#39424c30',
  limit: '#e0a800', fault: '#c8102e', halo: '#ffffff', note: '#1b232b', noteInk: '#ffffff',
};

const dark: Theme = {
  dark: true,
  outside: '#12161a', free: '#1f262d', occupied: '#93a1ae', unknown: '#171c21',
  ink: '#e6ebf0', faint: '#9aa7b3', grid: '#2b343c',
  path: '#aab6c1', corridor: '#56b4e9', current: '#6cc3f5', prediction: '#e291c3',
  body: '#ff8a3d', believed: '#d9a648', tracked: '#4fd0dc', scan: '#c79bff', fog: '#00000088',
  limit: '#ffd24a', fault: '#ff5c68', halo: '#12161a', note: '#e6ebf0', noteInk: '#12161a',
};

/**
 * The colour of a robot: hues by the golden angle, so that no two are alike, without the oranges of
 * people and the blues of corridors.
 */
export const robotColor = (index: number, theme: Theme): string => {
  const share = (0.28 + index * 0.618034) % 1;
  const hue = share < 0.5 ? 75 + share * 2 * 110 : 232 + (share - 0.5) * 2 * 118;
  const step = Math.floor(index / 6) % 3;
  return theme.dark ? `hsl(${hue.toFixed(0)} 65% ${66 + 6 * step}%)` : `hsl(${hue.toFixed(0)} 70% ${30 + 5 * step}%)`;
};

const toneColors: Record<Tone, [string, string]> = {
  good: ['#2a8f62', '#3bbf88'],
  slow: ['#b98500', '#f0b83c'],
  wait: ['#8a6d00', '#c9a84a'],
  brake: ['#b5540a', '#ff9d57'],
  bad: ['#c8102e', '#ff5c68'],
  done: ['#4a5560', '#c3ccd4'],
  idle: ['#98a3ad', '#5c6873'],
};

export const toneColor = (tone: Tone, theme: Theme): string =>
  toneColors[tone][theme.dark ? 1 : 0];

/** The current theme: the user's choice, else the system's. */
export class Themes {
  current: Theme = light;
  private readonly system = matchMedia('(prefers-color-scheme: dark)');
  private readonly listeners: (() => void)[] = [];

  constructor() {
    const chosen = recalled('theme');
    if (chosen === 'dark' || chosen === 'light') document.documentElement.dataset.theme = chosen;
    this.system.addEventListener('change', () => this.apply());
    this.apply();
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  toggle(): void {
    const next = this.current.dark ? 'light' : 'dark';
    document.documentElement.dataset.theme = next;
    remember('theme', next);
    this.apply();
  }

  /** For printing: always light. */
  use(theme: 'light' | 'chosen'): void {
    this.apply(theme === 'light');
  }

  private apply(forceLight = false): void {
    const chosen = document.documentElement.dataset.theme;
    const wantsDark = chosen ? chosen === 'dark' : this.system.matches;
    this.current = wantsDark && !forceLight ? dark : light;
    for (const listener of this.listeners) listener();
  }
}
