// SPDX-License-Identifier: Apache-2.0
// A headless Chromium that connects only to the page under test.
import { chromium } from 'playwright-core';

export const executablePath = process.env.FAIRWAY_CHROMIUM ?? '/usr/bin/chromium';

export const launch = () => chromium.launch({
  executablePath,
  headless: true,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

/** A page whose errors fail the test that checks them. */
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1560, height: 900 }, ...options });
  // The limit is large, so that other programs do not decide a test.
  context.setDefaultTimeout(Number(process.env.FAIRWAY_BROWSER_TIMEOUT ?? 180_000));
  const page = await context.newPage();
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
  await page.goto(url);
  return { context, page, errors };
}
