// Where in an address results are kept: `#share=…`. Browsers never send a fragment to a server.

export const MARK = "share=";

/** Whether a fragment (with or without `#`) is meant to hold results. */
export function isShared(fragment: string): boolean {
  return bare(fragment).startsWith(MARK);
}

export function bare(fragment: string): string {
  return fragment.startsWith("#") ? fragment.slice(1) : fragment;
}
