// SPDX-License-Identifier: Apache-2.0
// The page in the repository is the one that its sources build.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const viewer = fileURLToPath(new URL('../../viewer', import.meta.url));

test('viewer/page.html is up to date: else run `npm run build` in viewer', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'fairway-'));
  try {
    const built = join(folder, 'page.html');
    execFileSync(process.execPath, ['build.mjs', built], { cwd: viewer });
    assert.ok((await readFile(built)).equals(await readFile(join(viewer, 'page.html'))));
  } finally {
    await rm(folder, { recursive: true });
  }
});

test('its sources have no type errors', () => {
  execFileSync(join(viewer, 'node_modules/.bin/tsc'), ['--noEmit'], { cwd: viewer, stdio: 'inherit' });
});

test('it is small', async () => {
  assert.ok((await readFile(join(viewer, 'page.html'))).length < 160_000);
});
