// The content security policy of the built page: it is there, it holds, and nothing of the page offends it.

import { test as plain, type Page } from "@playwright/test";
import { expect, open, test } from "./support/test";

/** What the policy forbids, and the page must not do. */
const FORBIDDEN: Readonly<Record<string, () => unknown>> = {
  "markup from text": () => (document.createElement("div").innerHTML = "<b>bold</b>"),
  "a document from text": () => new DOMParser().parseFromString("<b>bold</b>", "text/html"),
  "a worker by its bare address": () => new Worker("./assets/worker.js"),
  "a script by its bare address": () => (document.createElement("script").src = "./assets/script.js"),
  "a policy of another name": () =>
    (globalThis as unknown as { trustedTypes: { createPolicy: (name: string, rules: object) => void } }).trustedTypes.createPolicy("other", {}),
  "the page's policy once more": () =>
    (globalThis as unknown as { trustedTypes: { createPolicy: (name: string, rules: object) => void } }).trustedTypes.createPolicy("fit4cad", {}),
};

async function violations(page: Page): Promise<string[]> {
  return page.evaluate(() => (globalThis as unknown as { violations: string[] }).violations);
}

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    const seen: string[] = [];
    Object.assign(globalThis, { violations: seen });
    document.addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI, sample }) => seen.push(`${violatedDirective} ${blockedURI} ${sample}`));
  });
});

test("the page and all its parts run within the policy", async ({ page }) => {
  await open(page);
  for (const name of ["Charts", "Fit", "Audit", "Comparison", "Files"]) {
    await page.getByRole("tab", { name, exact: true }).click();
    await expect(page.getByRole("tabpanel")).not.toBeEmpty();
  }
  // A zip is made in a worker of its own, the studio and the lessons have theirs.
  await page.getByRole("button", { name: "Share", exact: true }).click();
  await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save bracket" }).click()]);
  await page.keyboard.press("Escape");
  expect(await violations(page)).toEqual([]);
  for (const [address, canvas] of [["?page=studio", ".live-view canvas"], ["?page=lesson-hough", "canvas, svg"], ["?page=statistics", "table"]] as const) {
    await page.goto(`./${address}`);
    await expect(page.locator(canvas).first()).toBeVisible({ timeout: 60_000 });
    expect(await violations(page)).toEqual([]);
  }
});

// The browser tells of it in the console, which is what is wanted here.
plain("what the policy forbids cannot be done", async ({ page }) => {
  await open(page);
  for (const [what, attempt] of Object.entries(FORBIDDEN)) {
    await expect(page.evaluate(attempt), what).rejects.toThrow(/TypeError|EvalError|Trusted|Content Security Policy/);
  }
});
