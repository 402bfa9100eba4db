// SPDX-License-Identifier: Apache-2.0
// The live page of a server of its own, for each test.
import assert from 'node:assert/strict';
import { openPage } from './browser.mjs';
import { serve } from './server.mjs';

/**
 * Starts a separate server for each test, so that tests do not affect each other; selects `map`.
 * `expected`: the console messages that each page may have.
 */
export async function withLive(browser, work, { map = 'Empty hall', pages = 1, expected = [], scenarios = [], ...options } = {}) {
  const server = await serve(...scenarios);
  const opened = [];
  try {
    for (let i = 0; i < pages; ++i) opened.push(await openPage(browser, server.url, options));
    const { page } = opened[0];
    await page.waitForFunction(() => window.fairway?.drawn > 0);
    if (map) {
      await chooseMap(page, map);
    }
    await work(...opened.map((one) => one.page), server);
    for (const { errors } of opened) assert.deepEqual(errors, expected);
  } finally {
    for (const { context } of opened) await context.close();
    assert.equal(await server.stop(), 0);
  }
}

/** Selects a map, and answers the question of a page whose run would be lost. */
export const chooseMap = async (page, map) => {
  await page.selectOption('#map-choice', { label: map }, { force: true });
  await confirm(page);
  await title(page, map);
};

/** Agrees to lose the run, if the page asks. */
export const confirm = async (page) => {
  if (await page.locator('#confirm').isVisible()) await page.click('#confirm-ok');
};

export const title = (page, name) => page.waitForFunction((text) => document.getElementById('title').textContent === text, name);

/** The newest frame, without what is large. */
export const last = (page) => page.evaluate(() => {
  const { frames } = window.fairway.run;
  const { time, bodies, robots } = frames.at(-1);
  return { time, bodies, robots: robots.map(({ plan, cycle, ...pose }) => ({ ...pose, goal: plan?.goal, usable: plan?.usable, dropped: plan?.dropped, status: cycle?.status, linear: cycle?.linear })) };
});

export const until = (page, condition, argument) => page.waitForFunction(condition, argument);

/** Waits until the map has the size of its place: buttons of a tool that was chosen change it. */
const settled = (page) => page.evaluate(async () => {
  const frame = () => new Promise((done) => requestAnimationFrame(done));
  const look = () => {
    const { x, y, width, height } = document.getElementById('map').getBoundingClientRect();
    const { camera } = window.fairway;
    return [x, y, width, height, camera.x, camera.y, camera.scale, camera.width, camera.height].join();
  };
  for (let n = 0, same = 0, before = ''; n < 60 && same < 3; ++n) {
    await frame();
    const now = look();
    same = now === before ? same + 1 : 0;
    before = now;
  }
});

/** The screen position of a world point. */
export const spot = async (page, x, y) => {
  await settled(page);
  const box = await page.locator('#map').boundingBox();
  const at = await page.evaluate(([wx, wy]) => window.fairway.camera.toScreen({ x: wx, y: wy }), [x, y]);
  return [box.x + at.x, box.y + at.y];
};

export const click = async (page, x, y) => page.mouse.click(...await spot(page, x, y));

export const drag = async (page, ...points) => {
  // Twice: the hint of a tool appears when the pointer enters the map, which then becomes smaller.
  for (let i = 0; i < 2; ++i) await page.mouse.move(...await spot(page, ...points[0]));
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...await spot(page, ...point), { steps: 6 });
  await page.mouse.up();
};

// Runs in the page.
const cellValue = ([wx, wy]) => {
  const grid = window.fairway.run.grids[0][0];
  const { frame } = grid;
  const [i, j] = [Math.floor((wx - frame.origin.x) / frame.resolution), Math.floor((wy - frame.origin.y) / frame.resolution)];
  let value = grid.cells[j * frame.width + i];
  for (const { runs } of grid.changes) {
    for (let k = 0; k < runs.length; k += 4) {
      if (runs[k] === j && i >= runs[k + 1] && i < runs[k + 1] + runs[k + 2]) value = runs[k + 3];
    }
  }
  return value;
};

/** The value of the true map's cell: 0 free, 1 occupied. */
export const cellAt = (page, x, y) => page.evaluate(cellValue, [x, y]);

/** Waits until the true map's cell has a value, at most for two minutes. */
export const cellBecomes = async (page, x, y, value) => {
  for (const end = Date.now() + 120_000; await cellAt(page, x, y) !== value;) {
    assert.ok(Date.now() < end, `the cell at ${x}, ${y} does not become ${value}`);
    await page.waitForTimeout(30);
  }
};

/** Pauses the world, and waits until the page shows it. */
export const pause = async (page) => {
  await page.click('#play');
  await until(page, () => document.getElementById('connection').textContent === 'paused');
};
