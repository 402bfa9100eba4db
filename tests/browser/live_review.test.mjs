// SPDX-License-Identifier: Apache-2.0
// The live page for an engineer who stays for an hour: nothing is silent, nothing is lost, and the
// past looks like the past. Each test holds a point of the review of the pages.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { launch, openPage } from './support/browser.mjs';
import { camera } from './support/replay_page.mjs';
import { cellAt, cellBecomes, click, confirm, drag, last, pause, spot, until, withLive as liveWith } from './support/live.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());
const withLive = (work, options) => liveWith(browser, work, options);

const setting = (page, group, name) => page.evaluate(([g, n]) => window.fairway.run.setting(g, n), [group, name]);
const hint = (page) => page.textContent('#hint');

test('a rectangular body is one change', () => withLive(async (page) => {
  await page.click('#tab-settings');
  await page.click('#body-editor summary');
  await page.selectOption('#body-shape', 'rectangle');
  await page.fill('#body-length', '0.8');
  await page.fill('#body-width', '0.5');
  assert.match(await page.getAttribute('.preview', 'aria-label'), /0\.8 by 0\.5 m/);
  await page.click('#body-apply');
  await until(page, () => window.fairway.run.setting('robot', 'length') === 0.8);
  assert.equal(await setting(page, 'robot', 'width'), 0.5);
  assert.equal(await setting(page, 'robot', 'radius'), 0.472);
  await page.selectOption('#body-preset', { label: 'TurtleBot, disc 0.36 m' });
  await page.click('#body-apply');
  await until(page, () => window.fairway.run.setting('robot', 'radius') === 0.18);
  assert.equal(await setting(page, 'robot', 'length'), 0);
}));

test('the past looks like the past: banner, tools off, Play replays, and the map does not jump', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.duration > 2);
  const before = await camera(page);
  await page.click('#tool-goal');
  await page.click('#to-start');
  await until(page, () => /Viewing 0\.\d s; the world is at/.test(document.getElementById('past').textContent));
  await until(page, () => /^viewing/.test(document.getElementById('connection').textContent));
  assert.ok(await page.isDisabled('#tool-goal') && await page.isDisabled('#tool-wall') && await page.isEnabled('#tool-measure'));
  assert.equal(await page.getAttribute('#tool-pan', 'aria-pressed'), 'true');
  const { time } = await last(page);
  await page.click('#play');
  await until(page, () => window.fairway.time > 0.4);
  await page.click('#play');
  const replayed = await page.evaluate(() => window.fairway.time);
  await until(page, (t) => window.fairway.run.duration > t + 0.3, time);
  assert.equal(await page.evaluate(() => window.fairway.time), replayed, 'Play acts on the past only');
  assert.deepEqual(await camera(page), before);
  await page.click('#past-live');
  await until(page, () => window.fairway.run.duration - window.fairway.time < 0.5);
  assert.ok(!(await page.isVisible('#past')) && await page.isEnabled('#tool-goal'));
  assert.deepEqual(await camera(page), before);
}));

test('a drag pans at first; Escape returns to panning', () => withLive(async (page) => {
  const goal = () => page.evaluate(() => window.fairway.run.frames.at(-1).robots[0].plan.goal);
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].plan?.usable);
  const [before, view] = [await goal(), await camera(page)];
  await drag(page, [8, 8], [10, 9]);
  assert.notEqual((await camera(page)).x, view.x);
  assert.deepEqual(await goal(), before);
  await page.click('#tool-goal');
  await page.keyboard.press('Escape');
  assert.equal(await page.getAttribute('#tool-pan', 'aria-pressed'), 'true');
}));

