// What the operating system said, in words.

/** @type {Readonly<Record<string, string>>} */
const COMMON = {
  ENOENT: "there is no such file or folder",
  ELOOP: "it is a loop of links",
  EISDIR: "it is a folder",
  ENOTDIR: "a part of its path is a file, not a folder",
  EEXIST: "a part of its path is a file, not a folder",
  ENAMETOOLONG: "its name is too long",
  ERR_INVALID_ARG_VALUE: "its name holds a character that no name of a file can",
  EIO: "the disk failed",
};

/** @type {Readonly<Record<string, string>>} */
const READING = { ...COMMON, EACCES: "reading it is not permitted", EPERM: "reading it is not permitted" };

/** @type {Readonly<Record<string, string>>} */
const WRITING = {
  ...COMMON,
  EACCES: "writing it is not permitted",
  EPERM: "writing it is not permitted",
  EROFS: "what is there can only be read",
  ENOSPC: "the disk is full",
  EDQUOT: "the disk is full",
  EFBIG: "it is larger than a file may be",
};

/**
 * Why something could not be read.
 * @param {unknown} error
 */
export function whyUnread(error) {
  return inWords(error, READING);
}

/**
 * Why something could not be written.
 * @param {unknown} error
 */
export function whyUnwritten(error) {
  return inWords(error, WRITING);
}

/**
 * @param {unknown} error
 * @param {Readonly<Record<string, string>>} words
 */
function inWords(error, words) {
  if (!(error instanceof Error)) {
    return String(error);
  }
  return ("code" in error ? words[String(error.code)] : undefined) ?? error.message;
}
