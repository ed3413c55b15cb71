// Numbers and texts as bytes and back. Reading trusts nothing: every length is checked against
// what is there and against a limit before anything is allocated.

/** The bytes are not what was written. */
export class Damaged extends Error {
  constructor(what: string) {
    super(what);
    this.name = "Damaged";
  }
}

/** Longest text, in bytes of UTF-8. Longer ones are cut when written and refused when read. */
export const MAX_TEXT_BYTES = 200;

/** Control characters and those that turn the direction of writing could make a text look like another. */
// eslint-disable-next-line no-control-regex -- they are what is looked for
const INVISIBLE = /[\u0000-\u001f\u007f-\u009f\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]/gu;

function textBytes(value: string): Uint8Array<ArrayBuffer> {
  const bytes = new TextEncoder().encode(value.replace(INVISIBLE, "\ufffd"));
  let length = Math.min(bytes.length, MAX_TEXT_BYTES);
  // Not in the middle of a character: continuation bytes are 10xxxxxx.
  while (length < bytes.length && length > 0 && ((bytes[length] ?? 0) & 0xc0) === 0x80) length -= 1;
  return bytes.slice(0, length);
}

/** What becomes of a text that goes through a link. */
export function asLinkText(value: string): string {
  return new TextDecoder().decode(textBytes(value));
}

export class ByteWriter {
  readonly #bytes: number[] = [];

  u8(value: number): void {
    this.#bytes.push(value & 0xff);
  }

  raw(bytes: Iterable<number>): void {
    for (const byte of bytes) this.#bytes.push(byte);
  }

  /** A whole number from 0 to 2⁵³ − 1, seven bits to the byte, lowest first. */
  whole(value: number): void {
    if (!Number.isSafeInteger(value) || value < 0) throw new RangeError(`not a whole number: ${value}`);
    let rest = value;
    while (rest >= 0x80) {
      this.u8((rest % 0x80) | 0x80);
      rest = Math.floor(rest / 0x80);
    }
    this.u8(rest);
  }

  f32(value: number): void {
    this.raw(new Uint8Array(Float32Array.of(value).buffer));
  }

  f64(value: number): void {
    this.raw(new Uint8Array(Float64Array.of(value).buffer));
  }

  /**
   * Doubles with the first bytes of all, then the second bytes of all, and so on: signs and
   * exponents of like figures are alike, and side by side they compress.
   */
  planes(values: readonly number[]): void {
    const bytes = new Uint8Array(Float64Array.from(values).buffer);
    for (let plane = 0; plane < 8; plane += 1) {
      for (let at = plane; at < bytes.length; at += 8) this.u8(bytes[at] ?? 0);
    }
  }

  text(value: string): void {
    const bytes = textBytes(value);
    this.whole(bytes.length);
    this.raw(bytes);
  }

  finish(): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(this.#bytes);
  }
}

export class ByteReader {
  readonly #bytes: Uint8Array<ArrayBuffer>;
  #at = 0;

  constructor(bytes: Uint8Array<ArrayBuffer>) {
    this.#bytes = bytes;
  }

  get left(): number {
    return this.#bytes.length - this.#at;
  }

  raw(length: number): Uint8Array<ArrayBuffer> {
    if (length > this.left) throw new Damaged("it ends too early");
    const bytes = this.#bytes.slice(this.#at, this.#at + length);
    this.#at += length;
    return bytes;
  }

  u8(): number {
    return this.raw(1)[0] ?? 0;
  }

  /** A whole number of at most `most`. */
  whole(most: number = Number.MAX_SAFE_INTEGER): number {
    let value = 0;
    let scale = 1;
    for (;;) {
      const byte = this.u8();
      value += (byte & 0x7f) * scale;
      if (value > most) throw new Damaged(`a number is larger than ${most}`);
      if (byte < 0x80) return value;
      scale *= 0x80;
      if (scale > 2 ** 49) throw new Damaged("a number has too many digits");
    }
  }

  /** The length of a list whose elements take at least one byte each. */
  count(most: number): number {
    const length = this.whole(most);
    if (length > this.left) throw new Damaged("a list is longer than the link");
    return length;
  }

  f32(): number {
    return finite(new DataView(this.raw(4).buffer).getFloat32(0, true));
  }

  f64(): number {
    return finite(new DataView(this.raw(8).buffer).getFloat64(0, true));
  }

  planes(length: number): Float64Array {
    const bytes = this.raw(8 * length);
    const values = new Float64Array(length);
    const into = new Uint8Array(values.buffer);
    for (let plane = 0; plane < 8; plane += 1) {
      for (let i = 0; i < length; i += 1) into[8 * i + plane] = bytes[plane * length + i] ?? 0;
    }
    values.forEach(finite);
    return values;
  }

  text(): string {
    const bytes = this.raw(this.whole(MAX_TEXT_BYTES));
    let value: string;
    try {
      value = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
    } catch {
      throw new Damaged("a name is no text");
    }
    if (value.search(INVISIBLE) >= 0) throw new Damaged("a name holds control characters");
    return value;
  }

  /** Nothing may follow. */
  end(): void {
    if (this.left > 0) throw new Damaged("it goes on after its end");
  }
}

function finite(value: number): number {
  if (!Number.isFinite(value)) throw new Damaged("a figure is no number");
  return value;
}
