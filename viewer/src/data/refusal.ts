// SPDX-License-Identifier: Apache-2.0
import type { Setting } from './run';
import { capitalised } from './words';

const AXES: Record<string, string> = { max: 'Maximum', min: 'Minimum' };

/** A readable name of a setting: "linear_acceleration_max" becomes "Maximum linear acceleration". */
export function readableName(name: string): string {
  const parts = name.split('_');
  const extreme = AXES[parts.at(-1) ?? ''];
  if (extreme && parts.length > 1) return `${extreme} ${parts.slice(0, -1).join(' ')}`;
  return capitalised(parts.join(' '));
}

/** What people read for the refusal "group.name: expected ..., found ..." of the program. */
export function friendlyRefusal(text: string, settings: Setting[], wanted: Record<string, unknown>): string {
  const value = (key: string): number => {
    const found = settings.find((s) => `${s.group}.${s.name}` === key);
    return Number(wanted[key] ?? found?.value);
  };
  if (text.startsWith('mpc.decay_rate: expected at most 1 / mpc.step_length')) {
    const step = value('mpc.step_length');
    return `With a step of ${step} s the decay rate must be at most ${+(1 / step).toPrecision(3)} /s (now ${value('mpc.decay_rate')}).`;
  }
  const found = /^([a-z_]+)\.([a-z_]+): expected (.*)$/s.exec(text);
  if (!found) return text;
  const [, group, name, rest] = found;
  const setting = settings.find((s) => s.group === group && s.name === name);
  const [expected, got] = rest!.split(/, found (?:an? )?/);
  // Names of settings in the text become readable too.
  const readable = (words: string): string => words.replace(/\b[a-z]+\.([a-z_]+)\b/g, (_, n: string) => readableName(n).toLowerCase());
  const number = /^a number (?:from|between) /.test(expected!) ? expected!.replace(/^a number from (.*) to (.*)$/, 'between $1 and $2') : readable(expected!);
  const unit = setting?.unit && /\d$/.test(number) ? ` ${setting.unit}` : '';
  const now = got?.replace(/^'(.*)'$/, '$1') ?? (wanted[`${group}.${name}`] !== undefined ? `${wanted[`${group}.${name}`]}` : '');
  return `${readableName(name!)} must be ${number}${unit}${now ? ` (got ${readable(now)})` : ''}.`;
}
