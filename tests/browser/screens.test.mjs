// SPDX-License-Identifier: Apache-2.0
// The pages on a phone (both ways), a laptop, a large screen and paper, light and dark. With
// FAIRWAY_SCREENS=FOLDER each is written as a picture, to be looked at.
import assert from 'node:assert/strict';
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { launch } from './support/browser.mjs';
import { shared, useRun, withPage } from './support/replay_page.mjs';
import { until, withLive } from './support/live.mjs';

useRun();
let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const folder = process.env.FAIRWAY_SCREENS;
const screens = {
  phone: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
  small_phone: { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true },
  landscape: { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true },
  laptop: { viewport: { width: 1280, height: 720 } },
  large: { viewport: { width: 2560, height: 1440 } },
};

async function picture(page, name) {
  if (!folder) return;
  await mkdir(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}

/** What covers or leaves the screen: pairs of visible controls that overlap, and those cut off. */
const faults = (page) => page.evaluate(() => {
  const visible = [...document.querySelectorAll('#bar button, #bar input, #transport button, #transport select, #transport output, #top > button, #top h1, #top .pill, #strip span')]
    .map((element) => {
      const [box, around] = [element.getBoundingClientRect(), element.closest('#tools, #bar, body').getBoundingClientRect()];
      const [left, right] = [Math.max(box.left, around.left), Math.min(box.right, around.right)]; // tools may be scrolled
      return { name: element.id || element.className, box: { left, right, width: right - left, top: box.top, bottom: box.bottom, height: box.height } };
    })
    .filter(({ box }) => box.width > 1 && box.height > 1);
  const found = [];
  visible.forEach((a, i) => {
    if (a.box.right > innerWidth + 1 || a.box.left < -1) found.push(`${a.name} leaves the screen`);
    for (const b of visible.slice(i + 1)) {
      const [w, h] = [Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left), Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top)];
      if (w > 1 && h > 1) found.push(`${a.name} and ${b.name} overlap`);
    }
  });
  if (document.documentElement.scrollWidth > innerWidth) found.push(`the page is ${document.documentElement.scrollWidth} wide`);
  return found;
});

/** Targets of less than 44 pixels: for a box within a label, the label is its target. */
const smallTargets = (page) => page.evaluate(() => [...document.querySelectorAll('button, select, a.button, summary, input')]
  .map((element) => (element.matches('[type=checkbox]') ? element.closest('label') ?? element : element))
  .filter((element) => element.checkVisibility() && !element.matches(':disabled'))
  .map((element) => ({ name: element.id || element.textContent || element.outerHTML.slice(0, 60), box: element.getBoundingClientRect() }))
  .filter(({ box }) => box.height > 0 && (box.height < 43.5 || box.width < 43.5))
  .map(({ name, box }) => `${name} ${box.width.toFixed(0)} x ${box.height.toFixed(0)}`));

/** Names of controls: each has one, and it contains the text that is visible (WCAG 2.5.3). */
const poorNames = (page) => page.evaluate(() => {
  const plain = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, ' ').trim();
  // The text of an element without its controls and its values.
  const words = (element) => plain([...element.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE).map((node) => node.data).join(' '));
  const found = [];
  for (const element of document.querySelectorAll('button, select, input, textarea, a.button, canvas[tabindex]')) {
    if (!element.checkVisibility()) continue;
    const label = element.labels?.[0];
    const given = element.getAttribute('aria-label');
    const name = plain(given ?? label?.textContent ?? element.textContent);
    const visible = label ? words(label) : element.matches('button, a') ? plain(element.innerText) : '';
    if (!name && !/[^\s]/.test(given ?? element.textContent)) found.push(`${element.id || element.outerHTML.slice(0, 60)} has no name`);
    else if (!name.includes(visible)) found.push(`${element.id}: "${name}" without "${visible}"`);
    else if (/^[a-z]+\.[a-z_]+/.test(given ?? '')) found.push(`${element.id}: "${given}" is a key`);
    if (element.matches('canvas[tabindex]') && element.getAttribute('role') === 'img') found.push(`${element.id} takes input and is a picture`);
  }
  return found;
});

