// SPDX-License-Identifier: Apache-2.0
// The world's worker: it holds the WebAssembly module, advances the world, and passes messages on.
'use strict';

const waiting = [];
let world = null; // the module, once it is ready
let timer = 0;

/** Calls `use` with a copy of bytes in the module's memory. */
const withBytes = (bytes, use) => {
  const at = world._malloc(bytes.length || 1);
  world.HEAPU8.set(bytes, at);
  try { return use(at, bytes.length); } finally { world._free(at); }
};
const withText = (text, use) => withBytes(new TextEncoder().encode(text), use);
const withPath = (path, use) => withText(`${path}\0`, use);

const actions = {
  receive: ({ text }) => withText(text, (at, size) => world._world_receive(at, size)),
  upload: ({ text }) => withText(text, (at, size) => world._world_upload(at, size)),
  download: ({ request, what }) => world._world_download(request, what),
  begin: ({ files, scenario }) => {
    for (const [path, bytes] of Object.entries(files)) {
      const folder = path.slice(0, path.lastIndexOf('/'));
      if (folder) withPath(folder, (at) => world._folder_make(at));
      withPath(path, (name) => withBytes(bytes, (at, size) => world._file_write(name, at, size)));
    }
    withPath(scenario, (at) => world._world_begin(at));
  },
};

// Several cycles in one turn where the world is late, so that short timers do not slow it down.
const tick = () => {
  clearTimeout(timer);
  const until = performance.now() + 15;
  let wait = 0;
  do wait = world._world_advance(); while (wait <= 0 && performance.now() < until);
  if (wait < Infinity) timer = setTimeout(tick, 1e3 * wait);
};

const act = (message) => {
  try {
    actions[message.do](message);
    tick();
  } catch (error) {
    self.postMessage({ failed: String(error) });
    throw error;
  }
};

self.onmessage = async ({ data }) => {
  if (data.do !== 'start') return world ? act(data) : void waiting.push(data);
  try {
    world = await createPlayground({
      wasmBinary: data.wasm,
      onText: (text) => self.postMessage({ text }),
      onBytes: (bytes) => self.postMessage({ bytes: bytes.buffer }, [bytes.buffer]),
      onFile: (request, bytes) => self.postMessage({ request, bytes: bytes.buffer }, [bytes.buffer]),
    });
  } catch (error) {
    return self.postMessage({ failed: String(error) });
  }
  self.postMessage({ ready: true });
  for (const message of waiting.splice(0)) act(message);
};