test('edits can be undone and redone: goal, obstacle, person, pose, robot', () => withLive(async (page) => {
  await pause(page);
  assert.ok(await page.isDisabled('#undo'));
  await page.click('#tool-wall');
  await drag(page, [9, 9], [12, 9]);
  await until(page, () => window.fairway.run.grids[0][0].changes.length > 0);
  await cellBecomes(page, 11.9, 9, 1);
  await page.click('#undo');
  await cellBecomes(page, 11.9, 9, 0);
  assert.equal(await cellAt(page, 9.2, 9), 0, 'a stroke is undone as a whole');
  await page.keyboard.press('Control+y');
  await cellBecomes(page, 9.2, 9, 1);
  await page.click('#tool-goal');
  await click(page, 5, 11);
  const goalIsAt = (x) => Math.abs(window.fairway.run.plans[0].at(-1).goal.x - x) < 0.1;
  await until(page, goalIsAt, 5);
  await page.keyboard.press('Control+z');
  await until(page, goalIsAt, 17);
  await page.click('#tool-robot');
  await click(page, 4, 12);
  await until(page, () => window.fairway.run.begin.robots.length === 2);
  await page.click('#undo');
  await page.click('#forward');
  await until(page, () => window.fairway.run.frames.at(-1).robots[1]?.absent);
  await page.click('#redo');
  await page.click('#forward');
  await until(page, () => window.fairway.run.frames.at(-1).robots[1]?.absent === false);
}));

test('what cannot be is refused at the cursor, with the reason', () => withLive(async (page) => {
  await page.click('#zoom-out');
  await page.click('#tool-goal');
  await click(page, -1, 5);
  await until(page, () => /outside the map/.test(document.getElementById('hint').textContent));
  await page.click('#tool-wall');
  await drag(page, [8, 8], [8.4, 8]);
  await cellBecomes(page, 8.2, 8, 1);
  for (const [tool, reason] of [['pose', /does not fit here: its body overlaps an obstacle by/], ['robot', /does not fit/], ['person', /0\.30 m are needed/]]) {
    await page.click(`#tool-${tool}`);
    await click(page, 8.2, 8);
    await until(page, (text) => new RegExp(text).test(document.getElementById('hint').textContent), reason.source);
  }
  const { robots, bodies } = await last(page);
  assert.ok(robots.length === 1 && bodies.length === 0);
}));

test('a collision says who, where and how fast; Reset robot goes on', () => withLive(async (page) => {
  await page.click('.cancel');
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].plan?.dropped);
  await until(page, () => Math.abs(window.fairway.run.frames.at(-1).robots[0].cycle?.linear ?? 1) < 0.01);
  const { robots: [{ x, y }] } = await last(page);
  await page.click('#tool-person');
  await click(page, x + 2, y);
  await until(page, () => window.fairway.run.frames.at(-1).bodies.length === 1);
  await drag(page, [x + 2, y], [x, y]);
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].collided);
  await until(page, () => /Collided with person 1, removed from the run/.test(document.querySelector('.card .why').textContent));
  assert.match(await page.textContent('.card .detail'), /At \d+\.\d s near \(.*\): the robot did not drive towards it; person 1 moved into it at 1\.\d\d m\/s/);
  await page.click('#tool-goal');
  await click(page, 12, 4);
  await until(page, () => /has collided and cannot drive\. Reset it first/.test(document.getElementById('hint').textContent));
  await page.click('#tool-erase');
  await click(page, x, y);
  await page.click('.reset_robot');
  await until(page, () => !window.fairway.run.frames.at(-1).robots[0].collided);
  await page.click('#tool-goal');
  await click(page, 12, 4);
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].cycle?.linear > 0.2);
}));

test('at full speed nothing reads as a fault', () => withLive(async (page) => {
  await until(page, () => window.fairway.moment?.frame.robots[0].cycle?.linear > 0.99);
  await until(page, () => /Unconstrained|Active constraint/.test(document.querySelector('.card .why').textContent));
  assert.equal(await page.locator('.card .why b.bad').count(), 0);
}));

test('a robot without a goal says so', () => withLive(async (page) => {
  await page.click('#tool-robot');
  await click(page, 4, 10);
  await until(page, () => document.querySelectorAll('.card').length === 2);
  await until(page, () => document.querySelectorAll('.card .pill')[1].textContent === 'No goal');
}));