/** Borders of fields against what is behind them: WCAG AA asks for 3. */
const weakBorders = (page) => page.evaluate(() => {
  const parse = (color) => (color.match(/[\d.]+/g) ?? []).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((v) => v / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const [r, g, b, a = 1] = parse(getComputedStyle(at).backgroundColor);
      if (a > 0.5) return [r, g, b];
    }
    return [255, 255, 255];
  };
  const found = [];
  for (const element of document.querySelectorAll('select, textarea, input:not([type=range], [type=checkbox], [type=file])')) {
    if (!element.checkVisibility() || element.matches(':disabled')) continue;
    const [a, b] = [light(parse(getComputedStyle(element).borderTopColor)), light(behind(element.parentElement))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < 3) found.push(`${element.id || element.className} ${ratio.toFixed(2)}`);
  }
  return found;
});

/** Contrast of all texts of controls against their backgrounds: WCAG AA asks for 4.5. */
const weakTexts = (page) => page.evaluate(() => {
  const parse = (color) => (color.match(/[\d.]+/g) ?? []).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((v) => v / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const [r, g, b, a = 1] = parse(getComputedStyle(at).backgroundColor);
      if (a > 0.5) return [r, g, b];
    }
    return [255, 255, 255];
  };
  const found = [];
  for (const element of document.querySelectorAll('button, select, label, h1, .pill, dt, dd, .why, summary, .meaning, #strip span, legend')) {
    if (!element.checkVisibility() || element.disabled || !element.textContent.trim()) continue;
    const [a, b] = [light(parse(getComputedStyle(element).color)), light(behind(element))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < 4.5) found.push(`${element.id || element.className || element.tagName} ${element.textContent.slice(0, 20)} ${ratio.toFixed(2)}`);
  }
  return found;
});

async function accessible(page, { hasTouch }) {
  assert.deepEqual(await weakTexts(page), []);
  assert.deepEqual(await weakBorders(page), []);
  assert.deepEqual(await poorNames(page), []);
  if (hasTouch) assert.deepEqual(await smallTargets(page), []);
}

for (const [name, options] of Object.entries(screens)) {
  for (const colorScheme of ['light', 'dark']) {
    test(`replay page: ${name}, ${colorScheme}`, () => withPage(async (page) => {
      await page.evaluate(() => window.fairway.onSeek(20));
      await page.waitForFunction(() => window.fairway.moment?.time === 20);
      await picture(page, `replay_${name}_${colorScheme}`);
      assert.deepEqual(await faults(page), []);
      await accessible(page, options);
      const map = await page.locator('#map').boundingBox();
      assert.ok(map.height * map.width > 0.3 * options.viewport.width * options.viewport.height || options.hasTouch, 'the map is large');
    }, { ...options, colorScheme }));

    test(`live page: ${name}, ${colorScheme}`, () => withLive(browser, async (page) => {
      await until(page, () => window.fairway.run.duration > 2);
      await picture(page, `live_${name}_${colorScheme}`);
      const [stop, bar] = [await page.locator('#halt').boundingBox(), await page.locator('#bar').boundingBox()];
      assert.ok(stop.x >= bar.x && stop.x + stop.width <= bar.x + bar.width && stop.y + stop.height <= bar.y + bar.height, 'the emergency stop is in reach');
      assert.deepEqual(await faults(page), []);
      await accessible(page, options);
      if (await page.isVisible('#show-menu')) {
        await page.click('#show-menu');
        await picture(page, `live_${name}_${colorScheme}_menu`);
        assert.ok(await page.isVisible('#map-choice') && await page.isVisible('#theme'));
        await page.keyboard.press('Escape');
      }
      await page.locator('#tab-settings').click();
      await picture(page, `live_${name}_${colorScheme}_settings`);
      await page.fill('#setting-search', 'linear');
      await page.click('#body-editor summary');
      await picture(page, `live_${name}_${colorScheme}_search`);
      await accessible(page, options);
    }, { map: null, ...options, colorScheme }));
  }
}

test('paper', () => withPage(async (page) => {
  await page.evaluate(() => window.fairway.onSeek(20));
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => window.fairway.print(true));
  await picture(page, 'replay_paper');
  assert.ok(await page.isVisible('#plots'));
  assert.ok(shared.url);
}, { viewport: { width: 794, height: 1123 } }));
