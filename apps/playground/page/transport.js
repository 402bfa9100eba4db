// SPDX-License-Identifier: Apache-2.0
// What the live page uses in place of a server: a socket, `fetch` and downloads that lead to the
// world in a worker. The page's own script receives these as its WebSocket, fetch and location.
const playground = (() => {
  const text = (id) => document.getElementById(id).textContent.trim();
  const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const through = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
  const fail = (why) => {
    const notice = document.getElementById('notice');
    notice.textContent = `The playground cannot run here: ${why}`;
    notice.hidden = false;
  };

  const worker = new Worker(URL.createObjectURL(new Blob([text('worker')], { type: 'text/javascript' })));
  const files = new Map(); // by request: what to do with a file from the world
  let requests = 0;
  let socket = null;

  class LocalSocket extends EventTarget {
    static OPEN = 1;
    readyState = 0;

    constructor() {
      super();
      socket = this;
    }

    send(message) {
      worker.postMessage({ do: 'receive', text: message });
    }

    close() {}

    told(data) {
      this.dispatchEvent(new MessageEvent('message', { data }));
    }
  }

  worker.addEventListener('error', ({ message }) => fail(message));
  worker.addEventListener('message', ({ data }) => {
    if (data.failed) return fail(data.failed);
    if (data.request !== undefined) {
      files.get(data.request)(data.bytes);
      return files.delete(data.request);
    }
    if (data.ready) {
      socket.readyState = LocalSocket.OPEN;
      socket.dispatchEvent(new Event('open'));
      return undefined;
    }
    return socket.told(data.text ?? data.bytes);
  });

  const localFetch = async (path, options) => {
    if (path !== '/map') return new Response('', { status: 404 });
    worker.postMessage({ do: 'upload', text: options.body });
    return new Response('');
  };

  /** A file of the world: 0 the recording, 1 the scenario as ZIP, 2 the report. */
  const file = (what) => new Promise((resolve) => {
    files.set(++requests, resolve);
    worker.postMessage({ do: 'download', request: requests, what });
  });

  const saved = { '/recording.mcap': [0, 'run.mcap'], '/scenario.zip': [1, 'scenario.zip'], '/report.html': [2, 'run.html'] };
  document.addEventListener('click', async (event) => {
    const href = event.target.closest?.('a[href]')?.getAttribute('href');
    if (!(href in saved)) return;
    event.preventDefault();
    const [what, name] = saved[href];
    const url = URL.createObjectURL(new Blob([await file(what)]));
    Object.assign(document.createElement('a'), { href: url, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
  });

  /** The files of a ZIP archive by name. */
  const unzip = async (bytes) => {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    let end = bytes.length - 22;
    while (end >= 0 && view.getUint32(end, true) !== 0x06054B50) --end;
    if (end < 0) throw new Error('expected a ZIP archive');
    const found = {};
    let at = view.getUint32(end + 16, true);
    for (let i = view.getUint16(end + 10, true); i > 0; --i) {
      const length = view.getUint16(at + 28, true);
      const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + length));
      const local = view.getUint32(at + 42, true);
      const begin = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
      const content = bytes.subarray(begin, begin + view.getUint32(at + 20, true));
      found[name] = view.getUint16(at + 10, true) === 8 ? await through(content, new DecompressionStream('deflate-raw')) : content;
      at += 46 + length + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    }
    return found;
  };

  /**
   * Begins with a scenario and its files, [name, content] each; without files with the built-in maps.
   * The scenario and its map may have the same name.
   */
  const begin = (given = []) => {
    const here = {};
    const short = (name) => name.slice(name.lastIndexOf('/') + 1);
    const isScenario = ([name, content]) => /\.ya?ml$/i.test(name) && /^robots:/m.test(new TextDecoder().decode(content));
    const scenario = given.find(isScenario);
    if (given.length > 0 && !scenario) throw new Error('expected a scenario with robots');
    const yaml = scenario ? `/scenario/${short(scenario[0])}` : '';
    // A scenario may name its map with a folder or without.
    for (const [name, content] of given) {
      for (const path of [short(name), `maps/${short(name)}`]) here[`/scenario/${path}`] = content;
    }
    for (const [name, content] of given) {
      if (!isScenario([name, content])) here[`/scenario/maps/${short(name)}`] = content;
    }
    if (scenario) here[yaml] = scenario[1];
    worker.postMessage({ do: 'begin', files: here, scenario: yaml });
  };

  /** A link that holds the scenario as it is now: a line with names and sizes of its files, then they. */
  const link = async () => {
    const held = Object.entries(await unzip(new Uint8Array(await file(1)))).map(([name, content]) => {
      if (name !== 'scenario.yaml') return [name, content];
      const [head, settings] = new TextDecoder().decode(content).split(/^settings:$/m);
      return [name, new TextEncoder().encode(`${head}settings:${settings.replace(/ *#.*$/gm, '')}`)]; // without comments
    });
    const sizes = JSON.stringify(held.map(([name, content]) => [name, content.length]));
    const packed = await through(new Blob([`${sizes}\n`, ...held.map(([, content]) => content)]), new CompressionStream('deflate-raw'));
    let binary = '';
    for (let i = 0; i < packed.length; i += 0x8000) binary += String.fromCharCode(...packed.subarray(i, i + 0x8000));
    return `#scenario=${btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
  };
  const linked = async (hash) => {
    const held = await through(bytesOf(hash.replaceAll('-', '+').replaceAll('_', '/')), new DecompressionStream('deflate-raw'));
    let at = held.indexOf(10) + 1;
    return Object.fromEntries(JSON.parse(new TextDecoder().decode(held.subarray(0, at))).map(([name, size]) => {
      at += size;
      return [name, held.subarray(at - size, at)];
    }));
  };

  (async () => {
    const wasm = await through(bytesOf(text('world')), new DecompressionStream('gzip'));
    worker.postMessage({ do: 'start', wasm: wasm.buffer }, [wasm.buffer]);
    const [, hash] = /^#scenario=([\w-]+)$/.exec(location.hash) ?? [];
    let given = [];
    try {
      if (hash) given = Object.entries(await linked(hash));
      begin(given);
    } catch (error) {
      begin();
      socket.told(JSON.stringify({ notice: `The link's scenario cannot be read: ${error.message}` }));
    }
  })().catch((error) => fail(error.message));

  return {
    WebSocket: LocalSocket, fetch: localFetch, location: { protocol: 'http:', get href() { return window.location.href; }, get hash() { return window.location.hash; } },
    begin, file, link, unzip,
    notice: (notice) => socket.told(JSON.stringify({ notice })),
  };
})();
