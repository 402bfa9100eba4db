// SPDX-License-Identifier: Apache-2.0
import type { Setting } from '../data/run';

export type Values = Record<string, Setting['value']>;

/** A robot that the body editor offers. */
export interface RobotPreset {
  name: string;
  /** The file of this robot in scenarios/robots, which has the same values; a test compares them. */
  file?: string;
  values: Values;
}

const disc = (name: string, radius: number): RobotPreset =>
  ({ name, values: { 'robot.radius': radius, 'robot.length': 0, 'robot.width': 0, 'robot.discs': '[]' } });

/** The radius of the disc around a rectangle, rounded up to millimetres. */
export const around = (length: number, width: number): number => Math.ceil(500 * Math.hypot(length, width)) / 1000;

const rectangle = (
  name: string, file: string, [length, width]: [number, number], [least, most, turn]: [number, number, number], [linear, angular]: [number, number],
): RobotPreset => ({
  name: `${name}, ${length} × ${width} m`,
  file,
  values: {
    'robot.radius': around(length, width), 'robot.length': length, 'robot.width': width, 'robot.discs': '[]',
    'robot.linear_min': least, 'robot.linear_max': most, 'robot.angular_max': turn,
    'robot.linear_acceleration_max': linear, 'robot.angular_acceleration_max': angular,
  },
});

/** Robots with two driven wheels. Cars, tricycles and mecanum bases need a scenario with `robot:`. */
export const presets: RobotPreset[] = [
  disc('Vacuum robot, disc 0.35 m', 0.175),
  disc('TurtleBot, disc 0.36 m', 0.18),
  rectangle('Jackal', 'jackal', [0.458, 0.416], [-0.5, 2, 4], [2, 4]),
  rectangle('MiR250', 'mir250', [0.8, 0.58], [-0.5, 1.5, 1.5], [1, 2]),
  rectangle('MiR600', 'mir600', [1.35, 0.91], [-0.5, 1.5, 1.2], [0.8, 1.5]),
  rectangle('Platform', 'platform_1200', [1.2, 0.6], [-0.6, 1, 1.2], [0.8, 2]),
  rectangle('Large platform', 'platform_1800', [1.8, 1.2], [-0.5, 1.2, 1], [0.6, 1.2]),
  { name: 'L-shaped cart, three discs', values: { 'robot.radius': 0.76, 'robot.length': 0, 'robot.width': 0, 'robot.discs': '[[0.35, 0, 0.3], [-0.2, 0, 0.3], [-0.2, 0.45, 0.25]]' } },
];
