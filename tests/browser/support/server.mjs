// SPDX-License-Identifier: Apache-2.0
// The tool's server on a free port.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { program } from './runs.mjs';

/** Starts `fairway serve`; `stop` ends it like Ctrl+C and returns its exit code. */
export async function serve(...scenarios) {
  const child = spawn(program('fairway'), ['serve', '--port', '0', ...scenarios], { stdio: ['ignore', 'pipe', 'inherit'] });
  const url = await new Promise((resolve, reject) => {
    let text = '';
    child.stdout.on('data', (data) => {
      text += data;
      const found = /http:\/\/127\.0\.0\.1:\d+\//.exec(text);
      if (found) resolve(found[0]);
    });
    child.once('exit', (code) => reject(new Error(`the server ended with ${code}`)));
  });
  return {
    url,
    port: Number(new URL(url).port),
    alive: () => child.exitCode === null && child.signalCode === null,
    /** Resident memory [bytes]. */
    async memory() {
      const { readFile } = await import('node:fs/promises');
      const pages = Number((await readFile(`/proc/${child.pid}/statm`, 'utf8')).split(' ')[1]);
      return pages * 4096;
    },
    async stop() {
      if (child.exitCode !== null) return child.exitCode;
      child.kill('SIGINT');
      const [code] = await once(child, 'exit');
      return code;
    },
  };
}
