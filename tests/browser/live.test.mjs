// SPDX-License-Identifier: Apache-2.0
// The live page: uses every control and checks its effect on the world.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';
import { launch, openPage } from './support/browser.mjs';
import { program } from './support/runs.mjs';
import { cellAt, cellBecomes, click, confirm, drag, last, title, until, withLive as liveWith } from './support/live.mjs';
import { serve } from './support/server.mjs';

let browser;
let folder;

before(async () => {
  browser = await launch();
  folder = await mkdtemp(join(tmpdir(), 'fairway-'));
});

after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

const withLive = (work, options) => liveWith(browser, work, options);

test('a goal by a click, with a heading by a drag; the robot arrives', () => withLive(async (page) => {
  await page.selectOption('#speed', '8');
  await page.click('#tool-goal');
  await drag(page, [5, 5], [5, 6.5]);
  await until(page, () => {
    const goal = window.fairway.run.frames.at(-1).robots[0].plan?.goal;
    return goal && Math.abs(goal.x - 5) < 0.1 && goal.heading !== null;
  });
  const { robots: [{ goal }] } = await last(page);
  assert.ok(Math.abs(goal.y - 5) < 0.1 && Math.abs(goal.heading - Math.PI / 2) < 0.1);
  await until(page, () => {
    const robot = window.fairway.run.frames.at(-1).robots[0];
    return Math.hypot(robot.x - 5, robot.y - 5) < 0.2 && Math.abs(robot.heading - Math.PI / 2) < 0.2;
  });
  await click(page, 8, 3);
  await until(page, () => {
    const robot = window.fairway.run.frames.at(-1).robots[0];
    return robot.plan.goal.heading === null && Math.hypot(robot.x - 8, robot.y - 3) < 0.3;
  });
}));

test('a robot is moved in the running world, which keeps its history', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.duration > 0.5);
  const { time } = await last(page);
  await page.click('#tool-pose');
  await drag(page, [10, 8], [8, 8]);
  await until(page, () => Math.abs(window.fairway.run.frames.at(-1).robots[0].x - 10) < 0.5);
  const now = await last(page);
  assert.ok(now.time > time, 'the run continues');
  assert.ok(await page.evaluate(() => window.fairway.run.frames[0].time) === 0, 'the past is kept');
}));

test('obstacles drawn during the drive lead to another path, and can be erased', () => withLive(async (page) => {
  const length = (least) => {
    const { path } = window.fairway.run.plans[0].at(-1);
    let sum = 0;
    for (let i = 1; i < path.length; ++i) sum += Math.hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    return least === undefined ? sum : sum > least;
  };
  await until(page, () => window.fairway.run.frames.at(-1).robots[0].plan?.usable);
  await page.click('#play');
  await until(page, () => document.getElementById('connection').textContent === 'paused');
  const plans = await page.evaluate(() => window.fairway.run.plans[0].length);
  const before = await page.evaluate(length);
  await page.click('#tool-wall');
  await page.locator('#brush').fill('0.2');
  await drag(page, [8, 12], [12, 3]);
  await until(page, (n) => window.fairway.run.plans[0].length > n, plans);
  assert.equal(await cellAt(page, 10, 7.5), 1);
  // A plan that a thread makes is taken over in a paused world, too.
  await until(page, length, before + 0.2);
  await page.click('#tool-erase');
  await drag(page, [8, 12], [12, 3]);
  await until(page, () => window.fairway.run.grids[0][0].changes.at(-1).runs[3] === 0);
  assert.equal(await cellAt(page, 10, 7.5), 0);
}));

test('a robot arrives although a wall is drawn across its path during the drive', () => withLive(async (page) => {
  await page.click('#tool-wall');
  await drag(page, [11, 13], [14, 4]);
  await page.selectOption('#speed', '8');
  await until(page, () => {
    const { frames, begin } = window.fairway.run;
    const { collided, status } = frames.at(-1).robots[0];
    return collided || begin.statuses[status] === 'goal reached';
  });
  assert.equal(await cellAt(page, 12.5, 8.5), 1);
  const { robots: [{ x, y, collided }] } = await last(page);
  assert.ok(!collided && Math.hypot(x - 17, y - 13) < 0.3);
}));

