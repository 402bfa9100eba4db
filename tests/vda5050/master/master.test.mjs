// SPDX-License-Identifier: Apache-2.0
// fairway_vda5050 under another project's fleet control, vda-5050-lib: see run.mjs.
// It checks every message by its own schemas of 2.0; ajv checks them by the published ones, where the shared data has them.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createServer, connect } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import test from 'node:test';

const [BIN, SCENARIOS, DATA] = process.env.FAIRWAY_VDA5050_MASTER.split(';');
const { default: vda } = await import('vda-5050-lib');
const { default: Ajv } = await import('ajv/dist/2020.js');

const MANUFACTURER = 'Fairway';
const AGV = { manufacturer: MANUFACTURER, serialNumber: 'amr1' };

/** Resolves when `holds` returns something true; the deadline only ends a test that hangs. */
async function until(holds, what, seconds = 60) {
  for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
    const value = await holds();
    if (value) return value;
    await new Promise((done) => { setTimeout(done, 10); });
  }
  throw new Error(`not within ${seconds} s: ${what}`);
}

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  await once(server, 'close');
  return port;
}

const answers = (port) => new Promise((done) => {
  const socket = connect(port, '127.0.0.1');
  socket.on('connect', () => { socket.destroy(); done(true); });
  socket.on('error', () => done(false));
});

