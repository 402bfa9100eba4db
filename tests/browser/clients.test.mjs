// SPDX-License-Identifier: Apache-2.0
// Clients that disconnect, flood, stall or send invalid data: the server continues for the others.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import http from 'node:http';
import net from 'node:net';
import test, { after, before } from 'node:test';
import { WebSocket } from 'ws';
import { serve } from './support/server.mjs';

let server;

before(async () => {
  server = await serve();
});

after(async () => {
  assert.equal(await server.stop(), 0);
});

const live = () => server.url.replace('http', 'ws') + 'live';

async function connect(options = {}) {
  const socket = new WebSocket(live(), options);
  await once(socket, 'open');
  return socket;
}

/** Waits for the end of a connection, with or without an error. */
const closed = (socket) => new Promise((resolve) => socket.on('close', resolve));

/** The server still sends data to a new client. */
async function goesOn() {
  assert.ok(server.alive());
  const socket = await connect();
  let records = 0;
  socket.on('message', (data, binary) => { records += binary ? 1 : 0; });
  for (const end = Date.now() + 120_000; records < 3 && Date.now() < end;) await new Promise((done) => setTimeout(done, 50));
  socket.close();
  assert.ok(records >= 3);
}

const request = (options, body) => new Promise((resolve, reject) => {
  const sent = http.request({ host: '127.0.0.1', port: server.port, ...options }, (answer) => {
    let text = '';
    answer.on('data', (data) => { text += data; });
    answer.on('end', () => resolve({ status: answer.statusCode, headers: answer.headers, text }));
  });
  sent.on('error', reject);
  sent.end(body);
});

const refused = (options) => new Promise((resolve) => {
  const socket = new WebSocket(live(), options);
  socket.on('open', () => { socket.close(); resolve(0); });
  socket.on('unexpected-response', (_, answer) => resolve(answer.statusCode));
  socket.on('error', () => {});
});

test('pages of other sites may not connect, not even by names that resolve to this machine', async () => {
  assert.equal(await refused({ origin: 'https://example.com' }), 403);
  assert.equal(await refused({ origin: 'null' }), 403);
  assert.equal(await refused({ origin: `http://127.0.0.1:${server.port + 1}` }), 403);
  assert.equal(await refused({ origin: server.url.slice(0, -1) }), 0);
  assert.equal(await refused({ headers: { Host: 'attacker.example' } }), 421);
  assert.equal((await request({ path: '/', headers: { Host: 'attacker.example' } })).status, 421);
  const upload = { method: 'POST', path: '/map', headers: { Origin: 'https://example.com', 'Content-Type': 'application/json' } };
  assert.equal((await request(upload, '{}')).status, 403);
  const simple = { method: 'POST', path: '/map', headers: { 'Content-Type': 'text/plain' } };
  assert.equal((await request(simple, '{}')).status, 415);
});

test('no path gives access to a file', async () => {
  for (const path of ['/../../../../etc/passwd', '/%2e%2e/%2e%2e/etc/passwd', '//etc/passwd', '/index.html', '/map', '/live', '/?x', '*']) {
    const { status, text } = await request({ path });
    assert.equal(status, 404, path);
    assert.ok(!text.includes('root:'));
  }
  assert.equal((await request({ path: '/', method: 'PUT' }, 'x')).status, 405);
  const { headers } = await request({ path: '/' });
  assert.match(headers['content-security-policy'], /default-src 'none'/);
  assert.equal(headers['x-content-type-options'], 'nosniff');
});

test('data that are too large are refused', async () => {
  const head = { method: 'POST', path: '/map', headers: { 'Content-Type': 'application/json' } };
  const answer = await request({ ...head, headers: { ...head.headers, 'Content-Length': 25 * 1024 * 1024 } }, '{').catch(() => ({ status: 413 }));
  assert.equal(answer.status, 413);
  const { status } = await request({ path: '/', headers: { 'X-Long': 'x'.repeat(20_000) } }).catch(() => ({ status: 431 }));
  assert.notEqual(status, 200);
  const socket = await connect();
  socket.send('x'.repeat(100_000));
  const [code] = await once(socket, 'close');
  assert.equal(code, 1009);
  // A picture of 60000 x 60000 pixels in a few bytes.
  const bomb = Buffer.from('89504e470d0a1a0a0000000d494844520000ea600000ea60080000000000000000', 'hex');
  const { status: bombed } = await request(head, JSON.stringify({ name: 'b', resolution: 0.05, image: bomb.toString('base64') }));
  assert.equal(bombed, 422);
  await goesOn();
});

