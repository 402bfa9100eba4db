// SPDX-License-Identifier: Apache-2.0
import type { Run } from './run';
import { type Tone, contactName, robotWords } from './words';

/** Something that happened to a robot. */
export interface RunEvent {
  time: number;
  robot: number;
  text: string;
  tone: Tone;
}

const MOST = 500; // newest events kept

/** Collects the events of a run while it grows: changes of status, new plans, collisions. */
export class EventLog {
  events: RunEvent[] = [];
  /** Number of events ever, also of those that are no longer kept. */
  total = 0;
  private run: Run | null = null;
  private until = -Infinity; // time of the last frame that was read
  private readonly words = new Map<number, string>();
  private readonly plans = new Map<number, number>();

  /** Reads the new frames. @param whole no frame is added later. */
  follow(run: Run, whole = false): void {
    if (run !== this.run) {
      this.run = run;
      this.events = [];
      this.total = 0;
      this.until = -Infinity;
      this.words.clear();
      this.plans.clear();
    }
    // The newest frame may still receive its cycles.
    const end = run.frames.length - (whole ? 0 : 1);
    for (let i = this.until === -Infinity ? 0 : run.frameIndex(this.until) + 1; i < end; ++i) this.frame(run, i);
    if (this.events.length > MOST) this.events.splice(0, this.events.length - MOST);
  }

  private add(event: RunEvent): void {
    this.events.push(event);
    ++this.total;
  }

  private frame(run: Run, index: number): void {
    const frame = run.frames[index]!;
    this.until = frame.time;
    frame.robots.forEach((robot, i) => {
      const { label, tone } = robotWords(run, frame, i);
      const last = this.words.get(i);
      this.words.set(i, label);
      if (last !== label && (last !== undefined || tone !== 'idle')) {
        const text = robot.collided ? `Collided with ${contactName(run, robot)}` : label;
        this.add({ time: frame.time, robot: i, text, tone });
      }
      const planned = robot.plan?.time;
      if (planned === undefined || planned === this.plans.get(i)) return;
      const first = !this.plans.has(i);
      this.plans.set(i, planned);
      if (!first && robot.plan!.usable) this.add({ time: frame.time, robot: i, text: 'New plan', tone: 'idle' });
    });
  }
}
