// SPDX-License-Identifier: Apache-2.0
// Bundles src/ into one page without any reference to the outside. `node build.mjs [OUT.html]`
import { build } from 'esbuild';
import { readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const out = process.argv[2] ?? here('page.html');

const bundle = async (entry) => {
  const result = await build({
    entryPoints: [here(entry)],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: ['chrome100', 'firefox100', 'safari16'],
    charset: 'utf8',
    legalComments: 'none',
    logLevel: 'warning',
  });
  return result.outputFiles[0].text.trim();
};

const [template, style, script] = await Promise.all([
  readFile(here('src/page/page.html'), 'utf8'),
  bundle('src/page/page.css'),
  bundle('src/main.ts'),
]);
// A closing tag inside the script would end it too early.
const safe = script.replaceAll('</script', '<\\/script');
const page = template
  .replace('/*STYLE*/', () => style)
  .replace('/*SCRIPT*/', () => safe);
await writeFile(out, page);