test('no obstacle can be drawn into a robot', () => withLive(async (page) => {
  await page.click('#play');
  const { robots: [robot] } = await last(page);
  await page.click('#tool-wall');
  await drag(page, [robot.x - 1, robot.y], [robot.x + 1, robot.y]);
  await cellBecomes(page, robot.x + 0.8, robot.y, 1);
  assert.equal(await cellAt(page, robot.x, robot.y), 0);
}));

test('a person is placed, moved, and removed; the robot has no contact', () => withLive(async (page) => {
  await page.click('#tool-person');
  await click(page, 9, 9);
  await until(page, () => window.fairway.run.frames.at(-1).bodies.length === 1);
  const [placed] = (await last(page)).bodies;
  assert.ok(Math.hypot(placed.x - 9, placed.y - 9) < 0.1);
  const bodyNow = () => page.evaluate(() => window.fairway.run.frames.at(-1).bodies[0]);
  const from = await bodyNow();
  await drag(page, [from.x, from.y], [7, 9]);
  await until(page, () => window.fairway.run.frames.some(({ bodies }) => bodies[0]?.vx < -1));
  assert.ok(await page.evaluate(() => window.fairway.run.frames.every(({ bodies }) => !bodies[0] || Math.hypot(bodies[0].vx, bodies[0].vy) < 1.5)));
  await until(page, () => {
    const body = window.fairway.run.frames.at(-1).bodies[0];
    return Math.abs(body.x - 7) < 0.1 && body.vx === 0;
  });
  await page.click('#tool-erase');
  await click(page, 7, 9);
  await until(page, () => window.fairway.run.frames.at(-1).bodies.length === 0);
  assert.ok(!(await last(page)).robots[0].collided);
}));

test('robots are added to the running world and removed from it; the run continues', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.duration > 0.5);
  await page.click('#tool-robot');
  await drag(page, [4, 10], [6, 10]);
  await until(page, () => window.fairway.run.begin.robots.length === 2 && window.fairway.run.frames.length > 0);
  await until(page, () => document.querySelectorAll('[data-robot]').length === 2);
  await page.click('[data-robot="1"]');
  await page.click('#tool-goal');
  await click(page, 12, 10);
  await until(page, () => Math.abs((window.fairway.run.frames.at(-1).robots[1].plan?.goal.x ?? 0) - 12) < 0.1);
  await page.click('[aria-label="robot 1"] .remove_robot');
  await until(page, () => window.fairway.run.frames.at(-1).robots[1].absent);
  await until(page, () => document.querySelectorAll('[data-robot]').length === 1);
  assert.equal(await page.evaluate(() => window.fairway.run.frames[0].time), 0);
}));

test('pause, step, speed and restart', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.duration > 0.5);
  await page.click('#play');
  await until(page, () => document.getElementById('connection').textContent === 'paused');
  // Records that were sent before the pause come before those of a step.
  const step = async () => {
    const { time: before } = await last(page);
    await page.click('#forward');
    await until(page, (t) => window.fairway.run.duration > t, before);
    return (await last(page)).time;
  };
  await step();
  const first = await step();
  const time = await step();
  assert.ok(Math.abs(time - first - 0.1) < 1e-6, 'a paused world advances by the step only');
  await page.selectOption('#speed', '8');
  await page.keyboard.press('Escape');
  await page.locator('#map').focus();
  await page.keyboard.press(' ');
  await until(page, (t) => window.fairway.run.duration > t + 4, time);
  await page.click('#restart');
  await until(page, (t) => window.fairway.run.duration < t + 4, time);
}));

