// SPDX-License-Identifier: Apache-2.0
// What the pages show of a robot that knows only its lidar scans and odometry.
import assert from 'node:assert/strict';
import test from 'node:test';
import { McapIndexedReader } from '@mcap/core';
import { decompress } from 'fzstd';
import { execFileSync } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { openPage } from './support/browser.mjs';
import { confirm } from './support/live.mjs';
import { picture, shared, useRun, withPage } from './support/replay_page.mjs';
import { program, simulatedRun } from './support/runs.mjs';
import { serve } from './support/server.mjs';

useRun(() => simulatedRun('workshop', ['--sensing', 'lidar', '--noise', 'standard', '--time-limit', '8']));

const seek = async (page, to) => {
  await page.evaluate((t) => window.fairway.onSeek(t), to);
  return picture(page);
};

test('shows its scan at the true walls', () => withPage(async (page) => {
  await seek(page, 6);
  // The number of scan points on the map, and how many of them are on or beside an occupied cell.
  const { points, near } = await page.evaluate(() => {
    const { run, moment } = window.fairway;
    const { frame, cells } = run.grids[0][0];
    const { scan, belief } = moment.frame.robots[0];
    const blocked = (x, y) => cells[y * frame.width + x] === 1;
    const [c, s] = [Math.cos(belief.heading), Math.sin(belief.heading)];
    const bodies = moment.frame.bodies;
    let onWall = 0;
    for (let i = 0; i < scan.points.length; i += 2) {
      const p = { x: scan.points[i], y: scan.points[i + 1] };
      const at = { x: belief.x + c * p.x - s * p.y, y: belief.y + s * p.x + c * p.y };
      const [u, v] = [(at.x - frame.origin.x) / frame.resolution, (at.y - frame.origin.y) / frame.resolution].map(Math.floor);
      let found = bodies.some((b) => Math.hypot(b.x - at.x, b.y - at.y) < b.radius + 0.2);
      for (let dy = -2; dy <= 2; ++dy) for (let dx = -2; dx <= 2; ++dx) found ||= blocked(u + dx, v + dy);
      if (found) ++onWall;
    }
    return { points: scan.points.length / 2, near: onWall };
  });
  assert.ok(points > 500, `${points}`);
  assert.ok(near > 0.9 * points, `${near} of ${points}`);
}));

test('shows the map while its known area grows', () => withPage(async (page) => {
  const unknown = async (to) => {
    await seek(page, to);
    return page.evaluate(() => {
      const { run, moment, time } = window.fairway;
      const { known, occupied } = moment.frame.robots[0].slots;
      const cellsOf = (slot) => {
        const grid = run.grids[slot].filter((g) => g.time <= time + 1e-9).at(-1);
        const cells = grid.cells.slice();
        for (const { time: at, runs } of grid.changes) {
          for (let i = 0; at <= time + 1e-9 && i < runs.length; i += 4) {
            const start = runs[i] * grid.frame.width + runs[i + 1];
            cells.fill(runs[i + 3], start, start + runs[i + 2]);
          }
        }
        return cells;
      };
      const [blocked, walls] = [cellsOf(known), cellsOf(occupied)];
      return { unknown: blocked.filter((cell, i) => cell === 1 && walls[i] === 0).length, walls: walls.filter((cell) => cell === 1).length };
    });
  };
  const early = await unknown(0.2);
  const late = await unknown(3);
  assert.ok(early.unknown > 10_000 && late.unknown < early.unknown, `${early.unknown} ${late.unknown}`);
  assert.ok(late.walls > 100, `${late.walls}`);
}));

test('its layers and its legend exist and can be hidden', () => withPage(async (page) => {
  const all = await seek(page, 5);
  await page.click('#show-layers');
  for (const layer of ['seen', 'scan']) {
    await page.uncheck(`[data-layer="${layer}"]`);
    assert.notEqual(await picture(page), all, layer);
    await page.check(`[data-layer="${layer}"]`);
    assert.equal(await picture(page), all, layer);
  }
  const legend = await page.textContent('#legend');
  assert.match(legend, /Lidar points/);
  // Cells and tracks are two things, in two colours.
  assert.match(legend, /Mapped obstacle.*Tracked object/);
  const colors = await page.evaluate(() => [...document.querySelectorAll('#legend i')].map((mark) => mark.style.borderTopColor));
  assert.equal(new Set(colors).size, colors.length);
}));

test('shows its goal and its limiting factor', () => withPage(async (page) => {
  await seek(page, 4);
  const { goal, task, limits } = await page.evaluate(() => {
    const { run, moment } = window.fairway;
    return { goal: moment.frame.robots[0].goal, task: run.begin.robots[0].goal, limits: run.frames.filter((f) => f.robots[0].cycle?.limit > 0).length };
  });
  assert.ok(Math.abs(goal.x - task[0]) < 1e-3 && Math.abs(goal.y - task[1]) < 1e-3);
  assert.ok(limits > 5);
  assert.match(await page.textContent('.card .why'), /Limited by|Active constraint|Unconstrained|Stopped|Waiting/);
}));

