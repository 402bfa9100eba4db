// SPDX-License-Identifier: Apache-2.0
// The replay page, opened from disk: uses every control and checks its effect.
import assert from 'node:assert/strict';
import test from 'node:test';
import { camera, picture, time, useRun, withPage } from './support/replay_page.mjs';

useRun();

test('plays, pauses, and runs at the selected speed', () => withPage(async (page) => {
  // The median of the run's seconds per second between pictures. After a slow picture the page
  // advances by a quarter of a second.
  const pace = () => page.evaluate(() => new Promise((done) => {
    const paces = [];
    let last = null;
    const look = (now) => {
      const { time } = window.fairway;
      if (last) paces.push((time - last.time) / Math.min((now - last.now) / 1e3, 0.25));
      last = { now, time };
      if (paces.length < 15) requestAnimationFrame(look);
      else done(paces.sort((a, b) => a - b)[7]);
    };
    requestAnimationFrame(look);
  }));
  await page.click('#play');
  await page.waitForFunction(() => window.fairway.time > 0.2);
  assert.ok(Math.abs(await pace() - 1) < 0.1);
  await page.selectOption('#speed', '8');
  assert.ok(Math.abs(await pace() - 8) < 0.8);
  await page.click('#play');
  const stopped = await time(page);
  await page.evaluate(async () => {
    for (let n = 0; n < 12; ++n) await new Promise((done) => requestAnimationFrame(done));
  });
  assert.equal(await time(page), stopped);
  assert.equal(await page.getAttribute('#play', 'aria-label'), 'Play');
}));

test('steps, jumps to start and end, and plays again from the end', () => withPage(async (page) => {
  await page.click('#forward');
  await page.click('#forward');
  assert.ok(Math.abs(await time(page) - 0.2) < 1e-6);
  await page.click('#back');
  assert.ok(Math.abs(await time(page) - 0.1) < 1e-6);
  await page.click('#to-end');
  assert.equal(await time(page), 60);
  await page.waitForFunction(() => document.getElementById('clock').textContent === '60.0 / 60.0 s');
  await page.click('#play');
  await page.waitForFunction(() => window.fairway.time > 0 && window.fairway.time < 50);
  await page.click('#play');
  await page.click('#to-start');
  assert.equal(await time(page), 0);
}));

test('the slider and the plots select the time', () => withPage(async (page) => {
  const slider = page.locator('#time');
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.ok(Math.abs(await time(page) - 30) < 2);
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs(await time(page) - 30) < 2);
  const plots = await page.locator('#plots').boundingBox();
  await page.mouse.move(plots.x + plots.width * 0.25, plots.y + 60);
  await page.mouse.down();
  const early = await time(page);
  assert.ok(Math.abs(early - 14) < 2, `${early}`);
  await page.mouse.move(plots.x + plots.width * 0.75, plots.y + 60);
  await page.mouse.up();
  assert.ok(Math.abs(await time(page) - 45) < 2);
}));

test('keys do what the buttons do', () => withPage(async (page) => {
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs(await time(page) - 0.1) < 1e-6);
  await page.keyboard.press('Shift+ArrowRight');
  assert.ok(Math.abs(await time(page) - 1.1) < 1e-6);
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  assert.ok(await time(page) < 0.05);
  await page.keyboard.press('End');
  assert.equal(await time(page), 60);
  await page.keyboard.press('Home');
  assert.equal(await time(page), 0);
  await page.keyboard.press(' ');
  await page.waitForFunction(() => window.fairway.time > 0.1);
  await page.keyboard.press(' ');
  await page.keyboard.press('2');
  assert.equal(await page.evaluate(() => window.fairway.selected), 1);
  const { scale } = await camera(page);
  await page.keyboard.press('+');
  assert.ok((await camera(page)).scale > 1.2 * scale);
  await page.keyboard.press('-');
  const before = await camera(page);
  await page.keyboard.press('d');
  assert.ok((await camera(page)).x > before.x);
  await page.keyboard.press('f');
  assert.ok(Math.abs((await camera(page)).scale - scale) < 1e-9);
  await page.keyboard.press('?');
  assert.ok(await page.isVisible('#help'));
  await page.keyboard.press('l');
  assert.ok(await page.isVisible('#layers') && !(await page.isVisible('#help')));
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('#layers')));
}));

