// SPDX-License-Identifier: Apache-2.0

/** The layers that can be shown or hidden. */
export const layerNames = {
  path: 'Path',
  corridor: 'Corridor',
  prediction: 'Prediction',
  trail: 'Trail',
  limit: 'Active constraint',
  velocity: 'Velocities',
  zones: 'Zones',
  seen: 'Local map',
  scan: 'Lidar points',
  names: 'Names',
  reasons: 'Reasons',
} as const;
export type Layer = keyof typeof layerNames;
export type Layers = Record<Layer, boolean>;
