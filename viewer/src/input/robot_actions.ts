// SPDX-License-Identifier: Apache-2.0
import { make } from '../page/dom';
import { presentOnly } from '../page/present';
import type { RobotActions } from '../panels/robot_panel';
import type { Viewer } from '../view/viewer';
import type { Send } from './tools';

/** The buttons on a robot's card of the live page: a typed goal, cancel, reset and remove. */
export function robotActions(viewer: Viewer, send: Send): RobotActions {
  return (robot) => {
    const field = (id: string, label: string, step: string): HTMLInputElement =>
      make('input', { type: 'number', step, id: `${id}-${robot}`, 'aria-label': `Goal ${label}`, placeholder: label.replace(/ \[(.*)\]/, ' $1').replace('heading ', '') });
    const [x, y, heading] = [field('goal-x', 'x [m]', '0.01'), field('goal-y', 'y [m]', '0.01'), field('goal-heading', 'heading [°]', '1')];
    const form = make('form', { class: 'typed-goal', 'aria-label': 'Goal as numbers' }, x, y, heading, make('button', { type: 'submit' }, 'Set goal'));
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (!Number.isFinite(x.valueAsNumber) || !Number.isFinite(y.valueAsNumber)) return viewer.say('A goal needs x and y in metres.');
      const turn = heading.valueAsNumber;
      send({ do: 'goal', robot, x: x.valueAsNumber, y: y.valueAsNumber, ...(Number.isFinite(turn) ? { heading: turn * Math.PI / 180 } : {}) });
    });
    const button = (text: string, title: string, action: string, kind = ''): HTMLElement => {
      const made = make('button', { type: 'button', title, class: `${action} ${kind}` }, text);
      made.addEventListener('click', () => send({ do: action, robot }));
      return made;
    };
    return make('div', { class: 'actions' }, presentOnly(form, make('div', { class: 'group' },
      button('Cancel goal', 'Drop the goal: the robot brakes to a standstill', 'cancel'),
      button('Reset robot', 'Put the robot back to its start', 'reset_robot', 'primary'),
      button('Remove', 'Remove selected robot', 'remove_robot'))));
  };
}
