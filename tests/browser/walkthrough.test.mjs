// SPDX-License-Identifier: Apache-2.0
// The live page on a laptop and on a phone, both ways, from the first look to the goal.
import { after, before, test } from 'node:test';
import { launch } from './support/browser.mjs';
import { withLive } from './support/live.mjs';
import { walk } from './support/walkthrough.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const screens = {
  laptop: { viewport: { width: 1280, height: 720 } },
  phone: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
  landscape: { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true },
};

for (const [name, options] of Object.entries(screens)) {
  test(`a walkthrough without a dead end: ${name}`, () => withLive(browser,
    (page) => walk(page, { touch: options.hasTouch, name }), { map: null, ...options }));
}