test('a refused setting is put back, explained beside it, and forgotten after a success', () => withLive(async (page) => {
  await page.click('#tab-settings');
  await page.fill('#setting-search', 'radius');
  const row = page.locator('[data-setting="robot.radius"]');
  await row.locator('input[type="text"]').fill('50');
  await row.locator('input[type="text"]').press('Enter');
  await row.locator('.refusal').waitFor();
  assert.match(await row.locator('.refusal').textContent(), /^Radius must be between 0\.01 and 10 m \(got 50\)\.$/);
  assert.equal(await row.locator('input[type="text"]').inputValue(), '0.25');
  await row.locator('input[type="text"]').fill('0.3');
  await row.locator('input[type="text"]').press('Enter');
  await until(page, () => window.fairway.run.setting('robot', 'radius') === 0.3);
  assert.ok(!(await row.locator('.refusal').isVisible()));
  await page.fill('#setting-search', '');
  const discs = page.locator('[data-setting="robot.discs"]');
  await page.click('[data-group="robot"] summary');
  if (!(await discs.isVisible())) await page.click('[data-group="robot"] summary');
  await discs.locator('input').fill('nonsense');
  await discs.locator('input').press('Enter');
  await discs.locator('.refusal').waitFor();
  assert.equal(await discs.locator('input').inputValue(), '[]');
}));

test('settings are searched, marked where they differ from the defaults also after a reload, and reset', () => withLive(async (page) => {
  await page.click('#tab-settings');
  await page.fill('#setting-search', 'linear max');
  const row = page.locator('[data-setting="robot.linear_max"]');
  assert.match(await row.textContent(), /Maximum linear.*linear_max/s);
  assert.ok(!(await page.locator('[data-setting="mpc.horizon"]').isVisible()));
  await row.locator('input[type="text"]').fill('0.4');
  await row.locator('input[type="text"]').press('Enter');
  await until(page, () => document.querySelector('[data-setting="robot.linear_max"]').classList.contains('changed'));
  await page.reload();
  await until(page, () => window.fairway?.drawn > 0);
  await until(page, () => document.querySelector('[data-setting="robot.linear_max"]')?.classList.contains('changed'));
  await page.click('#tab-settings');
  await page.check('#settings-changed');
  assert.ok(await row.isVisible());
  await row.locator('.reset').click();
  await until(page, () => window.fairway.run.setting('robot', 'linear_max') === 1);
}));

test('the world begins with its first viewer', async () => {
  const { serve } = await import('./support/server.mjs');
  const server = await serve();
  // Requests without a viewer do not start it.
  for (const begin = Date.now(); Date.now() - begin < 1500;) await (await fetch(server.url)).arrayBuffer();
  const { page, context } = await openPage(browser, server.url);
  await until(page, () => window.fairway?.run?.frames.length > 1);
  assert.ok(await page.evaluate(() => window.fairway.run.frames[1].time) < 0.5);
  assert.ok(await page.evaluate(() => window.fairway.run.duration) < 1.5);
  await context.close();
  await server.stop();
});

test('drawn obstacles are kept when another map is chosen, and can be discarded; the theme outlives a reload', () => withLive(async (page) => {
  await pause(page);
  await page.click('#tool-wall');
  await drag(page, [9, 9], [9.5, 9]);
  await cellBecomes(page, 9.2, 9, 1);
  await page.click('#theme');
  await page.selectOption('#map-choice', { label: 'Clutter, 20 m' });
  await confirm(page);
  await until(page, () => document.getElementById('title').textContent === 'Clutter, 20 m');
  await page.selectOption('#map-choice', { label: 'Empty hall' });
  await confirm(page);
  await until(page, () => document.getElementById('title').textContent === 'Empty hall');
  assert.equal(await cellAt(page, 9.2, 9), 1);
  await page.click('#revert');
  await confirm(page);
  await cellBecomes(page, 9.2, 9, 0);
  await page.reload();
  await until(page, () => window.fairway?.drawn > 0);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
}));

