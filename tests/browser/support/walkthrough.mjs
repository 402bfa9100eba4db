// SPDX-License-Identifier: Apache-2.0
// What a newcomer does in a quarter of an hour, with a mouse or with fingers. After each step its
// effect is visible, and the page is ready for the next one: there is no dead end.
import assert from 'node:assert/strict';
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { confirm, spot, title, until } from './live.mjs';

const folder = process.env.FAIRWAY_SCREENS;

class Visitor {
  constructor(page, touch) {
    this.page = page;
    this.touch = touch;
  }

  press(selector) {
    const target = this.page.locator(selector);
    return this.touch ? target.tap() : target.click();
  }

  /** A control of the header's menu. */
  async menu(selector) {
    if (!(await this.page.locator(selector).isVisible())) await this.press('#show-menu');
    return this.press(selector);
  }

  async choose(selector, label) {
    if (!(await this.page.locator(selector).isVisible())) await this.press('#show-menu');
    await this.page.selectOption(selector, { label });
    await confirm(this.page);
    await this.page.keyboard.press('Escape');
  }

  async at(x, y) {
    await this.page.evaluate(() => document.body.scrollTo(0, 0));
    return spot(this.page, x, y);
  }

  async tap(x, y) {
    const at = await this.at(x, y);
    return this.touch ? this.page.touchscreen.tap(...at) : this.page.mouse.click(...at);
  }

  async drag(from, to) {
    const [a, b] = [await this.at(...from), await this.at(...to)];
    const between = (i) => [0, 1].map((axis) => a[axis] + (b[axis] - a[axis]) * i / 8);
    if (!this.touch) {
      await this.page.mouse.move(...a);
      await this.page.mouse.down();
      for (let i = 1; i <= 8; ++i) await this.page.mouse.move(...between(i));
      return this.page.mouse.up();
    }
    const client = await this.page.context().newCDPSession(this.page);
    const send = (type, touchPoints) => client.send('Input.dispatchTouchEvent', { type, touchPoints });
    await send('touchStart', [{ x: a[0], y: a[1] }]);
    for (let i = 1; i <= 8; ++i) await send('touchMove', [{ x: between(i)[0], y: between(i)[1] }]);
    await send('touchEnd', []);
    return client.detach();
  }

  /** Presses again where a press came while the button was off for a moment, as a person would. */
  async pressUntil(selector, condition) {
    for (let left = 5; ; --left) {
      await this.press(selector);
      const seen = await this.page.waitForFunction(condition, undefined, { timeout: 15000 })
        .then(() => true, () => false);
      if (seen) return;
      if (left === 0) throw new Error(`${selector}: expected an effect, found none`);
    }
  }

  /** A message on the screen, not only in the document. */
  message(pattern) {
    return until(this.page, (source) => {
      const hint = document.getElementById('hint');
      const { left, right, top, bottom } = hint.getBoundingClientRect();
      return new RegExp(source).test(hint.textContent) && hint.checkVisibility({ visibilityProperty: true, opacityProperty: true })
        && left >= 0 && right <= innerWidth + 1 && top >= 0 && bottom <= innerHeight + 1;
    }, pattern.source);
  }

  sees(condition, argument) {
    return until(this.page, condition, argument);
  }
}

const newest = 'window.fairway.run.frames.at(-1)';

