// SPDX-License-Identifier: Apache-2.0
// The replay page of one run, opened from disk for each test.
import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { rm } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { launch, openPage } from './browser.mjs';
import { syntheticRun } from './runs.mjs';

/** The shared state of a file's tests: `run`, `url` and `browser` exist when they begin. */
export const shared = { browser: null, run: null, url: '' };

/** @param makeRun returns {folder, page}. */
export function useRun(makeRun = syntheticRun) {
  before(async () => {
    shared.run = await makeRun();
    shared.url = pathToFileURL(shared.run.page).href;
    shared.browser = await launch();
  });
  after(async () => {
    await shared.browser?.close();
    if (shared.run) await rm(shared.run.folder, { recursive: true });
  });
}

export const time = (page) => page.evaluate(() => window.fairway.time);

export const camera = (page) => page.evaluate(() => {
  const { x, y, scale } = window.fairway.camera;
  return { x, y, scale };
});

/** A sum over the map's pixels, after all pending drawing. */
export const picture = async (page) => {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.evaluate(() => {
    const map = document.getElementById('map');
    const { data } = map.getContext('2d').getImageData(0, 0, map.width, map.height);
    let sum = 0;
    for (let i = 0; i < data.length; ++i) sum = (sum * 31 + data[i]) % 4294967291;
    return sum;
  });
};

export async function withPage(work, options) {
  const { context, page, errors } = await openPage(shared.browser, shared.url, options);
  await page.waitForFunction(() => window.fairway?.drawn > 0);
  await work(page);
  assert.deepEqual(errors, []);
  await context.close();
}