test('why there is no path: the gap with its width and the needed width, in words and on the map', () => withLive(async (page) => {
  await pause(page);
  await page.click('#tool-wall');
  await page.fill('#brush', '0.1');
  await drag(page, [10, 14.9], [10, 7.7]);
  await drag(page, [10, 7.1], [10, 0.1]);
  await until(page, () => window.fairway.run.plans[0].at(-1)?.obstruction?.kind === 'gap');
  await page.click('#forward');
  await until(page, () => /^No path: every route is narrower than 0\.5\d m/.test(document.querySelector('.card .why').textContent));
  assert.match(await page.textContent('.card .detail'), /gap of 0\.\d\d m at \((9|10)\.\d+, 7\.\d+\)/);
  await until(page, () => /every route is narrower/.test(document.getElementById('map').getAttribute('aria-label')));
  const found = await page.evaluate(() => window.fairway.run.plans[0].at(-1).obstruction);
  assert.ok(Math.hypot(found.x - 10, found.y - 7.4) < 0.3 && found.found < found.needed);
}));

test('a robot that waits names whom it waits for', () => withLive(async (page) => {
  await pause(page);
  await page.click('#tool-wall');
  // A dead end 0.8 m wide with a person in it: no path leads around.
  await drag(page, [6, 6.6], [14, 6.6], [14, 8.0], [6, 8.0]);
  await cellBecomes(page, 6.2, 8.0, 1);
  await page.click('#tool-pose');
  await drag(page, [5, 7.3], [6.5, 7.3]);
  await page.click('#tool-person');
  await click(page, 10, 7.3);
  await until(page, () => window.fairway.run.frames.at(-1).bodies.length === 1);
  await page.click('#tool-goal');
  await click(page, 12.5, 7.3);
  await page.click('#play');
  await until(page, () => /(Waiting for|Limited by): person 1/.test(document.querySelector('.card .why').textContent));
}));

test('cancel and emergency stop', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].cycle?.linear > 0.5);
  await page.click('#halt');
  await until(page, () => document.getElementById('connection').textContent === 'emergency stop');
  await until(page, () => {
    const { frames } = window.fairway.run;
    if (frames.length < 6) return false;
    const [a, b] = [frames.at(-1).robots[0], frames.at(-6).robots[0]];
    return Math.hypot(a.x - b.x, a.y - b.y) < 1e-3;
  });
  await page.click('#halt');
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].cycle?.linear > 0.3);
  await page.click('.cancel');
  await until(page, () => document.querySelector('.card .pill').textContent === 'No goal');
  assert.equal(await page.textContent('[data-value="goal"]'), 'none');
}));

test('goals as numbers, coordinates under the pointer, follow, measure', () => withLive(async (page) => {
  await page.fill('#goal-x-0', '6.5');
  await page.fill('#goal-y-0', '9.25');
  await page.fill('#goal-heading-0', '90');
  await page.click('.typed-goal button');
  await until(page, () => window.fairway.run.plans[0].at(-1)?.goal.x === 6.5);
  const goal = await page.evaluate(() => window.fairway.run.plans[0].at(-1).goal);
  assert.ok(goal.y === 9.25 && Math.abs(goal.heading - Math.PI / 2) < 1e-3);
  await page.mouse.move(...await spot(page, 3, 4));
  await until(page, () => /^x [23]\.\d\d, y [34]\.\d\d m · free$/.test(document.getElementById('where').textContent));
  await page.click('#tool-measure');
  await drag(page, [4, 4], [4, 8]);
  assert.match(await hint(page), /^(3\.9|4\.0)\d m, 90°$/);
  await page.click('#follow');
  await until(page, () => {
    const { camera, moment } = window.fairway;
    return Math.hypot(camera.x - moment.poses[0].x, camera.y - moment.poses[0].y) < 0.05;
  });
}));

test('events are listed, and lead to their time', () => withLive(async (page) => {
  await page.selectOption('#speed', '8');
  await until(page, () => window.fairway.run.duration > 6);
  await page.click('#tool-goal');
  await click(page, 6, 12);
  await page.click('#tab-events');
  await until(page, () => document.querySelectorAll('.event').length >= 2);
  const first = page.locator('.event').last();
  const time = Number.parseFloat(await first.locator('.when').textContent());
  await first.click();
  assert.ok(Math.abs(await page.evaluate(() => window.fairway.time) - time) < 0.06);
  assert.ok(await page.isVisible('#past'));
}));