test('few downloads are served at a time, the others are asked to retry', async () => {
  const answers = await Promise.all(Array.from({ length: 20 }, () => request({ path: '/recording.mcap' })));
  const statuses = answers.map(({ status }) => status);
  assert.ok(statuses.includes(200) && statuses.every((status) => status === 200 || status === 503), `${statuses}`);
  assert.equal((await request({ path: '/scenario.zip' })).status, 200);
  await goesOn();
});

test('invalid messages are answered with the reason and have no effect', async () => {
  const socket = await connect();
  const notices = [];
  socket.on('message', (data, binary) => {
    if (binary) return;
    const { notice } = JSON.parse(data);
    if (notice) notices.push(notice);
  });
  const nonsense = ['', '{', '[]', 'null', '42', '{"do":"fly"}', '{"do":1}', '{"do":"goal"}', '{"do":"goal","robot":-1,"x":0,"y":0}',
    '{"do":"goal","robot":0,"x":1e999,"y":0}', '{"do":"goal","robot":0,"x":"a","y":0}', '{"do":"speed","factor":0}',
    '{"do":"paint","from":{"x":0,"y":0},"to":{"x":1e5,"y":0},"radius":1,"blocked":true}',
    '{"do":"paint","from":{"x":0,"y":0},"to":{"x":1,"y":0},"radius":-1,"blocked":true}', '{"do":"walk","x":null,"y":0}',
    '{"do":"set","assignment":7}', '{"do":"map","index":1.5}', '['.repeat(30_000), '\u0000', '{"do":"step"} x'];
  for (const text of nonsense) socket.send(text);
  socket.send(Buffer.from([1, 2, 3]), { binary: true });
  for (const end = Date.now() + 120_000; notices.length < nonsense.length + 1 && Date.now() < end;) await new Promise((done) => setTimeout(done, 50));
  assert.equal(notices.length, nonsense.length + 1);
  // These are well-formed, but there is no such robot, body, map or setting.
  for (const command of [{ do: 'goal', robot: 99, x: 1, y: 1 }, { do: 'goal', robot: 0, x: 1e5, y: 0 }, { do: 'pose', robot: 99, x: 1, y: 1, heading: 0 },
    { do: 'walk', body: 99, x: 1, y: 1 }, { do: 'remove_body', body: 0 }, { do: 'remove_robot', robot: 0 }, { do: 'map', index: 999 },
    { do: 'set', assignment: 'mpc.nothing=1' }, { do: 'set', assignment: 'mpc.step_length=nan' }, { do: 'set', assignment: '=' }]) {
    socket.send(JSON.stringify(command));
  }
  await goesOn();
  socket.close();
});

test('malformed requests and frames end only their own connection', async () => {
  for (const text of ['\r\n\r\n', 'GET', 'GET / HTTP/9.9\r\n\r\n', 'POST /map HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n',
    `GET /live HTTP/1.1\r\nHost: localhost:${server.port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\r\n`, '\x16\x03\x01\x02\x00\x01'.repeat(100)]) {
    const socket = net.connect(server.port, '127.0.0.1');
    socket.on('error', () => {});
    socket.on('data', () => {});
    socket.write(text);
    socket.end();  // the server closes a connection whose request is malformed or incomplete
    await closed(socket);
  }
  const socket = await connect();
  socket.on('error', () => {});
  socket._socket.write(Buffer.alloc(40, 255));
  await closed(socket);
  await goesOn();
});

test('clients that disconnect leave no resources behind', async () => {
  for (let i = 0; i < 200; ++i) {
    const socket = new WebSocket(live());
    socket.on('error', () => {});
    if (i % 2 === 0) await once(socket, 'open');  // the others end before the handshake does
    socket.terminate();
  }
  await goesOn();
});

test('a flooding client waits, the others do not', async () => {
  const flood = await connect();
  flood.on('error', () => {});
  const message = JSON.stringify({ do: 'speed', factor: 1 });
  for (let i = 0; i < 100_000; ++i) flood.send(message);
  await goesOn();
  flood.terminate();
});

test('a client that never reads does not block the others', async () => {
  const deaf = net.connect(server.port, '127.0.0.1');
  deaf.on('error', () => {});
  await once(deaf, 'connect');
  deaf.write(`GET /live HTTP/1.1\r\nHost: 127.0.0.1:${server.port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n`);
  deaf.pause();
  await goesOn();
  assert.ok(await server.memory() < 600e6);
  deaf.destroy();
});
