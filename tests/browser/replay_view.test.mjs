// SPDX-License-Identifier: Apache-2.0
// The replay page shows the run correctly, on every screen and on paper, and fast enough.
import assert from 'node:assert/strict';
import test from 'node:test';
import { McapIndexedReader } from '@mcap/core';
import { decompress } from 'fzstd';
import { readFile, rm, stat } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { openPage } from './support/browser.mjs';
import { camera, picture, shared, useRun, withPage } from './support/replay_page.mjs';
import { syntheticRun } from './support/runs.mjs';

useRun();

test('loads no external resource', async () => {
  const context = await shared.browser.newContext();
  const page = await context.newPage();
  const asked = [];
  page.on('request', (request) => {
    if (!request.url().startsWith('file:') && !request.url().startsWith('data:')) asked.push(request.url());
  });
  await page.goto(shared.url);
  await page.waitForFunction(() => window.fairway?.drawn > 0);
  assert.deepEqual(asked, []);
  await context.close();
});

test('agrees with the recording within rounding', () => withPage(async (page) => {
  const bytes = await readFile(shared.run.recording);
  const file = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
    },
    decompressHandlers: { zstd: (data) => decompress(data) },
  });
  const json = async (topic, at) => {
    const stamp = BigInt(Math.round(at * 1e9));
    for await (const message of file.readMessages({ topics: [topic], startTime: stamp, endTime: stamp })) {
      return JSON.parse(new TextDecoder().decode(message.data));
    }
    throw new Error(`no message on ${topic} at ${at}`);
  };
  for (const at of [0, 7.3, 33.3, 60]) {
    const frame = await page.evaluate((t) => {
      const { run } = window.fairway;
      const found = run.frames[run.frameIndex(t)];
      return { ...found, robots: found.robots.map((robot) => ({ ...robot, plan: null })) };
    }, at);
    const world = await json('/fairway/world', at);
    world.bodies.forEach((body, i) => {
      assert.ok(Math.abs(body.position[0] - frame.bodies[i].x) < 6e-4);
      assert.ok(Math.abs(body.velocity[0] - frame.bodies[i].vx) < 6e-4);
    });
    for (let robot = 0; robot < 3; ++robot) {
      const cycle = await json(`/robot_${robot}/cycle`, at);
      const shown = frame.robots[robot];
      assert.ok(Math.abs(cycle.input.pose.x - shown.x) < 6e-4);
      assert.ok(Math.abs(cycle.input.pose.y - shown.y) < 6e-4);
      assert.ok(Math.abs(cycle.input.pose.heading - shown.heading) < 6e-5);
      assert.ok(Math.abs(cycle.command.linear - shown.cycle.commandLinear) < 6e-4);
      assert.equal(cycle.status, shown.cycle.status);
      assert.equal(cycle.limit, shown.cycle.limit);
      assert.equal(cycle.rectangle, shown.cycle.rectangle);
      assert.equal(cycle.prediction.poses.length, shown.cycle.prediction.length);
      cycle.prediction.poses.forEach((pose, k) => {
        assert.ok(Math.abs(pose.x - shown.cycle.prediction[k].x) < 6e-4);
        assert.ok(Math.abs(pose.y - shown.cycle.prediction[k].y) < 6e-4);
      });
    }
  }
}));

test('panel, theme, and settings', () => withPage(async (page) => {
  const wide = (await page.locator('#map').boundingBox()).width;
  await page.click('#show-panel');
  assert.ok((await page.locator('#map').boundingBox()).width > wide + 200);
  await page.click('#show-panel');
  const light = await picture(page);
  await page.click('#theme');
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
  assert.notEqual(await picture(page), light);
  await page.click('#theme');
  assert.equal(await picture(page), light);
  await page.click('#tab-settings');
  await page.click('[data-group="robot"] summary');
  assert.match(await page.textContent('[data-setting="robot.linear_max"]'), /Maximum linear\s*1 m\/s/);
  assert.match(await page.textContent('#summary'), /Distance travelled/);
}));

test('follows the dark theme of the system', () => withPage(async (page) => {
  const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(background, 'rgb(23, 28, 33)');
}, { colorScheme: 'dark' }));

test('two fingers zoom on a small screen', () => withPage(async (page) => {
  const before = await camera(page);
  const box = await page.locator('#map').boundingBox();
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...xs) => session.send('Input.dispatchTouchEvent', {
    type, touchPoints: xs.map((x, id) => ({ x: box.x + x, y: box.y + 150, id })),
  });
  await touch('touchStart', 150, 200);
  for (let i = 1; i <= 5; ++i) await touch('touchMove', 150 - 10 * i, 200 + 10 * i);
  await touch('touchEnd');
  await page.waitForFunction((s) => window.fairway.camera.scale > 1.5 * s, before.scale);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
}, { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true }));

