import AxeBuilder from "@axe-core/playwright";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { ROOT } from "./support/engine";
import { expect, open, picture, rows, test } from "./support/test";

async function expectNoFindings(page: Page, where: string): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  const told = violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join("\n")}`);
  expect(told, where).toEqual([]);
}

for (const scheme of ["light", "dark"] as const) {
  test(`axe finds nothing in the panels and sheets, ${scheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme });
    await open(page);
    for (const tab of await page.getByRole("tab").all()) {
      await tab.click();
      await expect(page.locator(".panel")).not.toContainText("Loading");
      const name = (await tab.textContent()) ?? "";
      await expectNoFindings(page, `panel ${name}`);
      await picture(page, `panel-${name}-${scheme}`);
    }
    for (const sheet of ["Add data", "What the protocols are", "Keyboard and help", "About"]) {
      await page.getByRole("button", { name: sheet }).click();
      await expect(page.getByRole("dialog")).toBeVisible();
      await expectNoFindings(page, sheet);
      await picture(page, `sheet-${sheet.replaceAll(" ", "-")}-${scheme}`);
      await page.keyboard.press("Escape");
    }
  });
}

test("every panel fits a phone and a wall", async ({ page }) => {
  await open(page);
  for (const [width, height, colorScheme] of [[360, 740, "dark"], [1920, 1080, "light"]] as const) {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width, height });
    for (const tab of await page.getByRole("tab").all()) {
      await tab.click();
      await expect(page.locator(".panel")).not.toContainText("Loading");
      const name = (await tab.textContent()) ?? "";
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(overflow, name).toBeLessThanOrEqual(0);
      if (width === 360) await page.locator(".panel").evaluate((panel) => panel.scrollIntoView());
      await picture(page, `panel-${name}-${width}`);
    }
  }
});

test("the page says what it is, how to cite it and where its source is read", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await open(page);
  await page.setViewportSize({ width: 360, height: 740 });
  await page.getByRole("button", { name: "Keyboard and help" }).press("Enter");
  await page.getByRole("button", { name: /^About the playground/ }).press("Enter");
  const about = page.getByRole("dialog", { name: "About" });
  await expect(about).toBeVisible();
  const engine = readFileSync(join(ROOT, "Cargo.toml"), "utf8").match(/^version = "(.+)"$/m)?.[1];
  await expect(about.getByRole("status")).toHaveText(`Version ${engine}`);
  await expect(about).toContainText("nothing is uploaded");
  await expect(about).toContainText("Licensed under MIT or Apache-2.0");
  await expect(about.getByRole("link", { name: "doi:10.1016/j.cag.2021.09.013" })).toHaveAttribute("href", "https://doi.org/10.1016/j.cag.2021.09.013");
  const documentation = await about.getByRole("link", { name: "documented beside this page" }).getAttribute("href");
  expect((await page.request.get(documentation ?? "")).ok()).toBe(true);
  await expectNoFindings(page, "about, on a phone");
  await about.getByRole("button", { name: "Copy BibTeX of the paper" }).press("Enter");
  await expect(page.locator(".notice")).toContainText("BibTeX of the paper copied");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain("@article{romanengo2022fit4cad,\n");
});

test("on a phone the header is two rows, and all of it is reached by keyboard in the order in which it stands", async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await open(page);
  const header = page.getByRole("banner");
  const height = (await header.boundingBox())?.height ?? Infinity;
  expect(height).toBeLessThan(80);
  const boxes = await header.locator("a, button").filter({ visible: true }).evaluateAll((all) => all.map((each) => each.getBoundingClientRect()));
  const rowOf = (box: DOMRect) => Math.floor((box.y + box.height / 2) / (height / 2));
  expect(boxes.map(rowOf)).toEqual([0, 0, 0, 0, 0, 1, 1, 1, 1, 1]);
  await page.getByRole("link", { name: "Skip to content" }).focus();
  const links = ["Score", "Results", "Lessons", "Studio", "Statistics"].map((name) => header.getByRole("link", { name }));
  const tools = ["Add data", "Share", "What the protocols are", /^Theme/, "Keyboard and help"].map((name) => header.getByRole("button", { name }));
  const protocol = header.getByRole("radio", { name: "Definition" });
  for (const each of [...links, ...tools.slice(0, 2), protocol, ...tools.slice(2)]) {
    await page.keyboard.press("Tab");
    await expect(each).toBeFocused();
    await expect(each).toBeInViewport({ ratio: 1 });
  }
  await expectNoFindings(page, "phone");
  await tools[0]?.press("Enter");
  await expect(page.getByRole("dialog", { name: "Add data" })).toBeVisible();
});

test("everything can be reached and used by keyboard", async ({ page }) => {
  await open(page);
  await page.keyboard.press("Tab");
  await expect(page.getByRole("link", { name: "Skip to content" })).toBeFocused();
  await page.keyboard.press("o");
  const sheet = page.getByRole("dialog", { name: "Add data" });
  await expect(sheet).toBeVisible();
  await sheet.getByRole("button", { name: /^Flange/ }).focus();
  await page.keyboard.press("Enter");
  await expect(rows(page)).toHaveCount(2);
  await page.keyboard.press("]");
  await page.keyboard.press("[");
  await expect(page.locator(".stage h2")).toHaveText("bracket");
  await page.keyboard.press("p");
  await expect(page.getByRole("radio", { name: "Published" })).toBeChecked();
  await page.keyboard.press("2");
  await expect(page.getByRole("tab", { name: "Primitives" })).toHaveAttribute("aria-selected", "true");
  await page.keyboard.press("/");
  await expect(page.getByLabel("Search the models")).toBeFocused();
  await page.keyboard.press("Escape");
  await page.locator(".canvas-box canvas").focus();
  await page.keyboard.press("?");
  await expect(page.getByRole("dialog", { name: "Keyboard" })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.locator(".canvas-box canvas")).toBeFocused();
});

test("focus is never without a visible mark", async ({ page }) => {
  await open(page);
  for (let step = 0; step < 40; step++) {
    await page.keyboard.press("Tab");
    const unmarked = await page.evaluate(() => {
      const element = document.activeElement;
      if (!element || element === document.body) return undefined;
      // A hidden input shows its mark on the label beside or around it.
      const marked = [element, element.nextElementSibling, element.closest("label")];
      return marked.some((part) => part && getComputedStyle(part).outlineStyle !== "none") ? undefined : element.outerHTML;
    });
    expect(unmarked).toBeUndefined();
  }
});

test("the views are given more or less room by keyboard and by dragging", async ({ page }) => {
  await open(page);
  const height = async () => (await page.locator(".canvas-box").boundingBox())?.height ?? 0;
  const before = await height();
  const border = page.getByRole("separator", { name: "Height of the views" });
  await border.focus();
  await page.keyboard.press("ArrowDown");
  await expect.poll(height).toBeGreaterThan(before);
  const box = await border.boundingBox();
  if (!box) throw new Error("no border");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y - 120, { steps: 4 });
  await page.mouse.up();
  await expect.poll(height).toBeLessThan(before);
});
