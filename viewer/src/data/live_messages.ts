// SPDX-License-Identifier: Apache-2.0
import { paceText } from './pace';
import type { Tone } from './words';

/** What the server says besides the run. */
export interface LiveState {
  paused: boolean;
  speed: number;
  map: number;
  maps: string[];
  sensing: 'map' | 'lidar';
  noise: 'none' | 'standard';
  halted: boolean;
  waiting: boolean;
  edited: boolean;
  undo: string;
  redo: string;
}

/** A text message of the server. */
export interface LiveMessage {
  state?: LiveState;
  notice?: string;
  refused?: { text: string; at?: { x: number; y: number }; settings?: string[] };
}

/**
 * The state of the world in few words.
 * @param past the time that is shown; null for the present.
 * @param pace simulated seconds per second; null while it is unknown.
 */
export function stateWords(state: LiveState, past: number | null, pace: number | null): [string, Tone] {
  if (past !== null) return [`viewing ${past.toFixed(1)} s`, 'slow'];
  if (state.waiting) return ['starting', 'idle'];
  if (state.halted) return ['emergency stop', 'bad'];
  if (state.paused) return ['paused', 'slow'];
  const late = paceText(pace, state.speed);
  return late ? [`live, ${late}`, 'slow'] : ['live', 'good'];
}
