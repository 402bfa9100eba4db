// SPDX-License-Identifier: Apache-2.0
import type { LiveMessage } from '../data/live_messages';

/** What a page does with what arrives from the server. */
export interface Receiver {
  opened(): void;
  message(message: LiveMessage): void;
  records(bytes: Uint8Array): void;
  closed(): void;
}

const SOON = 250; // until the first attempt to reconnect [ms]
const LONG = 5000; // between later attempts, at most [ms]

/** The WebSocket of the server that the page came from; after a loss it is opened again. */
export class Connection {
  private socket!: WebSocket;
  private retry = SOON;

  constructor(private readonly receiver: Receiver) {
    this.open();
  }

  get isOpen(): boolean {
    return this.socket.readyState === WebSocket.OPEN;
  }

  /** @return whether the command was sent. */
  send(command: Record<string, unknown>): boolean {
    if (!this.isOpen) return false;
    this.socket.send(JSON.stringify(command));
    return true;
  }

  private open(): void {
    const url = new URL('/live', location.href);
    url.hash = '';
    url.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
    const { receiver } = this;
    const socket = new WebSocket(url);
    socket.binaryType = 'arraybuffer';
    socket.addEventListener('open', () => {
      this.retry = SOON;
      receiver.opened();
    });
    socket.addEventListener('message', ({ data }) => {
      if (typeof data === 'string') receiver.message(JSON.parse(data) as LiveMessage);
      else receiver.records(new Uint8Array(data as ArrayBuffer));
    });
    socket.addEventListener('close', () => {
      receiver.closed();
      setTimeout(() => this.open(), this.retry);
      this.retry = Math.min(this.retry * 2, LONG);
    });
    this.socket = socket;
  }
}
