// SPDX-License-Identifier: Apache-2.0
// Joins the live page, the world's module and the transport: assemble.mjs PAGE.html MODULE.js OUT.html
import { readFile, writeFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';

const [page, module, out] = process.argv.slice(2);
const here = (name) => readFile(new URL(name, import.meta.url), 'utf8');
const safe = (script) => script.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

const [html, glue, wasm, worker, transport, extras] = await Promise.all([
  readFile(page, 'utf8'), readFile(module, 'utf8'), readFile(module.replace(/\.js$/, '.wasm')),
  here('worker.js'), here('transport.js'), here('extras.js')]);

// The page's script is its last one; it becomes a function of what it talks through.
const start = html.lastIndexOf('<script>');
const end = html.lastIndexOf('</script>');
if (start < 0 || end < start) throw new Error(`${page}: expected a script`);
const script = html.slice(start + '<script>'.length, end);
const parts = [
  `<script id="world" type="text/plain">${gzipSync(wasm, { level: 9 }).toString('base64')}</script>`,
  `<script id="worker" type="text/plain">${safe(`${glue}\n${worker}`)}</script>`,
  `<script>${safe(transport)}</script>`,
  `<script>((WebSocket, fetch, location) => {${script}\n})(playground.WebSocket, playground.fetch, playground.location);</script>`,
  `<script>${safe(extras)}</script>`,
];
await writeFile(out, html.slice(0, start) + parts.join('\n') + html.slice(end + '</script>'.length));