test('the past can be viewed while the world continues', () => withLive(async (page) => {
  await until(page, () => window.fairway.run.duration > 2);
  await page.click('#to-start');
  assert.ok(await page.evaluate(() => window.fairway.time) < 0.2);
  assert.ok(await page.isVisible('#past') && await page.isEnabled('#go-live'));
  const shown = await page.evaluate(() => window.fairway.time);
  const { time } = await last(page);
  await until(page, (t) => window.fairway.run.duration > t + 0.3, time);
  assert.equal(await page.evaluate(() => window.fairway.time), shown);
  await page.click('#go-live');
  await until(page, () => window.fairway.run.duration - window.fairway.time < 0.5);
  assert.ok(!(await page.isVisible('#past')) && await page.isDisabled('#go-live'));
}));

test('settings show their units, take effect at once, and are refused if invalid', () => withLive(async (page) => {
  await page.click('#tab-settings');
  await page.click('[data-group="robot"] summary');
  await page.click('[data-group="mpc"] summary');
  const row = page.locator('[data-setting="robot.linear_max"]');
  assert.match(await row.textContent(), /m\/s/);
  await row.locator('input[type="text"]').fill('0.3');
  await row.locator('input[type="text"]').press('Enter');
  await until(page, () => window.fairway.run.setting('robot', 'linear_max') === 0.3);
  await page.selectOption('#speed', '4');
  await until(page, () => {
    const { frames } = window.fairway.run;
    return frames.slice(-10).every((f) => f.robots[0].cycle && f.robots[0].cycle.linear < 0.31);
  });
  await until(page, () => / \/ 0\.30 m\/s/.test(document.querySelector('[data-value="speed"]').textContent));
  const slider = row.locator('input[type="range"]');
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  await slider.click({ position: { x: box.width * 0.9, y: box.height / 2 } });
  await until(page, () => window.fairway.run.setting('robot', 'linear_max') > 0.5);
  // A decay rate above 1 / dt contradicts Eq. (14).
  const decay = page.locator('[data-setting="mpc.decay_rate"] input[type="text"]');
  await decay.fill('50');
  await decay.press('Enter');
  const refusal = page.locator('[data-setting="mpc.decay_rate"] .refusal');
  await refusal.waitFor();
  assert.match(await refusal.textContent(), /With a step of 0\.1 s the decay rate must be at most 10 \/s \(now 50\)/);
  assert.notEqual(await decay.inputValue(), '50', 'the refused value is replaced');
  assert.notEqual(await page.evaluate(() => window.fairway.run.setting('mpc', 'decay_rate')), 50);
  await page.click('[data-group="tracking"] summary');
  await page.locator('[data-setting="tracking.target_mode"] select').selectOption({ index: 1 });
  await until(page, () => window.fairway.run.settings.find((s) => s.name === 'target_mode').value !== 'reference_path');
  await page.locator('[data-setting="tracking.step_regions"] input').uncheck();
  await until(page, () => window.fairway.run.settings.find((s) => s.name === 'step_regions').value === false);
}));

test('each map can be selected', () => withLive(async (page) => {
  for (const name of await page.locator('#map-choice option').allTextContents()) {
    await page.selectOption('#map-choice', { label: name });
    await confirm(page);
    await title(page, name);
    await until(page, () => window.fairway.run.frames.length > 3);
    await until(page, () => window.fairway.run.frames.at(-1).robots[0].plan?.usable);
  }
}, { map: null }));

test('maps are uploaded, with their YAML file or without', () => withLive(async (page) => {
  const width = 200;
  const pixels = Buffer.alloc(width * 100, 254);
  for (let x = 0; x < width; ++x) pixels[50 * width + x] = x > 150 ? 254 : 0;
  const image = join(folder, 'walls.pgm');
  await writeFile(image, Buffer.concat([Buffer.from(`P5 ${width} 100 255\n`), pixels]));
  const yaml = join(folder, 'walls.yaml');
  await writeFile(yaml, 'image: /etc/passwd\nresolution: 0.1\norigin: [3, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n');
  await page.setInputFiles('#map-files', [image, yaml]);
  await title(page, 'walls');
  const frame = await page.evaluate(() => window.fairway.run.grids[0][0].frame);
  assert.deepEqual(frame, { width: 200, height: 100, resolution: 0.1, origin: { x: 3, y: -2, heading: 0 } });
  assert.equal(await cellAt(page, 5, 2.95), 1);
  await page.setInputFiles('#map-files', image);
  await page.fill('#resolution', '0.2');
  await page.click('#resolution-ok');
  await until(page, () => window.fairway.run.grids[0][0].frame.resolution === 0.2);
  await until(page, () => window.fairway.run.frames.at(-1)?.robots[0].plan?.usable);
  const nonsense = join(folder, 'nonsense.png');
  await writeFile(nonsense, 'no picture');
  await page.setInputFiles('#map-files', [nonsense, yaml]);
  await until(page, () => !document.getElementById('notice').hidden);
  assert.match(await page.textContent('#notice'), /expected/);
}, { expected: ['Failed to load resource: the server responded with a status of 422 (Unprocessable Entity)'] }));

