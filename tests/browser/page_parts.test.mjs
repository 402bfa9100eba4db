// SPDX-License-Identifier: Apache-2.0
// Parts of the page that need no browser, compiled from their sources.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { program } from './support/runs.mjs';

const viewer = new URL('../../viewer/', import.meta.url);
const { buildSync } = createRequire(new URL('package.json', viewer))('esbuild');

/** A module of the page. */
const part = (path) => {
  const { outputFiles } = buildSync({
    entryPoints: [fileURLToPath(new URL(`src/${path}.ts`, viewer))], bundle: true, write: false, format: 'esm' });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);
};

const state = { paused: false, speed: 8, halted: false, waiting: false };

test('a world that runs at 3 times of 8 says so', async () => {
  const { PaceMeter, paceText } = await part('data/pace');
  const { stateWords } = await part('data/live_messages');
  const meter = new PaceMeter();
  for (let i = 0; i <= 100; ++i) {
    assert.equal(i < 20 ? paceText(meter.pace, 8) : '', '', 'a short measurement says nothing');
    meter.add(10 + 3 * i / 20, 100 + i / 20);
  }
  assert.equal(meter.pace.toFixed(3), '3.000');
  assert.deepEqual(stateWords(state, null, meter.pace), ['live, 3.0× of 8×', 'slow']);
  assert.deepEqual(stateWords({ ...state, speed: 2 }, null, meter.pace), ['live', 'good']);
  assert.deepEqual(stateWords({ ...state, speed: 1 }, null, 0.25), ['live, 0.25× of 1×', 'slow']);
  assert.deepEqual(stateWords(state, 4.2, meter.pace), ['viewing 4.2 s', 'slow']);
});

test('the pace is that of the last seconds, and a new run begins its measurement', async () => {
  const { PaceMeter } = await part('data/pace');
  const meter = new PaceMeter();
  for (let i = 0; i <= 60; ++i) meter.add(8 * i / 10, i / 10);
  for (let i = 1; i <= 60; ++i) meter.add(48 + i / 10, 6 + i / 10);
  assert.equal(meter.pace.toFixed(3), '1.000');
  meter.add(0, 13);
  assert.equal(meter.pace, null);
});

test('the presets of the body editor are the robots of scenarios/robots with two driven wheels', async () => {
  const { presets } = await part('panels/robot_presets');
  const folder = new URL('../../scenarios/robots/', import.meta.url);
  const robots = {};
  for (const file of readdirSync(folder)) {
    const pairs = readFileSync(new URL(file, folder), 'utf8').matchAll(/^(\w+): ([-\w.]+)$/gm);
    const robot = Object.fromEntries([...pairs].map(([, key, value]) => [key, value]));
    if (robot.kind === 'unicycle') robots[file.replace('.yaml', '')] = robot;
  }
  assert.deepEqual(presets.flatMap(({ file }) => file ?? []).sort(), Object.keys(robots).sort());
  for (const { file, values } of presets.filter((preset) => preset.file)) {
    const robot = robots[file];
    const wanted = { length: robot.length, width: robot.width, linear_min: robot.linear_min, linear_max: robot.linear_max,
      angular_max: robot.angular_max, linear_acceleration_max: robot.linear_acceleration, angular_acceleration_max: robot.angular_acceleration };
    for (const [key, value] of Object.entries(wanted)) assert.equal(values[`robot.${key}`], Number(value), `${file}: ${key}`);
  }
});

test('discs are read line by line', async () => {
  const { readDiscs } = await part('panels/body_editor');
  assert.deepEqual(readDiscs('0.3, 0, 0.2\n\n-0.3 0.1 0.25'), [{ x: 0.3, y: 0, radius: 0.2 }, { x: -0.3, y: 0.1, radius: 0.25 }]);
  for (const bad of ['', '0.3 0', '0 0 0', '0 0 x', '1 2 3 4']) assert.equal(readDiscs(bad), null, bad);
});

test('each status of the tool has its word, tone and place in the legend', async () => {
  const { statusLegend, statusWords } = await part('data/words');
  const folder = mkdtempSync(join(tmpdir(), 'fairway-'));
  execFileSync(program('fairway'), ['statuses', '--json', join(folder, 'statuses.json')]);
  const tool = JSON.parse(readFileSync(join(folder, 'statuses.json'), 'utf8'));
  rmSync(folder, { recursive: true });
  const run = { begin: { statuses: tool.statuses.map(({ name }) => name), status_guides: tool.statuses, limits: [], rows: [] } };
  const legend = statusLegend(run).map(([, text]) => text).join(', ').split(', ');
  tool.statuses.forEach(({ name, label }, i) => {
    assert.ok(label && legend.includes(label), `${name} is in the legend`);
    const { tone } = statusWords(run, i);
    assert.ok(tone !== 'idle' || ['planning'].includes(name), `${name} has a tone`);
  });
  // What the page compares with must be names of the tool.
  const names = new Set([...tool.statuses, ...tool.limiting_factors].map(({ name }) => name));
  for (const name of ['moving obstacle', 'stop not proven', 'speed limit', 'none', 'no path', 'planning', 'goal reached', 'no plan']) {
    assert.ok(names.has(name), `the tool has "${name}"`);
  }
});
