// SPDX-License-Identifier: Apache-2.0
// The playground: the module in Node computes what the tool computes, and the page works from a file.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createRequire } from 'node:module';
import { mkdtemp, readFile, readdir, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { launch, openPage } from './support/browser.mjs';
import { click, confirm, title, until } from './support/live.mjs';
import { program } from './support/runs.mjs';
import { walk } from './support/walkthrough.mjs';

const scenarios = fileURLToPath(new URL('../../scenarios', import.meta.url));
const build = join(program('fairway'), '../..');
const url = pathToFileURL(join(build, 'playground.html')).href;

let folder;
let browser;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'fairway-'));
  browser = await launch();
});

after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

/** The files of a scenario of the repository with their paths in the module. */
async function filesOf(name) {
  const files = [[`${name}.yaml`, `/s/${name}.yaml`]];
  for (const map of await readdir(join(scenarios, 'maps'))) files.push([`maps/${map}`, `/s/maps/${map}`]);
  return Promise.all(files.map(async ([from, to]) => [to, await readFile(join(scenarios, from))]));
}

// Runs in Node and in a worker of Chromium, and therefore uses nothing from outside.
const compute = async (create, wasmBinary, files, scenario) => {
  const texts = [];
  const module = await create({ wasmBinary, onText: (text) => texts.push(text), onBytes() {}, onFile() {} });
  const withBytes = (bytes, use) => {
    const at = module._malloc(bytes.length + 1);
    module.HEAPU8.set(bytes, at);
    module.HEAPU8[at + bytes.length] = 0;
    try { return use(at, bytes.length); } finally { module._free(at); }
  };
  const withText = (text, use) => withBytes(new TextEncoder().encode(text), use);
  withText('/s/maps', (at) => module._folder_make(at));
  for (const [to, bytes] of files) {
    const written = withText(to, (path) => withBytes(bytes, (at, size) => module._file_write(path, at, size)));
    if (written !== 1) throw new Error(`${to} was not written`);
  }
  const done = withText(scenario, (at) => module._run_scenario(at));
  if (done !== 1) throw new Error(texts.at(-1));
  return texts.at(-1);
};

/** The trace of a scenario of the repository, as the module computes it in Node. */
async function traceOf(name) {
  const create = createRequire(import.meta.url)(join(build, 'playground/playground.js'));
  return compute(create, await readFile(join(build, 'playground/playground.wasm')), await filesOf(name), `/s/${name}.yaml`);
}

