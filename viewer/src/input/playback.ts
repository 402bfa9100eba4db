// SPDX-License-Identifier: Apache-2.0
import { element } from '../page/dom';

/**
 * The actions of the buttons below the map: the replay page moves the time, the live page the
 * world.
 */
export interface Transport {
  readonly playing: boolean;
  toggle(): void;
  step(direction: 1 | -1): void;
  seek(time: number): void;
  start(): void;
  end(): void;
  speed(factor: number): void;
}

/** Connects the buttons. */
export function connect(transport: Transport): void {
  element('play').addEventListener('click', () => transport.toggle());
  element('back').addEventListener('click', () => transport.step(-1));
  element('forward').addEventListener('click', () => transport.step(1));
  element('to-start').addEventListener('click', () => transport.start());
  element('to-end').addEventListener('click', () => transport.end());
  const speed = element<HTMLSelectElement>('speed');
  speed.addEventListener('change', () => transport.speed(Number(speed.value)));
}

/** Updates the play button. */
export function showPlaying(playing: boolean): void {
  const button = element('play');
  button.querySelector('path')!.setAttribute('d', playing ? 'M3 2h4v12H3zM9 2h4v12H9z' : 'M4 2.5v11l9-5.5z');
  button.setAttribute('aria-label', playing ? 'Pause' : 'Play');
}
