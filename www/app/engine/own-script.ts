// The scripts that the page starts beside itself: its workers. Browsers with Trusted Types start
// nothing that did not pass through here.

/** What of the Trusted Types of a browser is used; TypeScript does not know them yet. */
interface TrustedTypes {
  createPolicy(name: string, rules: { createScriptURL: (address: string) => string }): { createScriptURL: (address: string) => string };
}

/** The content security policy names it, and admits no other. */
const POLICY = "fit4cad";

/** An address below the page's own, or an error. */
export function ownAddress(address: string, page: string): string {
  const own = new URL(address, page);
  const folder = new URL("./", page);
  if (own.origin !== folder.origin || !own.pathname.startsWith(folder.pathname)) throw new TypeError(`${own.href} is no script of this page.`);
  return own.href;
}

const policy = (globalThis as { trustedTypes?: TrustedTypes }).trustedTypes?.createPolicy(POLICY, {
  createScriptURL: (address) => ownAddress(address, location.href),
});

/** An address for what takes none but of a script. In truth it is a `TrustedScriptURL` where the browser has them. */
export function ownScript(address: string): string {
  return policy ? policy.createScriptURL(address) : ownAddress(address, location.href);
}

/** Starts a module of `www/worker`, whose address a `?worker&url` import gives. */
export function startWorker(script: string, name: string): Worker {
  return new Worker(ownScript(script), { type: "module", name });
}