/** The same in a worker of Chromium. */
async function traceInChromium(name) {
  const { page, errors, context } = await openPage(browser, 'about:blank');
  const glue = await readFile(join(build, 'playground/playground.js'), 'utf8');
  const wasm = (await readFile(join(build, 'playground/playground.wasm'))).toString('base64');
  const files = (await filesOf(name)).map(([to, bytes]) => [to, bytes.toString('base64')]);
  const text = await page.evaluate(([code, given]) => new Promise((resolve, reject) => {
    const worker = new Worker(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
    worker.onerror = ({ message }) => reject(new Error(message));
    worker.onmessage = ({ data }) => (data.failed ? reject(new Error(data.failed)) : resolve(data.text));
    worker.postMessage(given);
  }), [`${glue}
    const bytes = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const compute = ${compute};
    onmessage = ({ data: { wasm, files, scenario } }) =>
      compute(createPlayground, bytes(wasm), files.map(([to, base64]) => [to, bytes(base64)]), scenario)
        .then((text) => postMessage({ text }), (error) => postMessage({ failed: String(error) }));`,
  { wasm, files, scenario: `/s/${name}.yaml` }]);
  assert.deepEqual(errors, []);
  await context.close();
  return text;
}

const rows = (csv) => csv.trim().split('\n').map((line) => line.split(','));

// The functions of the standard libraries differ in the last bit. This can change when the solver
// stops, so the runs agree within a bound [m, rad, m/s, rad/s].
const BOUND = 1e-3;
for (const name of ['workshop', 'doorways', 'fleet_crossing']) {
  test(`${name}: the commands are those of the tool`, async () => {
    const file = join(folder, `${name}.csv`);
    execFileSync(program('fairway'), ['simulate', join(scenarios, `${name}.yaml`), '--trace', file, '--json', join(folder, 'run.json')]);
    const [header, ...native] = rows(await readFile(file, 'utf8'));
    const [names, ...ours] = rows(await traceOf(name));
    assert.deepEqual(names, header);
    assert.equal(ours.length, native.length);
    const columns = ['x', 'y', 'heading', 'command_linear', 'command_angular'].map((column) => header.indexOf(column));
    let most = 0;
    for (let i = 0; i < native.length; ++i) {
      assert.equal(ours[i][header.indexOf('status')], native[i][header.indexOf('status')]);
      for (const column of columns) most = Math.max(most, Math.abs(ours[i][column] - native[i][column]));
    }
    console.log(`${name}: ${native.length} cycles, largest difference ${most}`);
    assert.ok(most <= BOUND, `largest difference ${most}`);
  });
}

test('Chromium computes the commands of Node, to the bit', async () => {
  for (const name of ['workshop', 'fleet_crossing']) assert.equal(await traceInChromium(name), await traceOf(name), name);
});

async function withPage(work, { hash = '', options = {} } = {}) {
  const { page, errors, context } = await openPage(browser, url + hash, options);
  try {
    await page.waitForFunction(() => window.fairway?.drawn > 0 && window.fairway.run?.frames.length > 2);
    await work(page);
    assert.deepEqual(errors, []);
  } finally {
    await context.close();
  }
}

test('it is one file of at most 3 MB that refers to nothing outside', async () => {
  const path = fileURLToPath(url);
  assert.ok((await stat(path)).size <= 3e6);
  const html = (await readFile(path, 'utf8')).replace(/<script id="(world|worker)"[^]*?<\/script>/g, '');
  assert.doesNotMatch(html, /<(script|link|img)[^>]+(src|href)="(?!data:)/);
});

test('from a file: a robot drives to a goal that is clicked', () => withPage(async (page) => {
  await page.selectOption('#map-choice', { label: 'Empty hall' }, { force: true });
  await confirm(page);
  await title(page, 'Empty hall');
  await page.selectOption('#speed', '8');
  await page.click('#tool-goal');
  await click(page, 8, 3);
  await until(page, () => {
    const robot = window.fairway.run.frames.at(-1).robots[0];
    return Math.hypot(robot.x - 8, robot.y - 3) < 0.3;
  });
}));

test('a link holds the scenario', () => withPage(async (page) => {
  await page.selectOption('#map-choice', { label: 'Empty hall' }, { force: true });
  await confirm(page);
  await title(page, 'Empty hall');
  await page.click('#tool-person');
  await click(page, 4, 8);
  await until(page, () => window.fairway.run.frames.at(-1).bodies.length === 1);
  await page.click('#save');
  await page.click('#link');
  await until(page, () => location.hash.startsWith('#scenario='));
  const hash = await page.evaluate(() => location.hash);
  assert.ok(hash.length < 4000, `${hash.length} characters`);
  await withPage(async (other) => {
    assert.equal(await other.textContent('#title'), 'Empty hall');
    assert.equal(await other.evaluate(() => window.fairway.run.frames.at(-1).bodies.length), 1);
  }, { hash });
}));

test('a broken link says so and begins with the built-in maps', () => withPage(async (page) => {
  await until(page, () => !document.getElementById('notice').hidden);
  assert.match(await page.textContent('#notice'), /link/);
}, { hash: '#scenario=AAAA' }));

const dropped = async (page, files) => {
  const data = await page.evaluateHandle((given) => {
    const transfer = new DataTransfer();
    for (const [name, base64] of given) transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    return transfer;
  }, files);
  await page.dispatchEvent('body', 'drop', { dataTransfer: data });
};
const given = async (path) => [path.replace(/.*\//, ''), (await readFile(join(scenarios, path))).toString('base64')];

test('maps and scenarios come by drag and drop', () => withPage(async (page) => {
  await dropped(page, [await given('maps/workshop.png'), await given('maps/workshop.yaml')]);
  await title(page, 'workshop');
  assert.equal(await page.evaluate(() => window.fairway.run.grids[0][0].frame.resolution), 0.05);
  await dropped(page, [await given('doorways.yaml'), await given('maps/doorways.png'), await given('maps/doorways.yaml')]);
  await title(page, 'doorways');
  await dropped(page, [['nonsense.png', btoa('no picture')], await given('maps/workshop.yaml')]);
  await until(page, () => /expected/.test(document.getElementById('notice').textContent));
}));

test('saved files are the tool\'s: scenario, recording, report', () => withPage(async (page) => {
  await until(page, () => window.fairway.run.duration > 3);
  await page.click('#play');
  await page.click('#save');
  const save = async (text, name) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#saves a:has-text("${text}")`)]);
    assert.equal(download.suggestedFilename(), name);
    await download.saveAs(join(folder, name));
    return join(folder, name);
  };
  const recording = await save('Recording', 'run.mcap');
  execFileSync('python3', ['-m', 'zipfile', '-e', await save('Scenario', 'scenario.zip'), join(folder, 'scenario')]);
  execFileSync(program('fairway'), ['simulate', join(folder, 'scenario/scenario.yaml'), '--json', join(folder, 'saved.json')]);
  assert.ok((await stat(recording)).size > 1000);
  const { page: replay, errors, context } = await openPage(browser, pathToFileURL(await save('Report', 'run.html')).href);
  await replay.waitForFunction(() => window.fairway?.drawn > 0);
  assert.ok(await replay.evaluate(() => window.fairway.run.duration) > 3);
  assert.deepEqual(errors, []);
  await context.close();
}));

// The same steps as on the live page: a goal is set and reached, settings are changed, and so on.
const phone = { hasTouch: true, isMobile: true };
for (const [name, options] of Object.entries({
  laptop_dark: { viewport: { width: 1280, height: 720 }, colorScheme: 'dark' },
  phone_light: { viewport: { width: 390, height: 844 }, colorScheme: 'light', ...phone },
  phone_dark: { viewport: { width: 390, height: 844 }, colorScheme: 'dark', ...phone },
})) {
  test(`a walkthrough without a dead end: ${name}`, () => withPage(async (page) => {
    await walk(page, { touch: options.hasTouch, name: `playground_${name}` });
    const sheet = await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth);
    assert.ok(sheet, 'expected no horizontal scrolling');
  }, { options }));
}
