// SPDX-License-Identifier: Apache-2.0

/** Reads the fields of a record that CompactFields wrote; throws RangeError beyond the end. */
export class Fields {
  private at: number;

  constructor(
    private readonly bytes: Uint8Array,
    from = 0,
    private readonly end = bytes.length,
  ) {
    this.at = from;
  }

  get position(): number {
    return this.at;
  }

  get done(): boolean {
    return this.at >= this.end;
  }

  byte(): number {
    if (this.at >= this.end) throw new RangeError('a record ends too early');
    return this.bytes[this.at++]!;
  }

  count(): number {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.byte();
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  }

  integer(): number {
    const zigzag = this.count();
    return zigzag % 2 === 0 ? zigzag / 2 : -(zigzag + 1) / 2;
  }

  millis(): number {
    return this.integer() / 1e3;
  }

  angle(): number {
    return this.integer() / 1e4;
  }

  real(): number {
    if (this.at + 8 > this.end) throw new RangeError('a record ends too early');
    const view = new DataView(this.bytes.buffer, this.bytes.byteOffset + this.at, 8);
    this.at += 8;
    return view.getFloat64(0, true);
  }

  text(): string {
    return new TextDecoder().decode(this.take(this.count()));
  }

  take(count: number): Uint8Array {
    if (this.at + count > this.end) throw new RangeError('a record ends too early');
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }
}

/** Decodes the bytes in a report: base64 of zlib's format. */
export async function unpack(base64: string): Promise<Uint8Array> {
  const text = atob(base64);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}