test('20 robots are a table, each with a colour of its own', () => withLive(async (page, server) => {
  await pause(page);
  await page.click('#tool-robot');
  for (let i = 0; i < 19; ++i) await click(page, 4 + (i % 7) * 2, 5 + Math.floor(i / 7) * 3);
  await until(page, () => window.fairway.run.begin.robots.length === 20);
  await until(page, () => document.querySelectorAll('.fleet tbody tr').length === 20);
  assert.equal(await page.locator('.card:visible').count(), 1);
  await page.click('.fleet tbody tr:nth-child(5) button');
  await until(page, () => window.fairway.selected === 4);
  const colors = await page.evaluate(() => [...document.querySelectorAll('.fleet .dot')].map((dot) => dot.style.background));
  assert.equal(new Set(colors).size, 20, 'no two robots share a colour');
  assert.ok(server.alive());
}));

test('a link shows the same time, robot, view and layers', () => withLive(async (page, server) => {
  await until(page, () => window.fairway.run.duration > 2);
  await page.evaluate(() => { window.fairway.onSeek(1); });
  await page.click('#zoom-in');
  await page.click('#show-layers');
  await page.uncheck('[data-layer="trail"]');
  await page.keyboard.press('Escape');
  await page.click('#share');
  await until(page, () => location.hash.includes('t=1.00'));
  const link = page.url();
  const { page: other, context } = await openPage(browser, link);
  await until(other, () => window.fairway?.drawn > 0);
  await until(other, () => Math.abs(window.fairway.time - 1) < 0.01);
  const [a, b] = [await camera(page), await camera(other)];
  assert.ok(Math.abs(a.x - b.x) < 0.01 && Math.abs(a.scale - b.scale) < 0.1);
  assert.equal(await other.evaluate(() => window.fairway.layers.trail), false);
  assert.equal(new URL(link).port, `${server.port}`);
  await context.close();
}));

test('everything on the map by keyboard', () => withLive(async (page) => {
  await page.click('#tool-goal');
  await page.focus('#map');
  await page.keyboard.press('ArrowUp');
  for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
  const at = await page.evaluate(() => window.fairway.cursor.at);
  await page.keyboard.press('Enter');
  await until(page, (p) => Math.hypot(window.fairway.run.plans[0].at(-1).goal.x - p.x, window.fairway.run.plans[0].at(-1).goal.y - p.y) < 0.01, at);
  // A drag: draw an obstacle.
  await page.click('#tool-wall');
  await page.focus('#map');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Shift+Enter');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowDown');
  const end = await page.evaluate(() => window.fairway.cursor.at);
  await page.keyboard.press('Enter');
  await cellBecomes(page, end.x, end.y, 1);
  // Letters can be switched off.
  await page.click('#show-help');
  await page.uncheck('#letters');
  await page.keyboard.press('Escape');
  await page.focus('#map');
  await page.keyboard.press('e');
  assert.equal(await page.getAttribute('#tool-wall', 'aria-pressed'), 'true');
}));

test('popovers take the focus, and close with Escape and with a click outside', () => withLive(async (page) => {
  await page.click('#show-layers');
  assert.ok(await page.evaluate(() => document.getElementById('layers').contains(document.activeElement)));
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('#layers')));
  assert.equal(await page.evaluate(() => document.activeElement.id), 'show-layers');
  await page.click('#save');
  assert.ok(await page.isVisible('#saves'));
  await page.mouse.click(...await spot(page, 8, 8));
  assert.ok(!(await page.isVisible('#saves')));
}));

test('values under the pointer, planned speed, and more plots', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.duration > 1.5);
  const box = await page.locator('#plots').boundingBox();
  await page.mouse.move(box.x + 80, box.y + 40);
  await until(page, () => /Speed: command .* m\/s, actual .* m\/s/.test(document.getElementById('plot-values').textContent));
  assert.match(await page.textContent('#plot-values'), /Clearance: to obstacles > 2\.00 m|Clearance: to obstacles \d/);
  await page.click('#show-layers');
  await page.check('[data-plot="turn"]');
  await page.check('[data-plot="cycle"]');
  await until(page, (height) => document.getElementById('plots').clientHeight > height + 60, box.height);
}));
