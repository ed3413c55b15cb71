// Words inside a PNG file.

import { crc32 } from "../../shared/crc32.mjs";

/** Signature and header chunk, which come first in every PNG file. */
const HEAD_BYTES = 8 + 25;

/** The file with an uncompressed `iTXt` chunk (PNG 1.2, section 4.2.3.3) after its header. */
export async function withText(png: Blob, keyword: string, text: string): Promise<Blob> {
  // Keyword, its end, no compression, no language, no translation of the keyword.
  const content = new TextEncoder().encode(`iTXt${keyword}\0\0\0\0\0${text}`);
  const chunk = new Uint8Array(content.length + 8);
  const numbers = new DataView(chunk.buffer);
  numbers.setUint32(0, content.length - 4);
  chunk.set(content, 4);
  numbers.setUint32(content.length + 4, crc32(content));
  return new Blob([png.slice(0, HEAD_BYTES), chunk, png.slice(HEAD_BYTES)], { type: "image/png" });
}
