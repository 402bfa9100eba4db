// SPDX-License-Identifier: Apache-2.0
// Runs master.test.mjs: node run.mjs BIN SCENARIOS DATA. Where a requirement is not installed, it prints a message
// and ends with 77, which CTest counts as skipped.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const skip = (why) => {
  console.log(`skipped: ${why}`);
  process.exit(77);
};
if (Number(process.versions.node.split('.')[0]) < 18) skip(`needs Node 18 or later, found ${process.version}`);
if (!existsSync(here('node_modules/vda-5050-lib'))) skip('needs `npm ci` in tests/vda5050/master (./test does it)');
if (!existsSync('/usr/sbin/mosquitto')) skip('needs mosquitto');
const { status } = spawnSync(process.execPath, ['--test', '--test-reporter=spec', here('master.test.mjs')],
  { stdio: 'inherit', env: { ...process.env, FAIRWAY_VDA5050_MASTER: process.argv.slice(2).join(';') } });
process.exit(status ?? 1);
