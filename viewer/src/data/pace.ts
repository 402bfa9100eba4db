// SPDX-License-Identifier: Apache-2.0

const WINDOW = 3; // over which the pace is measured [s]
const LEAST = 1; // shorter measurements say nothing [s]
const LATE = 0.85; // share of the chosen pace below which a world is late

/** Measures how fast a world really runs. */
export class PaceMeter {
  private samples: { world: number; clock: number }[] = [];

  /** @param world simulated time; @param clock time of the person [s]. */
  add(world: number, clock: number): void {
    const last = this.samples.at(-1);
    if (last && world < last.world) this.samples = []; // a new run
    this.samples.push({ world, clock });
    while (this.samples.length > 2 && this.samples[1]!.clock <= clock - WINDOW) this.samples.shift();
  }

  /** After a pause, or with another chosen pace, the measurement begins again. */
  reset(): void {
    this.samples = [];
  }

  /** Simulated seconds per second; null while it is unknown. */
  get pace(): number | null {
    const [first, last] = [this.samples[0], this.samples.at(-1)];
    if (!first || !last || last.clock - first.clock < LEAST) return null;
    return (last.world - first.world) / (last.clock - first.clock);
  }
}

/** "3.0× of 8×" for a world that is slower than chosen; otherwise empty. */
export function paceText(pace: number | null, chosen: number): string {
  if (pace === null || pace >= LATE * chosen) return '';
  return `${pace < 1 ? pace.toFixed(2) : pace.toFixed(1)}× of ${chosen}×`;
}
