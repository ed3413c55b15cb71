// The only addresses the page asks for data, and why it asks no others.

/** The public repository, as files. The content security policy names the same host. */
const PUBLIC_BASE = "https://raw.githubusercontent.com/chiararomanengo/Fit4CAD/main/";
const PUBLIC_ORIGIN = new URL(PUBLIC_BASE).origin;

export type Checked =
  | { readonly kind: "address"; readonly address: URL }
  | { readonly kind: "refused"; readonly reason: string };

/**
 * Where the public models come from: the public repository, or a copy of it on the page's own host
 * that `?source=` names.
 */
export function publicBase(): Checked {
  const asked = new URLSearchParams(location.search).get("source");
  if (asked === null) return { kind: "address", address: new URL(PUBLIC_BASE) };
  const address = resolve(asked.endsWith("/") ? asked : `${asked}/`);
  if (address?.origin === location.origin) return { kind: "address", address };
  return {
    kind: "refused",
    reason: `The public models cannot come from “${asked}”: a copy of the repository must lie on this page's own host (${location.host}).`,
  };
}

/** Whether models from there are the public ones, and not those of a copy. */
export function isPublicBase(base: URL): boolean {
  return base.href === PUBLIC_BASE;
}

/** Whether a zip may be opened by its address: the same host, or raw GitHub. */
export function checkZip(asked: string): Checked {
  const refuse = (why: string): Checked => ({ kind: "refused", reason: `“${asked}” was not opened: ${why}` });
  const address = resolve(asked);
  if (!address) return refuse("it is no address.");
  if (address.origin !== location.origin && address.origin !== PUBLIC_ORIGIN) {
    return refuse(
      `data comes from this page's own host (${location.host}) or ${PUBLIC_ORIGIN} only, so that a link cannot ` +
        "make your browser call on anyone else. Download the zip yourself and drop it here.",
    );
  }
  if (!/\.zip$/i.test(address.pathname)) return refuse("the address must be that of a zip, and end in .zip.");
  return { kind: "address", address };
}

function resolve(address: string): URL | undefined {
  return URL.canParse(address, location.href) ? new URL(address, location.href) : undefined;
}
