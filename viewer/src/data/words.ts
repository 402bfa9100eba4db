// SPDX-License-Identifier: Apache-2.0
import type { Frame, RobotFrame } from './frame';
import type { Guide, Run } from './run';

/** good: drives; slow: drives with limits; wait: waits; brake: stops; bad: a fault; done; idle. */
export type Tone = 'good' | 'slow' | 'wait' | 'brake' | 'bad' | 'done' | 'idle';

const tones: Record<string, Tone> = {
  ok: 'good', degraded: 'slow', stopping: 'brake', blocked: 'wait', recovering: 'slow', stale: 'bad',
  'bad input': 'bad', infeasible: 'bad', 'no plan': 'wait', 'goal reached': 'done', planning: 'idle', 'gave up': 'wait', holding: 'wait',
};

/** A state of a robot for people. */
export interface StateWords {
  label: string;
  tone: Tone;
  guide: Guide | null;
}

export const capitalised = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** Before the first plan of a robot, its task says whether it has a goal. */
export const hasGoal = (run: Run, robot: RobotFrame, index: number): boolean => {
  if (run.lidar) return robot.goal !== null;
  return robot.plan ? !robot.plan.dropped : run.begin.robots[index]?.idle === false;
};

/** The page's own states, which are no status of a navigator. */
const own: [string, Tone][] = [['Collision', 'bad'], ['No goal', 'idle']];

/** All states by their tone, in the words of `fairway statuses`: the colours of the status band. */
export function statusLegend(run: Run): [Tone, string][] {
  const labels = new Map<Tone, string[]>();
  run.begin.statuses.forEach((_, status) => {
    const { label, tone } = statusWords(run, status);
    labels.set(tone, [...labels.get(tone) ?? [], label]);
  });
  for (const [label, tone] of own) labels.set(tone, [...labels.get(tone) ?? [], label]);
  return [...labels].map(([tone, list]) => [tone, list.join(', ')]);
}

/** The words for a status by its number. */
export function statusWords(run: Run, status: number): StateWords {
  const name = run.begin.statuses[status] ?? 'unknown';
  const guide = run.begin.status_guides?.[status] ?? null;
  return { label: guide?.label ?? capitalised(name), tone: tones[name] ?? 'idle', guide };
}

/** What robot `index` does in a frame, in the words of `fairway statuses`. */
export function robotWords(run: Run, frame: Frame, index: number): StateWords {
  const robot = frame.robots[index];
  if (!robot || robot.absent) return { label: 'Removed', tone: 'idle', guide: null };
  if (robot.collided) return { label: 'Collision', tone: 'bad', guide: null };
  if (robot.status === null) return { label: hasGoal(run, robot, index) ? 'Waiting' : 'No goal', tone: 'idle', guide: null };
  const words = statusWords(run, robot.status);
  const none = run.begin.statuses[robot.status] === 'no plan' && !hasGoal(run, robot, index);
  return none ? { label: 'No goal', tone: 'idle', guide: null } : words;
}

/** The words for a limiting factor by its number. */
export const limitWords = (run: Run, limit: number): string =>
  run.begin.limit_guides?.[limit]?.label ?? capitalised(run.begin.limits[limit] ?? 'unknown');

/** The name of what a robot touched. */
export function contactName(run: Run, robot: RobotFrame): string {
  const { contact } = robot;
  if (contact?.with === 'body') return run.begin.bodies[contact.other] ?? `person ${contact.other + 1}`;
  if (contact?.with === 'robot') return run.begin.robots[contact.other]?.name ?? 'a robot';
  return contact?.with === 'obstacle' ? 'a static obstacle' : 'something';
}
