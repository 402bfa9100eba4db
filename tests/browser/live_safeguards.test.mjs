// SPDX-License-Identifier: Apache-2.0
// The live page loses nothing silently: the past changes nothing, a run ends only after a question,
// messages are visible on every screen, and no popover covers the tools.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { launch } from './support/browser.mjs';
import { chooseMap, confirm, last, until, withLive as liveWith } from './support/live.mjs';

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

test('status and plots are also tables', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.duration > 2);
  await page.click('#tab-values');
  await until(page, () => document.querySelectorAll('.values').length === 2);
  const [status, values] = await page.evaluate(() => [...document.querySelectorAll('.values')].map((table) => ({
    caption: table.caption.textContent, head: [...table.tHead.rows[0].cells].map((cell) => cell.textContent),
    rows: [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent)),
  })));
  assert.deepEqual(status.head, ['From', 'To', 'Status']);
  assert.ok(status.rows.some(([, , label]) => label === 'Driving'), JSON.stringify(status.rows));
  assert.deepEqual(values.head, ['Time', 'Status', 'Speed, command', 'Speed, actual', 'Clearance, to obstacles', 'Clearance, to people and robots']);
  const wanted = await page.evaluate(() => {
    const { run } = window.fairway;
    return `${run.frames[run.frameIndex(1)].robots[0].cycle.linear.toFixed(2)} m/s`;
  });
  assert.equal(values.rows.find(([time]) => time === '1.0 s')[3], wanted);
  assert.equal(await page.getAttribute('#plots', 'aria-details'), 'tab-values');
}));

test('the body editor has discs, and a preset sets body and limits together', () => withLive(async (page) => {
  await page.click('#tab-settings');
  await page.click('#body-editor summary');
  await page.selectOption('#body-shape', 'discs');
  await page.fill('#body-discs', '0.3 0 0.2\n-0.2 0');
  assert.ok(await page.isDisabled('#body-apply'), 'half a disc cannot be applied');
  await page.fill('#body-discs', '0.3 0 0.2\n-0.2 0 0.3');
  await page.click('#body-apply');
  await until(page, () => window.fairway.run.body.discs.length === 2);
  assert.equal(await page.evaluate(() => window.fairway.run.setting('robot', 'radius')), 0.5);
  for (const [label, length, speed] of [['MiR600, 1.35 × 0.91 m', 1.35, 1.5], ['Jackal, 0.458 × 0.416 m', 0.458, 2], ['Large platform, 1.8 × 1.2 m', 1.8, 1.2]]) {
    await page.selectOption('#body-preset', { label });
    await page.click('#body-apply');
    await until(page, ([l, v]) => window.fairway.run.setting('robot', 'length') === l && window.fairway.run.setting('robot', 'linear_max') === v, [length, speed]);
  }
  await page.selectOption('#body-preset', { label: 'L-shaped cart, three discs' });
  await page.click('#body-apply');
  await until(page, () => window.fairway.run.body.discs.length === 3);
}));

test('the legend of a robot with a lidar explains walls over the corridor; the status band has every status', () => withLive(async (page) => {
  await page.selectOption('#senses', { label: 'Lidar' }, { force: true });
  await confirm(page);
  await until(page, () => window.fairway.run.lidar && window.fairway.run.frames.length > 1);
  await page.click('#show-layers');
  const text = await page.textContent('#layers');
  assert.match(text, /True wall, drawn over the corridor/);
  for (const guide of await page.evaluate(() => window.fairway.run.begin.status_guides.map(({ label }) => label))) assert.ok(text.includes(guide), guide);
}));
