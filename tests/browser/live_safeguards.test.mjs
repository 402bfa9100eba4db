// SPDX-License-Identifier: Apache-2.0
// The live page loses nothing silently: the past changes nothing, a run ends only after a question,
// messages are visible on every screen, and no popover covers the tools.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { launch } from './support/browser.mjs';
import { chooseMap, last, until, withLive as liveWith } from './support/live.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());
const withLive = (work, options) => liveWith(browser, work, options);

const landscape = { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true };
const disabled = (page, selector) => page.evaluate((text) => document.querySelector(text).matches(':disabled'), selector);
const past = async (page) => {
  await until(page, () => window.fairway.run.duration > 1);
  await page.click('#to-start');
  await until(page, () => document.body.classList.contains('past'));
};

test('in the past no control changes the present, except for the emergency stop', () => withLive(async (page) => {
  await page.click('#tab-settings');
  await page.click('#body-editor summary');
  await page.fill('#setting-search', 'linear_max');
  await past(page);
  const off = ['#goal-x-0', '.typed-goal button', '.cancel', '.reset_robot', '.remove_robot', '#settings-reset', '#body-apply',
    '#body-shape', '[data-setting="robot.linear_max"] input[type="text"]', '[data-setting="robot.linear_max"] input[type="range"]',
    '#map-choice', '#senses', '#upload', '#restart', '#revert', '#undo', '#redo'];
  for (const selector of off) assert.ok(await disabled(page, selector), `${selector} is off`);
  for (const selector of ['#halt', '#save', '#setting-search', '#past-live', '#speed']) assert.ok(!(await disabled(page, selector)), `${selector} is on`);
  await page.click('#past-live');
  await until(page, () => !document.body.classList.contains('past'));
  for (const selector of off.slice(0, 5)) assert.ok(!(await disabled(page, selector)), `${selector} is on again`);
}));

test('Ctrl+Z undoes nothing while the past is shown', () => withLive(async (page) => {
  const goals = () => page.evaluate(() => window.fairway.run.plans[0].at(-1)?.goal.x);
  await until(page, () => window.fairway.run.plans[0].at(-1)?.usable);
  await page.fill('#goal-x-0', '6.5');
  await page.fill('#goal-y-0', '9');
  await page.click('.typed-goal button');
  await until(page, () => window.fairway.run.plans[0].at(-1).goal.x === 6.5);
  await until(page, () => !document.getElementById('undo').disabled);
  await past(page);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+y');
  // The stop, which acts also in the past, is the last command: all commands before it were served.
  await page.click('#halt');
  await until(page, () => document.getElementById('halt').getAttribute('aria-pressed') === 'true');
  assert.equal(await goals(), 6.5);
  await page.click('#halt'); // the release
  await page.click('#past-live');
  await page.keyboard.press('Control+z');
  await until(page, () => window.fairway.run.plans[0].at(-1).goal.x !== 6.5);
}));

test('another map, other sensing and discarding ask before a run is lost; Cancel keeps it', () => withLive(async (page) => {
  await page.selectOption('#speed', '8');
  await until(page, () => window.fairway.run.duration > 6);
  const sensing = await page.evaluate(() => document.getElementById('senses').selectedIndex);
  for (const [selector, choice] of [['#map-choice', { label: 'Clutter, 20 m' }], ['#senses', { label: 'Lidar' }]]) {
    await page.selectOption(selector, choice);
    assert.match(await page.textContent('#confirm'), /run of \d+\.\d s.*(is|will be) lost/s);
    await page.click('#confirm-cancel');
    assert.ok(!(await page.isVisible('#confirm')));
  }
  assert.equal(await page.evaluate(() => document.getElementById('senses').selectedIndex), sensing, 'the choice is put back');
  assert.equal(await page.textContent('#title'), 'Empty hall');
  assert.ok((await last(page)).time > 6, 'the run goes on');
  await chooseMap(page, 'Clutter, 20 m');
  assert.ok((await last(page)).time < 6);
}));

test('on a phone in landscape each message is visible as a toast over the map', () => withLive(async (page) => {
  await page.click('#tool-goal');
  const shown = () => {
    const hint = document.getElementById('hint');
    const box = hint.getBoundingClientRect();
    return hint.checkVisibility({ opacityProperty: true }) && box.height > 10 && box.top >= 0 && box.bottom <= innerHeight
      && document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2) !== null;
  };
  await until(page, shown);
  assert.match(await page.textContent('#hint'), /Click to set the goal/);
  await page.click('#tool-pan');
  await page.evaluate(() => window.fairway.say('The server refused this.'));
  await until(page, shown);
}, landscape));

for (const [name, options] of Object.entries({ laptop: { viewport: { width: 1280, height: 720 } }, landscape })) {
  test(`popovers do not cover the tools: ${name}`, () => withLive(async (page) => {
    for (const [button, panel] of [['#show-layers', '#layers'], ['#show-help', '#help'], ['#save', '#saves']]) {
      await page.click('#show-menu');
      await page.click(button);
      assert.ok(await page.isVisible(panel));
      const [tools, box] = [await page.locator('#bar').boundingBox(), await page.locator(panel).boundingBox()];
      assert.ok(box.y >= tools.y + tools.height - 1, `${panel} begins at ${box.y}, the tools end at ${tools.y + tools.height}`);
      assert.ok(box.height > 60 && box.y + box.height <= options.viewport.height, `${panel} is on the screen`);
      await page.keyboard.press('Escape');
    }
  }, options));
}