test('its recording has scans and the sensed map in schemas of Foxglove', async () => {
  const bytes = await readFile(shared.run.recording);
  const file = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
    },
    decompressHandlers: { zstd: (data) => decompress(data) },
  });
  const schemas = new Map([...file.schemasById.values()].map((schema) => [schema.id, schema]));
  const kinds = Object.fromEntries([...file.channelsById.values()].map((c) => [c.topic, schemas.get(c.schemaId).name]));
  assert.equal(kinds['/amr/scan'], 'foxglove.LaserScan');
  assert.equal(kinds['/amr/map'], 'foxglove.Grid');
  const known = new Set(['map']);
  let scans = 0;
  for await (const message of file.readMessages({ topics: ['/tf', '/amr/scan', '/amr/map'] })) {
    const json = JSON.parse(new TextDecoder().decode(message.data));
    if (json.child_frame_id) {
      known.add(json.child_frame_id);
    } else if (json.ranges) {
      ++scans;
      assert.equal(json.frame_id, 'amr_odom');
      assert.equal(json.ranges.length, 720);
      assert.ok(json.ranges.every((range) => Number.isFinite(range) && range >= 0));
      assert.ok(Math.abs(json.end_angle - json.start_angle - 1.5 * Math.PI) < 1e-9);
    } else {
      assert.equal(json.frame_id, 'amr_odom');
    }
  }
  assert.ok(known.has('amr_odom') && known.has('amr'));
  assert.ok(scans > 100, `${scans}`);
});

test('the live page switches the robots between the map and their lidar', async () => {
  const server = await serve();
  const { context, page, errors } = await openPage(shared.browser, server.url);
  const { context: other, page: beside } = await openPage(shared.browser, server.url);
  try {
    await page.waitForFunction(() => window.fairway?.drawn > 0);
    await page.selectOption('#map-choice', { label: 'Empty hall' });
    await confirm(page);
    await page.waitForFunction(() => window.fairway.run.begin.name === 'Empty hall');
    await page.selectOption('#senses', { label: 'Noisy lidar + odometry' });
    await confirm(page);
    await page.waitForFunction(() => window.fairway.run.lidar && window.fairway.run.frames.at(-1)?.robots[0].scan?.points.length > 600);
    // Another page shows the same choice.
    await beside.waitForFunction(() => window.fairway?.run?.lidar
      && document.getElementById('senses').selectedOptions[0].textContent === 'Noisy lidar + odometry');
    // The robot uses its own map, and detects a wall that is drawn across its path.
    await page.waitForFunction(() => (window.fairway.run.frames.at(-1)?.robots[0].cycle?.linear ?? 0) > 0.5);
    await page.evaluate(() => document.getElementById('tool-wall').click());
    const box = await page.locator('#map').boundingBox();
    const at = async (x, y) => {
      const p = await page.evaluate(([wx, wy]) => window.fairway.camera.toScreen({ x: wx, y: wy }), [x, y]);
      return [box.x + p.x, box.y + p.y];
    };
    await page.mouse.move(...await at(12, 6));
    await page.mouse.down();
    await page.mouse.move(...await at(9, 12), { steps: 8 });
    await page.mouse.up();
    await page.waitForFunction(() => window.fairway.run.grids[0].at(-1).changes.length > 0);
    // The robot's own map contains the wall before the robot arrives, or the robot drives around
    // it.
    await page.waitForFunction(() => {
      const { run } = window.fairway;
      const robot = run.frames.at(-1).robots[0];
      const { points } = robot.scan;
      return points.some((x, i) => i % 2 === 0 && Math.hypot(x - 10.5, points[i + 1] - 9) < 1.5);
    });
    const saved = await (await fetch(new URL('/scenario.zip', server.url))).arrayBuffer();
    assert.match(Buffer.from(saved).toString('latin1'), /sensing: lidar\nnoise: standard\nphysics: unicycle/);
    const recording = join(shared.run.folder, 'live.mcap');
    await writeFile(recording, Buffer.from(await (await fetch(new URL('/recording.mcap', server.url))).arrayBuffer()));
    assert.match(execFileSync(program('fairway'), ['replay', recording], { encoding: 'utf8' }), /every command the same to the bit/);
    await page.selectOption('#senses', { label: 'Known map' });
    await confirm(page);
    await page.waitForFunction(() => !window.fairway.run.lidar && window.fairway.run.frames.length > 3);
    assert.ok(await page.isHidden('label:has([data-layer="scan"])'));
    assert.deepEqual(errors, []);
  } finally {
    await context.close();
    await other.close();
    assert.equal(await server.stop(), 0);
  }
});
