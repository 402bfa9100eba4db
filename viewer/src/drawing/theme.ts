// SPDX-License-Identifier: Apache-2.0

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
  scan: string;
  fog: string; // over unknown cells, with its opacity
  limit: string;
  halo: string;
}

// The palette of Okabe and Ito, which people with colour-vision deficiency can distinguish.
const light: Theme = {
  dark: false,
  outside: '#e9ecef', free: '#ffffff', occupied: '#39424c', unknown: '#d3d8dd',
  ink: '#1b232b', faint: '#6a7682', grid: '#e3e7eb',
  path: '#596673', corridor: '#56b4e9', current: '#0072b2', prediction: '#b0478a',
  body: '#d55e00', believed: '#a8741a', scan: '#8a2be2', fog: '#39424c30',
  limit: '#d11f2f', halo: '#ffffff',
};

const dark: Theme = {
  dark: true,
  outside: '#12161a', free: '#1f262d', occupied: '#93a1ae', unknown: '#171c21',
  ink: '#e6ebf0', faint: '#93a0ac', grid: '#2b343c',
  path: '#aab6c1', corridor: '#56b4e9', current: '#6cc3f5', prediction: '#e291c3',
  body: '#ff8a3d', believed: '#d9a648', scan: '#c79bff', fog: '#00000088',
  limit: '#ff5c68', halo: '#12161a',
};

const robots = {
  light: ['#0072b2', '#d55e00', '#009e73', '#a54a85', '#b97d00', '#2e86c1', '#5a3c14'],
  dark: ['#5fb8f0', '#ff8a3d', '#35cfa2', '#e291c3', '#f0b83c', '#9fd3f7', '#c9a878'],
};

export const robotColor = (index: number, theme: Theme): string => {
  const list = theme.dark ? robots.dark : robots.light;
  return list[index % list.length]!;
};

export type StatusTone = 'good' | 'warn' | 'bad' | 'done' | 'idle';

/** The colour of a status, by its number in NavigationStatus. */
export function statusTone(status: number): StatusTone {
  const tones: StatusTone[] = [
    'good', 'warn', 'bad', 'bad', 'warn', 'bad', 'bad', 'bad', 'idle', 'done'];
  return tones[status] ?? 'idle';
}

const toneColors: Record<StatusTone, [string, string]> = {
  good: ['#2f9e6e', '#3bbf88'],
  warn: ['#d99a00', '#f0b83c'],
  bad: ['#d11f2f', '#ff5c68'],
  done: ['#0072b2', '#5fb8f0'],
  idle: ['#98a3ad', '#5c6873'],
};

export const toneColor = (tone: StatusTone, theme: Theme): string =>
  toneColors[tone][theme.dark ? 1 : 0];

/** The current theme: the user's choice, else the system's. */
export class Themes {
  current: Theme = light;
  private readonly system = matchMedia('(prefers-color-scheme: dark)');
  private readonly listeners: (() => void)[] = [];

  constructor() {
    this.system.addEventListener('change', () => this.apply());
    this.apply();
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  toggle(): void {
    const next = this.current.dark ? 'light' : 'dark';
    document.documentElement.dataset.theme = next;
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
