// SPDX-License-Identifier: Apache-2.0
// Zones that are drawn on the live page, and changed there.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { launch } from './support/browser.mjs';
import { click, drag, pause, until, withLive as liveWith } from './support/live.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());
const withLive = (work, options) => liveWith(browser, work, options);

const zones = (page) => page.evaluate(() => window.fairway.run.zonesAt(Infinity));
const near = (a, b) => Math.abs(a - b) < 0.1;

test('a zone is drawn, changed, moved, undone and removed, in a paused world too', () => withLive(async (page) => {
  await pause(page);
  await page.click('#tool-zone');
  assert.ok(await page.isVisible('#zone-kind') && !(await page.isVisible('#zone-remove')));
  await drag(page, [8, 9], [11, 12]);
  await until(page, () => window.fairway.run.zonesAt(Infinity).length === 1);
  const [drawn] = await zones(page);
  assert.equal(drawn.kind, 'keep_out');
  assert.equal(drawn.polygon.length, 4);
  assert.ok(drawn.polygon.some(([x, y]) => near(x, 11) && near(y, 12)));
  // The new zone is chosen: its rule and its corners can be changed.
  await page.selectOption('#zone-kind', 'speed_limit');
  await until(page, () => window.fairway.run.zonesAt(Infinity)[0].kind === 'speed_limit');
  await page.fill('#zone-speed', '0.2');
  await page.press('#zone-speed', 'Tab');
  await until(page, () => window.fairway.run.zonesAt(Infinity)[0].speed === 0.2);
  await page.click('#zone-corner');
  await until(page, () => window.fairway.run.zonesAt(Infinity)[0].polygon.length === 5);
  const moved = (await zones(page))[0].polygon.findIndex(([x, y]) => near(x, 11) && near(y, 12));
  await drag(page, [11, 12], [12, 12.5]);
  await until(page, (i) => Math.abs(window.fairway.run.zonesAt(Infinity)[0].polygon[i][0] - 12) < 0.1, moved);
  await drag(page, [9.3, 10.2], [10.3, 10.2]);
  await until(page, (i) => Math.abs(window.fairway.run.zonesAt(Infinity)[0].polygon[i][0] - 13) < 0.1, moved);
  await page.click('#undo');
  await until(page, (i) => Math.abs(window.fairway.run.zonesAt(Infinity)[0].polygon[i][0] - 12) < 0.1, moved);
  // A click beside it chooses none, a click inside chooses it again.
  await click(page, 4, 4);
  await until(page, () => document.getElementById('zone-remove').hidden);
  await click(page, 9.3, 10.2);
  await until(page, () => !document.getElementById('zone-remove').hidden);
  assert.equal(await page.inputValue('#zone-speed'), '0.2');
  await page.click('#zone-remove');
  await until(page, () => window.fairway.run.zonesAt(Infinity).length === 0);
}));

test('a zone that cannot be is refused at its place', () => withLive(async (page) => {
  await page.click('#tool-zone');
  await drag(page, [8, 9], [11, 12]);
  await until(page, () => window.fairway.run.zonesAt(Infinity).length === 1);
  await drag(page, [8, 9], [13, 10]); // its sides would cross
  await until(page, () => /^Zone: polygon: expected/.test(document.getElementById('hint').textContent));
  assert.ok(near((await zones(page))[0].polygon[0][0], 8));
}));

test('robots obey a zone as soon as it is drawn', () => withLive(async (page) => {
  await page.selectOption('#speed', '4');
  await page.click('#tool-zone');
  await page.selectOption('#zone-kind', 'speed_limit');
  await page.fill('#zone-speed', '0.15');
  await page.press('#zone-speed', 'Tab');
  await drag(page, [0.5, 0.5], [15.5, 15.5]);
  await until(page, () => window.fairway.run.zonesAt(Infinity).length === 1);
  await page.click('#tool-goal');
  await click(page, 10, 10);
  const speeds = () => window.fairway.run.frames.at(-1).robots[0].cycle?.commandLinear;
  await until(page, () => {
    const cycle = window.fairway.run.frames.at(-1).robots[0].cycle;
    return cycle && window.fairway.run.begin.limits[cycle.limit] === 'speed zone' && cycle.linear > 0.1 && cycle.linear < 0.151;
  });
  assert.ok(await page.evaluate(speeds) < 0.151);
}));

test('zones by keyboard', () => withLive(async (page) => {
  await page.focus('#map');
  await page.keyboard.press('z');
  assert.equal(await page.getAttribute('#tool-zone', 'aria-pressed'), 'true');
  await page.focus('#map');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+Enter');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await until(page, () => window.fairway.run.zonesAt(Infinity).length === 1);
}));

test('a robot that is added to a paused world is shown at once, and the others keep their values', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].cycle?.linear > 0.2);
  await pause(page);
  const before = await page.evaluate(() => window.fairway.run.frames.at(-1).robots[0].cycle.linear);
  await page.click('#tool-robot');
  await click(page, 3, 12);
  await until(page, () => window.fairway.run.frames.at(-1).robots.length === 2);
  assert.equal(await page.evaluate(() => window.fairway.run.frames.at(-1).robots[0].cycle.linear), before);
  const { x, y } = await page.evaluate(() => window.fairway.run.frames.at(-1).robots[1]);
  assert.ok(near(x, 3) && near(y, 12));
}));