/** A broker, a vehicle and a master controller; they end with the test. */
async function start(t) {
  const folder = mkdtempSync(path.join(tmpdir(), 'fairway-master-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const port = await freePort();
  const config = path.join(folder, 'mosquitto.conf');
  writeFileSync(config, `listener ${port} 127.0.0.1\nallow_anonymous true\npersistence false\nlog_type none\n`);
  const run = (program, args) => {
    const child = spawn(program, args, { stdio: 'ignore' });
    t.after(async () => {
      if (child.exitCode !== null) return;
      child.kill('SIGTERM');
      await once(child, 'exit');
    });
    return child;
  };
  run('/usr/sbin/mosquitto', ['-c', config]);
  await until(() => answers(port), 'the broker answers');
  run(path.join(BIN, 'fairway_vda5050'), ['--broker', '127.0.0.1', '--port', `${port}`, '--version', '2.0.0',
    '--map', path.join(SCENARIOS, 'maps', 'workshop.yaml'), '--simulate', '--start', '2.0,4.4,0.0', '--speed', '4']);
  const master = new vda.MasterController({
    interfaceName: 'uagv', vdaVersion: '2.0.0', transport: { brokerUrl: `mqtt://127.0.0.1:${port}` },
  }, {});
  const invalid = [];
  const states = [];
  const check = schemas();
  await master.start();
  t.after(() => master.stop());
  master.registerConnectionStateChange((now, before) => assert.ok(now !== 'broken', `${before} to ${now}`));
  for (const topic of ['state', 'connection', 'factsheet', 'visualization']) {
    await master.subscribe(topic, AGV, (message) => {
      if (topic === 'state') states.push(message);
      if (check[topic] && !check[topic](message)) invalid.push([topic, check[topic].errors]);
    });
  }
  await until(() => states.length > 0, 'a state');
  t.after(() => assert.deepEqual(invalid, []));
  return { master, states };
}

/** Checks by the published schemas of the 2.x line: none without the shared data. */
function schemas() {
  const folder = path.join(DATA, 'vda5050', 'schemas', '2.1.0');
  if (!existsSync(folder)) return {};
  const ajv = new Ajv({ strict: false, validateFormats: false });
  return Object.fromEntries(readdirSync(folder).map((file) => [path.basename(file, '.schema'),
    ajv.compile(JSON.parse(readFileSync(path.join(folder, file), 'utf8')))]));
}

/** An order along a chain of points. */
const order = (orderId, ...points) => ({
  orderId,
  orderUpdateId: 0,
  nodes: points.map(([x, y], i) => ({
    nodeId: `n${i}`, sequenceId: 2 * i, released: true, actions: [],
    nodePosition: { x, y, mapId: 'workshop', allowedDeviationXY: 0.4 },
  })),
  edges: points.slice(1).map((_, i) => ({
    edgeId: `e${i}`, sequenceId: 2 * i + 1, released: true, startNodeId: `n${i}`, endNodeId: `n${i + 1}`, actions: [],
  })),
});

/** Assigns an order; the events in their sequence, and the end. */
function assign(master, given) {
  const events = [];
  let end;
  const ended = new Promise((done) => { end = done; });
  const accepted = master.assignOrder(AGV, given, {
    onOrderProcessed: (withError, byCancelation, active, context) => end({ withError, byCancelation, active, context }),
    onNodeTraversed: (node) => events.push(node.nodeId),
    onEdgeTraversed: (edge) => events.push(edge.edgeId),
  });
  return { events, ended, accepted };
}

/** Initiates an instant action; resolves with its last state, or with the error that refuses it. */
async function act(master, actionType, actionParameters = []) {
  let end;
  const ended = new Promise((done) => { end = done; });
  await master.initiateInstantActions(AGV, {
    instantActions: [{ actionId: `${actionType}-${Date.now()}`, actionType, blockingType: 'HARD', actionParameters }],
  }, {
    onActionStateChanged: (state, error) => {
      if (state.actionStatus === 'FINISHED') end({ status: 'FINISHED' });
      if (state.actionStatus === 'FAILED') end({ status: 'FAILED', error });
    },
    onActionError: (error) => end({ error }),
  });
  return ended;
}

test('an order is driven, with an event for every node and edge', { timeout: 120_000 }, async (t) => {
  const { master, states } = await start(t);
  const drive = assign(master, order('drive', [2.0, 4.4], [4.0, 4.6], [5.6, 4.9], [8.2, 4.9]));
  const result = await drive.ended;
  assert.equal(result.withError, undefined);
  assert.equal(result.byCancelation, false);
  assert.equal(result.active, false);
  assert.deepEqual(drive.events, ['n0', 'e0', 'n1', 'e1', 'n2', 'e2', 'n3']);
  const { x, y } = result.context.state.agvPosition;
  assert.ok(Math.hypot(x - 8.2, y - 4.9) < 0.4);
  assert.ok(states.some((state) => state.driving));
});

test('an order is paused, resumed and cancelled', { timeout: 120_000 }, async (t) => {
  const { master, states } = await start(t);
  const drive = assign(master, order('long', [2.0, 4.4], [5.6, 4.9], [8.2, 4.9]));
  await until(() => states.at(-1)?.driving, 'it drives');
  assert.deepEqual(await act(master, 'startPause'), { status: 'FINISHED' });
  await until(() => states.at(-1)?.paused && states.at(-1)?.driving === false, 'it stands');
  assert.deepEqual(await act(master, 'stopPause'), { status: 'FINISHED' });
  await until(() => states.at(-1)?.paused === false && states.at(-1)?.driving, 'it drives again');
  assert.deepEqual(await act(master, 'cancelOrder'), { status: 'FINISHED' });
  const result = await drive.ended;
  assert.equal(result.byCancelation, true);
  await until(() => states.at(-1)?.driving === false && states.at(-1)?.nodeStates.length === 0, 'it stands without an order');
});

test('refusals reach the master as errors of the order and of the action', { timeout: 120_000 }, async (t) => {
  const { master } = await start(t);
  const blocked = await assign(master, order('wall', [2.0, 4.4], [-50.0, 4.4])).ended;
  assert.ok(blocked.withError, 'a node outside the map');
  assert.ok(blocked.withError.errorReferences.some(({ referenceValue }) => referenceValue === 'wall'));
  const lift = order('lift', [2.0, 4.4], [4.0, 4.6]);
  lift.nodes[1].actions.push({ actionId: 'up', actionType: 'lift', blockingType: 'HARD', actionParameters: [] });
  const unknown = await assign(master, lift).ended;
  assert.equal(unknown.withError?.errorType, 'orderError');
  const references = unknown.withError.errorReferences.map(({ referenceKey, referenceValue }) => `${referenceKey} ${referenceValue}`);
  for (const named of ['topic order', 'orderId lift', 'actionId up']) assert.ok(references.includes(named), named);
  const nothing = await act(master, 'cancelOrder');
  assert.equal(nothing.status, 'FAILED');
  assert.equal(nothing.error?.errorType, 'noOrderToCancel');
});

test('an order is extended while it is driven', { timeout: 120_000 }, async (t) => {
  const { master, states } = await start(t);
  const whole = order('stitched', [2.0, 4.4], [5.6, 4.9], [8.2, 4.9]);
  const first = structuredClone(whole);
  first.nodes[2].released = false;
  first.edges[1].released = false;
  assign(master, first);
  await until(() => states.at(-1)?.driving, 'it drives');
  const rest = { ...structuredClone(whole), orderUpdateId: 1, nodes: whole.nodes.slice(1), edges: whole.edges.slice(1) };
  const result = await assign(master, rest).ended;
  assert.equal(result.withError, undefined);
  assert.equal(result.context.state.lastNodeId, 'n2');
  assert.equal(result.context.state.orderUpdateId, 1);
});
