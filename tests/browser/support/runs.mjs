// SPDX-License-Identifier: Apache-2.0
// Recordings and replay pages from the programs under test.
import { execFile } from 'node:child_process';
import { mkdtemp } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';

const run = promisify(execFile);
const programs = process.env.FAIRWAY_BIN ?? new URL('../../../build/release/bin', import.meta.url).pathname;

export const program = (name) => join(programs, name);

/** Runs the scenario `name` with further options, whether it succeeds or not. */
export async function simulatedRun(name, options) {
  const folder = await mkdtemp(join(tmpdir(), 'fairway-'));
  const recording = join(folder, 'run.mcap');
  const page = join(folder, 'run.html');
  const scenario = new URL(`../../../scenarios/${name}.yaml`, import.meta.url).pathname;
  await run(program('fairway'), ['simulate', scenario, '--log', recording, '--report', page, ...options])
    .catch((error) => { if (error.code !== 1) throw error; });
  return { folder, recording, page };
}

/** A synthetic run in which every field has content. */
export async function syntheticRun({ robots = 3, seconds = 60, side = 240 } = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'fairway-'));
  const recording = join(folder, 'run.mcap');
  const page = join(folder, 'run.html');
  await run(program('write_synthetic_run'), [recording, page, `${robots}`, `${seconds}`, `${side}`]);
  return { folder, recording, page };
}
