// SPDX-License-Identifier: Apache-2.0

/** A choice of the user from an earlier visit; null where the browser keeps none. */
export function recalled(key: string): string | null {
  try {
    return localStorage.getItem(`fairway.${key}`);
  } catch {
    return null; // for example in a page opened from disk with strict settings
  }
}

/** Keeps a choice of the user for the next visit, where the browser can. */
export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(`fairway.${key}`, value);
  } catch {
    // The choice lasts as long as the page.
  }
}
