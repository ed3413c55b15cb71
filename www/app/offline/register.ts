// The service worker that makes the page work without a network after the first visit.

import { ownScript } from "../engine/own-script";
import { notify } from "../state/notices";

/** On a slow line, what the reader waits for comes before what is kept for later. */
const LATER_MS = 3000;

export function keepForOfflineLater(): void {
  setTimeout(keepForOffline, LATER_MS);
}

/**
 * Registers the service worker of a built page. A new version waits until every tab of the old one
 * is closed, so that nothing on screen changes under a reader's hands.
 */
function keepForOffline(): void {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  navigator.serviceWorker.register(ownScript("./sw.js")).then(announceUpdates, () => {
    // Private windows and plain http hosts refuse; the page works all the same, with a network.
  });
}

function announceUpdates(registration: ServiceWorkerRegistration): void {
  registration.addEventListener("updatefound", () => {
    const next = registration.installing;
    next?.addEventListener("statechange", () => {
      if (next.state === "installed" && navigator.serviceWorker.controller) {
        notify("A new version is ready. It starts when this page has been closed everywhere.");
      }
    });
  });
}