test('saved files can be used: scenario, recording, report', () => withLive(async (page) => {
  await page.click('#tool-wall');
  await drag(page, [8, 12], [12, 6]);
  await page.click('#tool-person');
  await click(page, 4, 8);
  await page.click('#tool-goal');
  await click(page, 14, 4);
  await page.click('#tab-settings');
  await page.click('[data-group="robot"] summary');
  const box = page.locator('[data-setting="robot.linear_max"] input[type="text"]');
  await box.fill('0.8');
  await box.press('Enter');
  await page.selectOption('#speed', '8');
  await until(page, () => window.fairway.run.duration > 12);
  await page.click('#play');
  await page.click('#save');
  const save = async (text, name) => {
    const [download] = await Promise.all([
      page.waitForEvent('download'), page.click(`#saves a:has-text("${text}")`)]);
    assert.equal(download.suggestedFilename(), name);
    const path = join(folder, name);
    await download.saveAs(path);
    return path;
  };
  const recording = await save('Recording', 'run.mcap');
  const told = execFileSync(program('fairway'), ['replay', recording], { encoding: 'utf8' });
  assert.match(told, /every command the same to the bit/);
  const archive = await save('Scenario', 'scenario.zip');
  execFileSync('python3', ['-m', 'zipfile', '-e', archive, join(folder, 'scenario')]);
  const result = JSON.parse(execFileSync(program('fairway'),
    ['simulate', join(folder, 'scenario/scenario.yaml'), '--json', '-'], { encoding: 'utf8' }));
  assert.ok(result.success);
  assert.match(await readFile(join(folder, 'scenario/scenario.yaml'), 'utf8'), /linear_max: 0\.8/);
  const report = await save('Report', 'run.html');
  const { page: replay, errors, context } = await openPage(browser, pathToFileURL(report).href);
  await replay.waitForFunction(() => window.fairway?.drawn > 0);
  assert.ok(await replay.evaluate(() => window.fairway.run.duration) > 12);
  assert.ok(await replay.evaluate(() => window.fairway.run.frames.at(-1).bodies.length) === 1);
  assert.deepEqual(errors, []);
  await context.close();
}));

test('two pages show and change the same world', () => withLive(async (one, two) => {
  await two.waitForFunction(() => window.fairway?.drawn > 0);
  await two.click('#tool-goal');
  await title(two, 'Empty hall');
  await click(two, 6, 11);
  await until(one, () => Math.abs((window.fairway.run.frames.at(-1).robots[0].plan?.goal.y ?? 0) - 11) < 0.1);
  await one.click('#play');
  for (const page of [one, two]) await until(page, () => document.getElementById('connection').textContent === 'paused');
  const a = await last(one);
  await until(two, (t) => window.fairway.run.duration === t, a.time);
  assert.deepEqual(await last(two), a);
}, { pages: 2 }));

test('a late page shows the past, and a page reconnects after the server was restarted', async () => {
  const server = await serve();
  const first = await openPage(browser, server.url);
  await until(first.page, () => window.fairway?.run?.duration > 3);
  const second = await openPage(browser, server.url);
  await until(second.page, () => window.fairway?.run?.frames[0].time === 0 && window.fairway.run.duration > 3);
  await second.context.close();
  await server.stop();
  await until(first.page, () => /reconnecting/.test(document.getElementById('connection').textContent));
  await first.context.close();
});
