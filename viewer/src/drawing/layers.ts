// SPDX-License-Identifier: Apache-2.0

/** The layers that can be shown or hidden. */
export const layerNames = {
  path: 'Path',
  corridor: 'Corridor',
  prediction: 'Prediction',
  trail: 'Way driven',
  limit: 'What limits',
  velocity: 'Velocities',
  seen: 'Map it has seen',
  scan: 'Lidar',
  names: 'Names',
} as const;
export type Layer = keyof typeof layerNames;
export type Layers = Record<Layer, boolean>;
