// SPDX-License-Identifier: Apache-2.0
// Parts of the page that need no browser, compiled from their sources.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

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