test('fits the map and its buttons on small screens, portrait and landscape', async () => {
  for (const viewport of [{ width: 390, height: 780 }, { width: 780, height: 390 }]) {
    await withPage(async (page) => {
      const box = async (id) => page.locator(id).boundingBox();
      await page.click('#show-menu');
      const [map, footer, play, theme] = [await box('#map'), await box('footer'), await box('#play'), await box('#theme')];
      assert.ok(Math.min(map.y + map.height, footer.y) - map.y > 200, 'the map');
      assert.ok(play.y + play.height <= viewport.height && theme.y >= 0 && theme.height >= 44 && play.height >= 44, 'the buttons');
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    }, { viewport, hasTouch: true, isMobile: true });
  }
});

test('shows the true bodies of the robots', () => withPage(async (page) => {
  // A rectangle of 0.6 x 0.4 m; its circumscribed disc is wider. Only robots are left on the map.
  for (const box of await page.locator('#layers input').all()) {
    await box.evaluate((input) => { input.checked = true; input.click(); });
  }
  const colors = async (u, v) => {
    await picture(page);
    return page.evaluate(([du, dv]) => {
      const { camera, moment } = window.fairway;
      const { x, y, heading } = moment.poses[0];
      const [c, s] = [Math.cos(heading), Math.sin(heading)];
      const p = camera.toScreen({ x: x + c * du - s * dv, y: y + s * du + c * dv });
      const map = document.getElementById('map');
      return [...map.getContext('2d').getImageData(Math.round(p.x * devicePixelRatio), Math.round(p.y * devicePixelRatio), 1, 1).data];
    }, [u, v]);
  };
  await page.evaluate(() => {
    const { x, y } = window.fairway.moment.poses[0];
    Object.assign(window.fairway.camera, { x, y, scale: 300 });
    window.fairway.invalidate();
  });
  const body = await colors(0.26, 0.15);
  assert.deepEqual(await colors(-0.26, -0.15), body);
  assert.notDeepEqual(await colors(0, 0.25), body);
}));

test('two runs are side by side, at the same time', () => withPage(async (page) => {
  await page.setInputFiles('#compare-file', shared.run.page);
  const pane = await (await page.waitForSelector('#pane')).contentFrame();
  await pane.waitForFunction(() => window.fairway?.drawn > 0);
  await page.evaluate(() => window.fairway.onSeek(20));
  await pane.waitForFunction(() => Math.abs(window.fairway.time - 20) < 0.01);
  assert.ok(!(await pane.isVisible('#transport')) && await pane.isVisible('#map'));
  await page.click('#compare');
  assert.equal(await page.locator('#pane').count(), 0);
}));

test('5 minutes of 4 robots are less than 1 MB', async () => {
  const run = await syntheticRun({ robots: 4, seconds: 300, side: 240 });
  const { size } = await stat(run.page);
  await rm(run.folder, { recursive: true });
  assert.ok(size < 1e6, `${size}`);
});

test('prints in the light theme, with the map, the plots and the robots', () => withPage(async (page) => {
  const pdf = await page.pdf();
  assert.ok(pdf.length > 30_000);
  // On paper the plots are light too, and larger than on the screen.
  const plots = await page.evaluate(() => {
    window.fairway.print(true);
    const canvas = document.getElementById('plots');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const { width } = canvas;
    let darkest = 255;
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255) darkest = Math.min(darkest, data[i] + data[i + 1] + data[i + 2]);
    window.fairway.print(false);
    return { width, darkest };
  });
  assert.equal(plots.width, 3 * 703);
  assert.ok(plots.darkest < 150, 'the ink is dark');
  await page.emulateMedia({ media: 'print' });
  assert.ok(await page.isVisible('#plots') && await page.isVisible('#summary'));
  assert.ok(!(await page.isVisible('#play')) && !(await page.isVisible('#settings')));
}, { colorScheme: 'dark' }));

// How fast it draws depends on the machine: page_pace.mjs measures that every night.
test('a map of 1000 x 1000 cells opens and plays', async () => {
  const large = await syntheticRun({ robots: 4, seconds: 300, side: 1000 });
  assert.ok((await stat(large.page)).size < 10e6);
  const { context, page, errors } = await openPage(shared.browser, 'about:blank');
  await page.goto(pathToFileURL(large.page).href, { waitUntil: 'commit' });
  await page.waitForFunction(() => window.fairway?.drawn > 0);
  await page.click('#play');
  const drawn = await page.evaluate(() => window.fairway.drawn);
  await page.waitForFunction((before) => window.fairway.drawn > before + 30 && window.fairway.time > 0.5, drawn);
  assert.deepEqual(errors, []);
  await context.close();
  await rm(large.folder, { recursive: true });
});