test('the map zooms about the pointer, pans, and fits again', () => withPage(async (page) => {
  const start = await camera(page);
  const box = await page.locator('#map').boundingBox();
  // Whole pixels, because wheel events have no others.
  const at = { x: Math.round(box.x + box.width * 0.6), y: Math.round(box.y + box.height * 0.4) };
  const world = () => page.evaluate(({ x, y }) => window.fairway.camera.toWorld({ x, y }), { x: at.x - box.x, y: at.y - box.y });
  const fixed = await world();
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction((s) => window.fairway.camera.scale > 1.5 * s, start.scale);
  const now = await world();
  assert.ok(Math.hypot(now.x - fixed.x, now.y - fixed.y) < 1e-6);
  await page.mouse.down();
  await page.mouse.move(at.x + 80, at.y + 50, { steps: 4 });
  await page.mouse.up();
  const moved = await world();
  const { scale } = await camera(page);
  assert.ok(Math.abs(fixed.x - moved.x - 80 / scale) < 0.02);
  for (const [button, larger] of [['#zoom-in', true], ['#zoom-out', false]]) {
    const before = (await camera(page)).scale;
    await page.click(button);
    assert.equal((await camera(page)).scale > before, larger);
  }
  await page.click('#fit');
  assert.deepEqual(await camera(page), start);
}));

test('every layer is drawn, and can be hidden', () => withPage(async (page) => {
  await page.evaluate(() => window.fairway.onSeek(20));
  await page.click('#show-layers');
  const all = await picture(page);
  // Reasons are drawn for robots that cannot drive only.
  const layers = await page.locator('#layers label:not([hidden]) [data-layer]:not([data-layer="reasons"])').all();
  assert.equal(layers.length, 8);
  for (const layer of layers) {
    await layer.uncheck();
    assert.notEqual(await picture(page), all, await layer.getAttribute('data-layer'));
    await layer.check();
    assert.equal(await picture(page), all, await layer.getAttribute('data-layer'));
  }
}));

test('the map changes with time, forwards and backwards', () => withPage(async (page) => {
  for (const box of await page.locator('#layers input').all()) {
    await box.evaluate((input) => { input.checked = true; input.click(); });
  }
  const changes = await page.evaluate(() => window.fairway.run.grids[0][0].changes.length);
  assert.ok(changes > 10);
  const corner = () => page.evaluate(() => {
    const { camera, run } = window.fairway;
    const { frame, changes: list } = run.grids[0][0];
    const [y, x] = list[0].runs;
    const p = camera.toScreen({ x: frame.origin.x + (x + 0.5) * frame.resolution, y: frame.origin.y + (y + 0.5) * frame.resolution });
    const map = document.getElementById('map');
    return [...map.getContext('2d').getImageData(Math.round(p.x * devicePixelRatio), Math.round(p.y * devicePixelRatio), 1, 1).data];
  });
  const seek = async (t) => {
    await page.evaluate((to) => window.fairway.onSeek(to), t);
    await picture(page);
  };
  await seek(0);
  const free = await corner();
  await seek(1);
  const blocked = await corner();
  assert.notDeepEqual(free, blocked);
  await seek(0);
  assert.deepEqual(await corner(), free);
}));

test('robots are selected by their cards and on the map', () => withPage(async (page) => {
  const before = await picture(page);
  await page.click('[data-robot="2"]');
  await page.waitForSelector('[data-robot="2"][aria-pressed="true"]');
  assert.notEqual(await picture(page), before);
  const at = await page.evaluate(() => {
    const { camera, moment } = window.fairway;
    return camera.toScreen(moment.poses[1]);
  });
  const box = await page.locator('#map').boundingBox();
  await page.mouse.click(box.x + at.x, box.y + at.y);
  await page.waitForSelector('[data-robot="1"][aria-pressed="true"]');
  assert.match(await page.textContent('.card.selected .why'), /(Limited by|Active constraint): Corridor/);
}));
