// SPDX-License-Identifier: Apache-2.0

/** Limits calls to one per period; the last one is never lost. */
export function throttled<T extends unknown[]>(call: (...args: T) => void, period: number): (...args: T) => void {
  let waiting: T | null = null;
  let timer = 0;
  const fire = (): void => {
    timer = 0;
    if (!waiting) return;
    const args = waiting;
    waiting = null;
    timer = window.setTimeout(fire, period);
    call(...args);
  };
  return (...args) => {
    waiting = args;
    if (!timer) fire();
  };
}
