// Reading zips one entry at a time, with limits that keep a malicious one harmless.

import { unzipSync } from "fflate";

/** Largest single file taken out of a zip. */
const MOST_ENTRY_BYTES = 256 << 20;
/** Most bytes that all files of a zip together may unpack to. */
const MOST_TOTAL_BYTES = 4 * 2 ** 30;
/** Most files in a zip. */
const MOST_ENTRIES = 100_000;

/**
 * Lists the `.txt` files of a zip: `{ entries, problems }`, where an entry is `{ path, read() }`.
 * Nothing is unpacked before it is read. Throws where the bytes are no zip, or a damaged one.
 */
export function listZip(bytes) {
  const entries = new Map();
  const problems = [];
  let total = 0;
  let seen = 0;
  scan(bytes, ({ name, originalSize }) => {
    seen += 1;
    if (seen > MOST_ENTRIES) {
      throw new Error(`it holds more than ${MOST_ENTRIES} files`);
    }
    if (!/\.txt$/i.test(name)) {
      return;
    }
    total += originalSize;
    if (originalSize > MOST_ENTRY_BYTES || total > MOST_TOTAL_BYTES) {
      problems.push({ path: name, message: "it is too large to be unpacked" });
      return;
    }
    entries.set(name, { path: name, read: () => readEntry(bytes, name) });
  });
  return { entries: [...entries.values()], problems };
}

function readEntry(bytes, wanted) {
  // The output buffer has the size that the directory states, so an entry that would unpack to
  // more is cut there instead of filling the memory.
  let found;
  try {
    found = unzipSync(bytes, { filter: ({ name }) => name === wanted })[wanted];
  } catch (error) {
    throw new Error(`it cannot be unpacked: ${error.message}`);
  }
  if (!found) {
    throw new Error("it is listed in the zip but not there");
  }
  return found;
}

function scan(bytes, visit) {
  try {
    unzipSync(bytes, {
      filter: (entry) => {
        visit(entry);
        return false;
      },
    });
  } catch (error) {
    if (/invalid zip data/i.test(error.message)) {
      throw new Error("it is no zip, or a damaged one: its directory cannot be read");
    }
    throw error;
  }
}
