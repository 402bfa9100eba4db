// SPDX-License-Identifier: Apache-2.0
// The same port speaks foxglove.websocket.v1, tested with that protocol's own client library.
import protocol from '@foxglove/ws-protocol';
import assert from 'node:assert/strict';
import { once } from 'node:events';
import test, { after, before } from 'node:test';
import { WebSocket } from 'ws';
import { serve } from './support/server.mjs';

const { FoxgloveClient } = protocol;
let server;

before(async () => {
  server = await serve();
});

after(async () => {
  assert.equal(await server.stop(), 0);
});

const connect = () => new FoxgloveClient({
  ws: new WebSocket(server.url.replace('http', 'ws'), [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
});

const next = (client, event) => new Promise((resolve) => client.on(event, resolve));

test('channels are advertised, subscribed to, and carry messages of their schemas', async () => {
  const client = connect();
  const [info, channels] = await Promise.all([next(client, 'serverInfo'), next(client, 'advertise')]);
  assert.equal(info.name, 'fairway');
  const byTopic = new Map(channels.map((channel) => [channel.topic, channel]));
  assert.equal(byTopic.get('/map').schemaName, 'foxglove.Grid');
  assert.equal(byTopic.get('/robot/scene').schemaName, 'foxglove.SceneUpdate');
  for (const channel of channels) {
    assert.equal(channel.encoding, 'json');
    assert.equal(JSON.parse(channel.schema).type, 'object');
  }
  const wanted = ['/map', '/tf', '/robot/way', '/robot/scene', '/robot/pose', '/robot/cycle'];
  const waiting = new Map(wanted.map((topic) => [client.subscribe(byTopic.get(topic).id), topic]));
  const got = new Map();
  await new Promise((resolve) => client.on('message', ({ subscriptionId, data, timestamp }) => {
    got.set(waiting.get(subscriptionId), { json: JSON.parse(new TextDecoder().decode(data)), timestamp });
    if (got.size === wanted.length) resolve();
  }));
  // The map arrives although it was sent before.
  const map = got.get('/map').json;
  assert.equal(Buffer.from(map.data, 'base64').length % map.column_count, 0);
  assert.equal(got.get('/tf').json.child_frame_id, 'robot');
  assert.ok(got.get('/robot/way').json.entities.some((entity) => entity.id === 'path'));
  const scene = got.get('/robot/scene');
  assert.equal(BigInt(scene.json.entities[0].timestamp.sec) * 1_000_000_000n + BigInt(scene.json.entities[0].timestamp.nsec), scene.timestamp);
  client.close();
});

test('no message arrives after unsubscribing', async () => {
  const client = connect();
  const channels = await next(client, 'advertise');
  const id = client.subscribe(channels.find(({ topic }) => topic === '/fairway/world').id);
  await next(client, 'message');
  client.unsubscribe(id);
  // The server handles requests in order. The first message of a later subscription therefore ends
  // the time in which messages of the earlier one may still arrive.
  const later = client.subscribe(channels.find(({ topic }) => topic === '/robot/pose').id);
  let late = 0;
  let seen = 0;
  await new Promise((resolve) => client.on('message', ({ subscriptionId }) => {
    if (subscriptionId === later && ++seen === 10) resolve();
    if (subscriptionId === id && seen > 0) ++late;
  }));
  assert.equal(late, 0);
  client.close();
});

test('a new run withdraws its channels and advertises them again', async () => {
  const client = connect();
  const before = await next(client, 'advertise');
  const page = new WebSocket(server.url.replace('http', 'ws') + 'live');
  await once(page, 'open');
  const [gone, now] = [next(client, 'unadvertise'), next(client, 'advertise')];
  page.send(JSON.stringify({ do: 'restart' }));
  assert.deepEqual([...await gone].sort(), before.map(({ id }) => id).sort());
  assert.deepEqual((await now).map(({ topic }) => topic), before.map(({ topic }) => topic));
  page.close();
  client.close();
});

test('invalid messages are answered and then ignored', async () => {
  const socket = new WebSocket(server.url.replace('http', 'ws'), ['foxglove.websocket.v1']);
  await once(socket, 'open');
  const statuses = [];
  socket.on('message', (data, binary) => {
    if (!binary && JSON.parse(data).op === 'status') statuses.push(data);
  });
  for (const text of ['', '{}', '{"op":"subscribe"}', '{"op":"subscribe","subscriptions":[{"id":"x","channelId":0}]}', '{"op":"subscribe","subscriptions":[{"id":0,"channelId":4000000}]}', '{"op":"unsubscribe","subscriptionIds":[7]}']) socket.send(text);
  for (const end = Date.now() + 120_000; statuses.length < 4 && Date.now() < end;) await new Promise((done) => setTimeout(done, 50));
  assert.equal(statuses.length, 4);
  assert.ok(server.alive());
  socket.close();
});
