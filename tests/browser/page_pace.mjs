// SPDX-License-Identifier: Apache-2.0
// Pictures per second with 20 robots on a map of 1,000 x 1,000 cells, and the time of the first
// picture, of the live page and of the playground:
//   FAIRWAY_BIN=FOLDER_OF_PROGRAMS node tests/browser/page_pace.mjs [SECONDS] [PLAYGROUND.html]
// The figures depend on the machine: it runs in .ci/nightly and by hand, and not among the tests. It
// ends with 1 where a figure misses what docs/viewing.md promises.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch, openPage } from './support/browser.mjs';
import { serve } from './support/server.mjs';

const SIDE = 1000; // cells of 0.05 m
const ROBOTS = 20;
const seconds = Number(process.argv[2] ?? 20);
const playground = process.argv[3];

// What is promised: first picture [s], pictures per second, simulated seconds per second.
const PROMISED = { live: { first: 1, pictures: 30, pace: 0.95 }, playground: { first: 2, pictures: 30, pace: 0.95 } };

/** A hall of 50 m with posts, the robots on a circle, each with its goal opposite. */
function writeScenario(folder) {
  const cells = Buffer.alloc(SIDE * SIDE, 254);
  const fill = (x0, y0, width, height) => {
    for (let y = y0; y < y0 + height; ++y) cells.fill(0, y * SIDE + x0, y * SIDE + x0 + width);
  };
  for (const [x, y, w, h] of [[0, 0, SIDE, 2], [0, SIDE - 2, SIDE, 2], [0, 0, 2, SIDE], [SIDE - 2, 0, 2, SIDE]]) fill(x, y, w, h);
  for (let y = 60; y < SIDE - 60; y += 80) {
    for (let x = 60; x < SIDE - 60; x += 80) fill(x, y, 6, 6);
  }
  writeFileSync(join(folder, 'hall.pgm'), Buffer.concat([Buffer.from(`P5\n${SIDE} ${SIDE}\n255\n`), cells]));
  writeFileSync(join(folder, 'hall.yaml'), 'image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n'
    + 'occupied_thresh: 0.65\nfree_thresh: 0.196\n');
  const place = (i) => {
    const angle = (2 * Math.PI * i) / ROBOTS;
    return [25.8 + 16.4 * Math.cos(angle), 25.8 + 16.4 * Math.sin(angle), angle + Math.PI];
  };
  const robots = Array.from({ length: ROBOTS }, (_, i) => {
    const [x, y, heading] = place(i);
    const [gx, gy] = place(i + ROBOTS / 2);
    const text = (numbers) => numbers.map((n) => n.toFixed(3)).join(', ');
    return `  - name: r${i}\n    start: [${text([x, y, heading])}]\n    goal: [${text([gx, gy])}]\n`;
  });
  const file = join(folder, 'hall_of_robots.yaml');
  writeFileSync(file, `map: hall.yaml\ntime_limit: 120\nrobots:\n${robots.join('')}`);
  return file;
}

let failed = 0;

/** Watches a page for some seconds. */
const watch = (page) => page.evaluate(async (wanted) => {
  const paces = [];
  const begin = performance.now();
  const [drawn, time] = [window.fairway.drawn, window.fairway.run.duration];
  let last = begin;
  while (performance.now() - begin < 1e3 * wanted) {
    const now = await new Promise((done) => requestAnimationFrame(done));
    paces.push(now - last);
    last = now;
  }
  const spent = (performance.now() - begin) / 1e3;
  paces.sort((a, b) => a - b);
  return {
    pictures: (window.fairway.drawn - drawn) / spent,
    p99: paces[Math.floor(0.99 * paces.length)],
    pace: (window.fairway.run.duration - time) / spent,
  };
}, seconds);

function report(name, first, figures, errors) {
  const promised = PROMISED[name];
  console.log(`${name}: ${ROBOTS} robots on ${SIDE} x ${SIDE} cells: first picture after ${first.toFixed(2)} s (at most ${promised.first}), `
    + `${figures.pictures.toFixed(1)} pictures per second (at least ${promised.pictures}), 99 % of the gaps below ${figures.p99.toFixed(0)} ms, `
    + `${figures.pace.toFixed(2)} simulated seconds per second (at least ${promised.pace})`);
  for (const error of errors) console.log(error);
  if (first > promised.first || figures.pictures < promised.pictures || figures.pace < promised.pace || errors.length > 0) ++failed;
}

/** Drops the scenario and its map on the page of the playground. */
async function drop(page, folder) {
  const files = ['hall_of_robots.yaml', 'hall.yaml', 'hall.pgm'].map((name) => [name, readFileSync(join(folder, name)).toString('base64')]);
  const data = await page.evaluateHandle((given) => {
    const transfer = new DataTransfer();
    for (const [name, base64] of given) transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    return transfer;
  }, files);
  await page.dispatchEvent('body', 'drop', { dataTransfer: data });
  await page.waitForFunction((count) => window.fairway.run.begin.robots.length === count && window.fairway.run.duration > 0.5, ROBOTS);
}

const folder = mkdtempSync(join(tmpdir(), 'fairway-pace-'));
const server = await serve(writeScenario(folder));
const browser = await launch();
try {
  for (const [name, url] of [['live', server.url], ...(playground ? [['playground', pathToFileURL(resolve(playground)).href]] : [])]) {
    const { page, errors, context } = await openPage(browser, url);
    await page.waitForFunction(() => window.fairway?.drawn > 0);
    const first = await page.evaluate(() => window.fairway.firstDrawn) / 1e3;
    if (name === 'playground') await drop(page, folder);
    report(name, first, await watch(page), errors);
    await context.close();
  }
} finally {
  await browser.close();
  await server.stop();
  rmSync(folder, { recursive: true });
}
process.exit(failed > 0 ? 1 : 0);