/** The steps: name and action; each waits for its visible effect. */
const steps = [
  ['another map, after the question', async (v) => {
    await v.choose('#map-choice', 'Empty hall');
    await title(v.page, 'Empty hall');
  }],
  ['the tools say what they do', async (v) => {
    await v.press('#tool-goal');
    await v.message(/Click to set the goal/);
  }],
  ['a goal', async (v) => {
    await v.tap(6, 9);
    await v.sees(() => Math.hypot(window.fairway.run.plans[0].at(-1).goal.x - 6, window.fairway.run.plans[0].at(-1).goal.y - 9) < 0.3);
  }],
  ['a goal outside the map is refused, with the reason', async (v) => {
    await v.press('#fit');
    await v.tap(-0.4, 5);
    await v.message(/outside the map/);
  }],
  ['pause, one step, on', async (v) => {
    await v.press('#play');
    await v.sees(() => document.getElementById('connection').textContent === 'paused');
    const time = await v.page.evaluate(`${newest}.time`);
    await v.press('#forward');
    await v.sees((before) => window.fairway.run.frames.at(-1).time > before, time);
    await v.press('#play');
    await v.sees(() => document.getElementById('connection').textContent.startsWith('live'));
  }],
  ['an obstacle, undone and redone', async (v) => {
    await v.press('#tool-wall');
    await v.drag([12, 11], [14, 11]);
    await v.sees(() => window.fairway.run.grids[0][0].changes.length > 0);
    await v.sees(() => !document.getElementById('undo').disabled);
    await v.pressUntil('#undo', () => !document.getElementById('redo').disabled);
    await v.pressUntil('#redo', () => document.getElementById('redo').disabled);
  }],
  ['a person, and another robot', async (v) => {
    await v.press('#tool-person');
    await v.tap(16, 4);
    await v.sees(() => window.fairway.run.frames.at(-1).bodies.length === 1);
    await v.press('#tool-robot');
    await v.tap(14, 8);
    await v.sees(() => document.querySelectorAll('.card').length === 2);
  }],
  ['the new robot is chosen, gets a goal as numbers, and is removed', async (v) => {
    await v.press('[data-robot="1"]');
    await v.page.fill('#goal-x-1', '10');
    await v.page.fill('#goal-y-1', '3');
    await v.press('.card:nth-of-type(2) .typed-goal button');
    await v.sees(() => window.fairway.run.plans[1].at(-1)?.goal.x === 10);
    await v.press('.card:nth-of-type(2) .remove_robot');
    await v.sees(() => document.querySelectorAll('.card').length === 1);
  }],
  ['panning, and the whole map again', async (v) => {
    await v.press('#tool-pan');
    const before = await v.page.evaluate(() => window.fairway.camera.x);
    await v.drag([8, 8], [10, 9]);
    await v.sees((x) => window.fairway.camera.x !== x, before);
    await v.press('#fit');
  }],
  ['a distance', async (v) => {
    await v.press('#tool-measure');
    await v.drag([4, 4], [4, 8]);
    await v.message(/^\d\.\d\d m, 90°$/);
    await v.press('#tool-pan');
  }],
  ['the past, replayed, and the present', async (v) => {
    await v.press('#to-start');
    await v.sees(() => document.getElementById('past').checkVisibility() && /Tools are off/.test(document.getElementById('past').textContent));
    await v.press('#play');
    await v.sees(() => window.fairway.time > 0.3);
    await v.press('#past-live');
    await v.sees(() => !document.body.classList.contains('past'));
  }],
  ['an event leads to its time, and Go live back', async (v) => {
    await v.press('#tab-events');
    await v.sees(() => document.querySelectorAll('.event').length > 0);
    await v.press('li:last-child .event');
    await v.sees(() => document.body.classList.contains('past'));
    await v.press('#go-live');
    await v.sees(() => !document.body.classList.contains('past'));
  }],
  ['a setting: refused with the reason, changed, reset', async (v) => {
    await v.press('#tab-settings');
    await v.page.fill('#setting-search', 'linear_max');
    const field = v.page.locator('[data-setting="robot.linear_max"] input[type="text"]');
    await field.fill('-3');
    await field.press('Enter');
    await v.sees(() => /must be/.test(document.querySelector('[data-setting="robot.linear_max"] .refusal').textContent));
    await field.fill('0.8');
    await field.press('Enter');
    await v.sees(() => window.fairway.run.setting('robot', 'linear_max') === 0.8);
    await v.press('[data-setting="robot.linear_max"] .reset');
    await v.sees(() => window.fairway.run.setting('robot', 'linear_max') === 1);
    await v.page.fill('#setting-search', '');
    await v.press('#tab-robots');
  }],
  ['layers, and the meaning of the colours', async (v) => {
    await v.menu('#show-layers');
    await v.press('[data-layer="trail"]');
    await v.sees(() => window.fairway.layers.trail === false);
    assert.match(await v.page.textContent('#layers'), /Status band/);
    await v.page.keyboard.press('Escape');
    await v.sees(() => !document.getElementById('layers').checkVisibility());
  }],
  ['the emergency stop, and its release', async (v) => {
    await v.press('#halt');
    await v.sees(() => document.getElementById('connection').textContent === 'emergency stop');
    await v.press('#halt');
    await v.sees(() => document.getElementById('connection').textContent.startsWith('live'));
  }],
  ['no goal, and a goal again', async (v) => {
    await v.press('.card .cancel');
    await v.sees(() => document.querySelector('.card .pill').textContent === 'No goal');
    await v.press('#tool-goal');
    await v.tap(12, 5);
    await v.sees(() => window.fairway.run.plans[0].at(-1).usable && !window.fairway.run.plans[0].at(-1).dropped);
    await v.press('#tool-pan');
  }],
  ['a lidar instead of the map, after the question', async (v) => {
    await v.choose('#senses', 'Lidar');
    await v.sees(() => window.fairway.run.lidar && window.fairway.run.frames.length > 1);
    await v.choose('#senses', 'Known map');
    await v.sees(() => !window.fairway.run.lidar && window.fairway.run.frames.length > 1);
  }],
  ['dark and light', async (v) => {
    const dark = await v.page.evaluate(() => window.fairway.themes.current.dark);
    await v.menu('#theme');
    await v.sees((before) => window.fairway.themes.current.dark !== before, dark);
    await v.page.keyboard.press('Escape');
  }],
  ['what can be exported', async (v) => {
    await v.menu('#save');
    await v.sees(() => document.querySelectorAll('#saves a').length >= 3 && document.getElementById('saves').checkVisibility());
    await v.page.keyboard.press('Escape');
  }],
  ['a link', async (v) => {
    await v.menu('#share');
    await v.page.keyboard.press('Escape');
    await v.message(/[Ll]ink/);
  }],
  ['the run from its beginning', async (v) => {
    await v.menu('#restart');
    await v.page.keyboard.press('Escape');
    await v.sees(() => window.fairway.run.duration < 3);
  }],
  ['the goal is reached', async (v) => {
    await v.page.selectOption('#speed', '8');
    await v.sees(() => document.querySelector('.card .pill').textContent === 'Goal reached');
  }],
];

/** Walks through all steps. @param name of the pictures, where FAIRWAY_SCREENS asks for them. */
export async function walk(page, { touch = false, name }) {
  const visitor = new Visitor(page, touch);
  let number = 0;
  for (const [step, act] of steps) {
    await act(visitor).catch((error) => {
      error.message = `${step}: ${error.message}`;
      throw error;
    });
    assert.ok(!(await page.locator('dialog[open], .popover:visible, #menu.open').count()), `${step}: nothing is left open`);
    ++number;
    if (!folder) continue;
    await mkdir(folder, { recursive: true });
    await page.screenshot({ path: join(folder, `walk_${name}_${String(number).padStart(2, '0')}.png`) });
  }
}
