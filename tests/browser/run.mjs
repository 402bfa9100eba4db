// SPDX-License-Identifier: Apache-2.0
// Runs one test file: node run.mjs FILE.test.mjs FOLDER_OF_PROGRAMS. Where a requirement is not
// installed, it prints a message and ends with 77, which CTest counts as skipped.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const [file, programs] = process.argv.slice(2);

const skip = (why) => {
  console.log(`skipped: ${why}`);
  process.exit(77);
};

if (Number(process.versions.node.split('.')[0]) < 18) skip(`needs Node 18 or later, found ${process.version}`);
if (!existsSync(here('node_modules/playwright-core'))) skip('needs `npm ci` in tests/browser (./test does it)');
if (file.startsWith('page') && !existsSync(here('../../viewer/node_modules/esbuild'))) {
  skip('needs `npm ci` in viewer (./test does it)');
}
const chromium = process.env.FAIRWAY_CHROMIUM ?? '/usr/bin/chromium';
const browser = ['replay.test.mjs', 'replay_view.test.mjs', 'lidar.test.mjs', 'live.test.mjs', 'live_review.test.mjs', 'live_safeguards.test.mjs',
  'live_zones.test.mjs', 'walkthrough.test.mjs', 'screens.test.mjs', 'playground.test.mjs'];
if (browser.includes(file) && !existsSync(chromium)) skip(`needs Chromium at ${chromium}`);
const server = ['live.test.mjs', 'live_review.test.mjs', 'live_safeguards.test.mjs', 'live_zones.test.mjs', 'walkthrough.test.mjs', 'screens.test.mjs', 'clients.test.mjs', 'foxglove.test.mjs'];
if (server.includes(file) && spawnSync(`${programs}/fairway`, ['serve', '--help']).status !== 0) {
  skip('needs `fairway serve`, which needs libboost-dev');
}

if (file === 'playground.test.mjs' && !existsSync(`${programs}/../playground.html`)) {
  skip('needs the page: cmake --build --preset release --target playground');
}

const { status } = spawnSync(process.execPath, ['--test', '--test-reporter=spec', here(file)],
  { stdio: 'inherit', env: { ...process.env, FAIRWAY_BIN: programs } });
process.exit(status ?? 1);
