// SPDX-License-Identifier: Apache-2.0
// Takes a picture of a replay page: node tools/page_picture.mjs RUN.html SECONDS OUT.png
// Needs Chromium, and `npm ci` in tests/browser.
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch, openPage } from '../tests/browser/support/browser.mjs';

const [run, seconds, out] = process.argv.slice(2);
if (!out || !Number.isFinite(Number(seconds))) {
  console.error('node tools/page_picture.mjs RUN.html SECONDS OUT.png');
  process.exit(2);
}
const browser = await launch();
try {
  const { page } = await openPage(browser, pathToFileURL(resolve(run)).href,
    { viewport: { width: 1280, height: 800 }, deviceScaleFactor: 1.5 });
  await page.waitForFunction(() => window.fairway?.drawn > 0);
  const drawn = await page.evaluate((time) => {
    window.fairway.onSeek(time);
    return window.fairway.drawn;
  }, Number(seconds));
  await page.waitForFunction((before) => window.fairway.drawn > before, drawn);
  await page.screenshot({ path: out });
} finally {
  await browser.close();
}
