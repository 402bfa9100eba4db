// SPDX-License-Identifier: Apache-2.0
// The format's own library reads a recording, and its messages fit Foxglove's own schemas.
import { McapIndexedReader, McapStreamReader } from '@mcap/core';
import Ajv from 'ajv';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import test, { before } from 'node:test';
import { crc32 } from '@foxglove/crc';
import { decompress } from 'fzstd';
import { syntheticRun } from './support/runs.mjs';

const foxglove = createRequire(import.meta.url)('@foxglove/schemas/jsonschema');
const decompressHandlers = { zstd: (data) => decompress(data) };
let bytes;

before(async () => {
  bytes = await readFile((await syntheticRun()).recording);
});

const reader = () => McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) =>
      new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
  },
  decompressHandlers,
});

test('is indexed, with the statistics of its messages', async () => {
  const file = await reader();
  let count = 0n;
  let last = 0n;
  const topics = new Set();
  for await (const message of file.readMessages()) {
    assert.ok(message.logTime >= last);
    last = message.logTime;
    topics.add(file.channelsById.get(message.channelId).topic);
    ++count;
  }
  assert.equal(file.statistics.messageCount, count);
  assert.equal(file.statistics.messageEndTime, last);
  assert.equal(file.statistics.channelCount, file.channelsById.size);
  assert.equal(file.statistics.chunkCount, file.chunkIndexes.length);
  for (const topic of ['/map', '/tf', '/scene', '/robot_0/scene', '/robot_0/cycle', '/fairway/scenario']) {
    assert.ok(topics.has(topic), topic);
  }
});

test('gives one channel with the index alone', async () => {
  const file = await reader();
  let count = 0;
  for await (const message of file.readMessages({ topics: ['/robot_1/pose'], startTime: 10_000_000_000n, endTime: 20_000_000_000n })) {
    assert.equal(file.channelsById.get(message.channelId).topic, '/robot_1/pose');
    ++count;
  }
  assert.equal(count, 101);
});

test('has correct checksums of chunks, data and summary', () => {
  const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  stream.append(new Uint8Array(bytes));
  const seen = {};
  for (let record; (record = stream.nextRecord());) {
    seen[record.type] = (seen[record.type] ?? 0) + 1;
    if (record.type === 'DataEnd') assert.notEqual(record.dataSectionCrc, 0);
    if (record.type === 'Footer') {
      assert.notEqual(record.summaryCrc, 0);
      const end = bytes.length - 8 - 4;
      const summary = bytes.subarray(Number(record.summaryStart), end);
      assert.equal(crc32(summary), record.summaryCrc);
      const dataEnd = Number(record.summaryStart) - 13;
      assert.equal(crc32(bytes.subarray(0, dataEnd)), bytes.readUInt32LE(dataEnd + 9));
    }
  }
  assert.ok(stream.done());
  assert.equal(seen.Footer, 1);
  assert.ok(seen.Message > 1000);
});

test('contains messages that fit its own schemas and those of Foxglove', async () => {
  const ajv = new Ajv({ strict: false });
  const compiled = new Map();
  const file = await reader();
  for (const { id, name, encoding, data } of file.schemasById.values()) {
    assert.equal(encoding, 'jsonschema');
    const own = ajv.compile(JSON.parse(new TextDecoder().decode(data)));
    const theirs = name.startsWith('foxglove.') ? ajv.compile(foxglove[name.slice(9)]) : () => true;
    compiled.set(id, { name, own, theirs });
  }
  const seen = new Set();
  for await (const message of file.readMessages()) {
    const json = JSON.parse(new TextDecoder().decode(message.data));
    const { name, own, theirs } = compiled.get(file.channelsById.get(message.channelId).schemaId);
    assert.ok(own(json), `${name}: ${JSON.stringify(own.errors)}`);
    assert.ok(theirs(json), `${name}: ${JSON.stringify(theirs.errors)}`);
    seen.add(name);
  }
  for (const name of ['Grid', 'SceneUpdate', 'PoseInFrame', 'FrameTransform']) {
    assert.ok(seen.has(`foxglove.${name}`), name);
  }
});
