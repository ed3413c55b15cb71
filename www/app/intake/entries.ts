// Reads what was dropped: files, and folders to their end.

import type { BroughtFile, Unplaced } from "../state/inbox";

export interface Gathered {
  readonly files: BroughtFile[];
  readonly refused: Unplaced[];
}

/**
 * Must be called within the drop event: its items are gone once the event is over.
 */
export function gatherDrop(transfer: DataTransfer): Promise<Gathered> {
  const items = [...transfer.items].filter(({ kind }) => kind === "file");
  // oxlint-disable-next-line typescript/no-unnecessary-condition -- not every browser has it
  const entries = items.map((item) => item.webkitGetAsEntry?.() ?? item.getAsFile());
  return gather(entries.filter((entry) => entry !== null));
}

async function gather(entries: (FileSystemEntry | File)[]): Promise<Gathered> {
  const gathered: Gathered = { files: [], refused: [] };
  for (const entry of entries) {
    if (entry instanceof File) gathered.files.push({ path: entry.name, data: entry });
    else {
      const before = gathered.files.length + gathered.refused.length;
      await walk(entry, gathered);
      if (gathered.files.length + gathered.refused.length === before) gathered.refused.push({ path: entry.name, reason: "There is no file in it." });
    }
  }
  return gathered;
}

async function walk(entry: FileSystemEntry, into: Gathered): Promise<void> {
  const path = entry.fullPath.replace(/^\//, "") || entry.name;
  try {
    if (isDirectory(entry)) {
      for (const child of await childrenOf(entry)) await walk(child, into);
    } else if (isFile(entry)) {
      const data = await new Promise<File>((resolve, reject) => entry.file(resolve, reject));
      into.files.push({ path, data });
    }
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    into.refused.push({ path, reason: `The browser could not read it: ${why}` });
  }
}

/** Browsers hand out at most 100 entries at a time; an empty answer marks the end. */
async function childrenOf(directory: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = directory.createReader();
  const children: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return children;
    children.push(...some);
  }
}

function isDirectory(entry: FileSystemEntry): entry is FileSystemDirectoryEntry {
  return entry.isDirectory;
}

function isFile(entry: FileSystemEntry): entry is FileSystemFileEntry {
  return entry.isFile;
}

/** Files of an `<input type="file">`, with their folder where a folder was chosen. */
export function gatherChosen(list: FileList): Gathered {
  const files = [...list].map((file) => ({ path: file.webkitRelativePath || file.name, data: file }));
  return { files, refused: [] };
}
