// SPDX-License-Identifier: Apache-2.0
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
