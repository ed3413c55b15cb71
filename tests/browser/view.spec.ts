// The view alone, on a page of its own: what is drawn, what is found, and what hands can do.

import { fileURLToPath } from "node:url";
import { expect, test as base, type Page } from "@playwright/test";
import { createServer } from "vite";
import { SEGMENT_COLOURS } from "../../www/app/view/palette";
import type { CameraState, Hit } from "../../www/app/view/types";
import type { Harness } from "./view/harness";

declare global {
  interface Window {
    harness: Harness;
  }
}

const FOLDER = fileURLToPath(new URL("view", import.meta.url));
const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const [, YELLOW = "", RED = "", , SALMON = "", PURPLE = ""] = SEGMENT_COLOURS;

const test = base.extend<{ stage: Page }, { address: string }>({
  address: [
    // Playwright reads the names of what is asked for, here none, out of the pattern.
    // oxlint-disable-next-line no-empty-pattern
    async ({}, use) => {
      const server = await createServer({
        configFile: false,
        root: FOLDER,
        cacheDir: "node_modules/.vite-view",
        logLevel: "warn",
        optimizeDeps: { noDiscovery: true },
        server: { host: "127.0.0.1", port: 0, fs: { allow: [ROOT] }, hmr: false, watch: null },
      });
      await server.listen();
      await use(server.resolvedUrls?.local[0] ?? "");
      await server.close();
    },
    { scope: "worker" },
  ],
  // A block seen from the corner: front red, right yellow, top purple.
  stage: async ({ page, address }, use) => {
    const failures: string[] = [];
    page.on("pageerror", ({ message }) => failures.push(message));
    await page.setViewportSize({ width: 820, height: 520 });
    await page.goto(address);
    await page.waitForFunction(() => "harness" in window);
    await page.evaluate(async () => {
      const { view, block, segmentTable, rest } = window.harness;
      const { positions, normals, labels } = block(60);
      view.setCloud(positions);
      view.setNormals(normals);
      for (const side of [0, 1] as const) {
        view.setLabels(side, labels);
        view.setColours(side, segmentTable(6));
      }
      view.setTheme({ background: "#ffffff", ink: "#000000" });
      await rest();
    });
    await use(page);
    expect(failures).toEqual([]);
  },
});

/** Pixels of a colour on the canvas between two shares of its width. */
async function count(page: Page, colour: string, from = 0, to = 1): Promise<number> {
  await page.evaluate(() => window.harness.rest());
  const file = (await page.locator("#view").screenshot()).toString("base64");
  return page.evaluate(
    async ([file, colour, from, to]) => {
      const { decode, count } = window.harness;
      const picture = await (await fetch(`data:image/png;base64,${file}`)).blob();
      return count(await decode(picture), colour, from, to);
    },
    [file, colour, from, to] as const,
  );
}

const camera = (page: Page): Promise<CameraState> => page.evaluate(() => window.harness.view.camera);

test("both sides are drawn beside each other with one camera", async ({ stage }) => {
  for (const colour of [YELLOW, RED, PURPLE]) {
    const left = await count(stage, colour, 0, 0.5);
    const right = await count(stage, colour, 0.5, 1);
    expect(left).toBeGreaterThan(3000);
    expect(Math.abs(left - right)).toBeLessThan(0.05 * left);
  }
  // What faces away is not seen.
  expect(await count(stage, SALMON)).toBeLessThan(0.1 * (await count(stage, RED)));
});

test("each side has colours of its own", async ({ stage }) => {
  await stage.evaluate(() => {
    const { view, bytes } = window.harness;
    view.setColours(1, bytes(["#8b9097", ...new Array<string>(6).fill("#00aa00")]));
  });
  expect(await count(stage, "#00aa00", 0, 0.5)).toBe(0);
  expect(await count(stage, "#00aa00", 0.5, 1)).toBeGreaterThan(10_000);
});

test("a wipe shows the first side to the left of its border and the second to the right", async ({ stage }) => {
  await stage.evaluate(() => {
    const { view, bytes } = window.harness;
    view.setColours(0, bytes(new Array<string>(7).fill("#00aa00")));
    view.setColours(1, bytes(new Array<string>(7).fill("#aa00aa")));
    view.setLayout({ kind: "wipe", at: 0.4 });
  });
  expect(await count(stage, "#00aa00", 0, 0.4)).toBeGreaterThan(5000);
  expect(await count(stage, "#aa00aa", 0, 0.4)).toBe(0);
  expect(await count(stage, "#aa00aa", 0.4, 1)).toBeGreaterThan(5000);
  expect(await count(stage, "#00aa00", 0.4, 1)).toBe(0);
});

test("hidden labels are neither drawn nor found", async ({ stage }) => {
  const hitAt = () =>
    stage.evaluate(async (): Promise<[Hit | undefined, number | undefined]> => {
      const { view, block } = window.harness;
      const place = view.project(0, [0, 0, 0.5]);
      const hit = place && (await view.pick(place.x, place.y));
      return [hit, hit && block(60).labels[hit.index]];
    });
  expect((await hitAt())[1]).toBe(6);
  await stage.evaluate(() => window.harness.view.setStates(0, [2, 2, 2, 2, 2, 2, 0]));
  expect(await count(stage, PURPLE, 0, 0.5)).toBe(0);
  expect(await count(stage, PURPLE, 0.5, 1)).toBeGreaterThan(3000);
  expect(await count(stage, SALMON, 0, 0.5)).toBeGreaterThan(500);
  expect((await hitAt())[1]).not.toBe(6);
});

test("a locked label is drawn, and the cursor finds what lies behind it", async ({ stage }) => {
  const shown = await count(stage, PURPLE, 0, 0.5);
  const found = await stage.evaluate(async () => {
    const { view, block, LabelState } = window.harness;
    view.setStates(0, [2, 2, 2, 2, 2, 2, LabelState.Locked]);
    const place = view.project(0, [0, 0, 0.5]) ?? { x: 0, y: 0 };
    const hit = await view.pick(place.x, place.y);
    return hit && block(60).labels[hit.index];
  });
  expect(await count(stage, PURPLE, 0, 0.5)).toBe(shown);
  expect(found).toBeDefined();
  expect(found).not.toBe(6);
});

test("what lies outside the clipping box is neither drawn nor found", async ({ stage }) => {
  const [red, yellow] = [await count(stage, RED), await count(stage, YELLOW)];
  await stage.evaluate(() => window.harness.view.setClipBox({ low: [0, 0, 0], high: [1, 1, 0.5] }));
  expect(await count(stage, PURPLE)).toBe(0);
  expect(await count(stage, RED)).toBeGreaterThan(0.3 * red);
  expect(await count(stage, RED)).toBeLessThan(0.7 * red);
  await stage.evaluate(() => window.harness.view.setClipBox({ low: [0, 0, 0], high: [0.9, 1, 0.5] }));
  expect(await count(stage, YELLOW)).toBeLessThan(0.05 * yellow);
  const circle = await stage.evaluate(() => {
    const { view, block } = window.harness;
    const { positions } = block(60);
    const place = view.project(0, [0, 0, 0]) ?? { x: 0, y: 0 };
    const indices = view.pointsIn(0, { kind: "circle", ...place, radius: 400 }, false);
    return Math.max(...Array.from(indices, (index) => positions[3 * index + 2] ?? 0));
  });
  expect(circle).toBeLessThanOrEqual(0.001);
  await stage.evaluate(() => window.harness.view.setClipBox({ low: [0, 0, 0], high: [1, 1, 1] }));
  expect(await count(stage, RED)).toBe(red);
});

test("picking finds the very point, on the side it is asked on", async ({ stage }) => {
  const found = await stage.evaluate(async () => {
    const { view, block } = window.harness;
    const { positions, labels } = block(60);
    view.zoom(2);
    await window.harness.rest();
    const results: { side: number; wanted: number; hit: unknown }[] = [];
    for (const side of [0, 1] as const) {
      // Points of the top face near its middle.
      for (const step of [25, 29, 34]) {
        const wanted = labels.indexOf(6) + step * 60 + 60 - step;
        const [x = 0, y = 0, z = 0] = positions.subarray(3 * wanted, 3 * wanted + 3);
        const place = view.project(side, [x, y, z]);
        results.push({ side, wanted, hit: place && (await view.pick(place.x, place.y)) });
      }
    }
    return { results, nothing: await view.pick(2, 2) };
  });
  for (const { side, wanted, hit } of found.results) expect(hit).toEqual({ side, index: wanted });
  await stage.evaluate(() => window.harness.view.fit(false));
  expect(await stage.evaluate(() => window.harness.view.pick(2, 2))).toBeUndefined();
});

test("hovering tells the point once, and when it is left", async ({ stage }) => {
  await stage.evaluate(() => {
    const heard: (Hit | undefined)[] = [];
    window.harness.view.on("hover", (hit) => heard.push(hit));
    Object.assign(window, { heard });
  });
  const heard = () => stage.evaluate(() => (window as unknown as { heard: (Hit | undefined)[] }).heard);
  await stage.mouse.move(200, 230);
  await expect.poll(heard).toHaveLength(1);
  expect((await heard())[0]?.side).toBe(0);
  await stage.mouse.move(3, 3);
  await expect.poll(heard).toHaveLength(2);
  expect((await heard())[1] ?? undefined).toBeUndefined();
});

test("a click and a double click tell the point, a drag does not", async ({ stage }) => {
  await stage.evaluate(() => {
    const heard: string[] = [];
    window.harness.view.on("click", (hit) => heard.push(`click ${hit?.side}`));
    window.harness.view.on("doubleClick", (hit) => heard.push(`double ${hit?.side}`));
    Object.assign(window, { heard });
  });
  const heard = () => stage.evaluate(() => (window as unknown as { heard: string[] }).heard);
  await stage.mouse.click(600, 230);
  await expect.poll(heard).toEqual(["click 1"]);
  await stage.waitForTimeout(400);
  await stage.mouse.dblclick(200, 230);
  await expect.poll(heard).toEqual(["click 1", "click 0", "double 0"]);
  await stage.mouse.move(200, 230);
  await stage.mouse.down();
  await stage.mouse.move(230, 230, { steps: 3 });
  await stage.mouse.up();
  await stage.mouse.click(3, 3);
  await expect.poll(heard).toEqual(["click 1", "click 0", "double 0", "click undefined"]);
});

test("mouse, wheel and keys turn, move and enlarge", async ({ stage }) => {
  const before = await camera(stage);
  await stage.mouse.move(200, 250);
  await stage.mouse.down();
  await stage.mouse.move(260, 250, { steps: 4 });
  await stage.mouse.up();
  const turned = await camera(stage);
  expect(turned.rotation).not.toEqual(before.rotation);
  expect(turned.target).toEqual(before.target);

  await stage.mouse.move(200, 250);
  await stage.mouse.down({ button: "right" });
  await stage.mouse.move(230, 240, { steps: 4 });
  await stage.mouse.up({ button: "right" });
  const moved = await camera(stage);
  expect(moved.rotation).toEqual(turned.rotation);
  expect(moved.target).not.toEqual(turned.target);

  await stage.mouse.wheel(0, -300);
  await expect.poll(async () => (await camera(stage)).height).toBeLessThan(moved.height);

  await stage.locator("#view").focus();
  await stage.keyboard.press("1");
  await expect.poll(async () => (await camera(stage)).rotation[0]).toBeCloseTo(Math.SQRT1_2, 3);
  await stage.keyboard.press("ArrowRight");
  expect((await camera(stage)).rotation[0]).not.toBeCloseTo(Math.SQRT1_2, 3);
  await stage.keyboard.press("o");
  expect((await camera(stage)).projection).toBe("orthographic");
});

test("two fingers enlarge what is between them", async ({ stage }) => {
  const before = await camera(stage);
  await stage.evaluate(() => {
    const { canvas } = window.harness;
    canvas.setPointerCapture = () => undefined;
    const send = (type: string, pointerId: number, x: number) =>
      canvas.dispatchEvent(
        new PointerEvent(type, { pointerId, pointerType: "touch", clientX: x, clientY: 250, button: 0, bubbles: true }),
      );
    send("pointerdown", 1, 180);
    send("pointerdown", 2, 220);
    for (let step = 1; step <= 10; step++) {
      send("pointermove", 1, 180 - 4 * step);
      send("pointermove", 2, 220 + 4 * step);
    }
    send("pointerup", 1, 140);
    send("pointerup", 2, 260);
  });
  expect((await camera(stage)).height).toBeCloseTo(before.height / 3, 2);
});

test("a camera written down and set again shows the same", async ({ stage }) => {
  await stage.evaluate(() => window.harness.view.turn(0.7, 0.3));
  const [before, written] = [await count(stage, RED), await camera(stage)];
  await stage.evaluate(() => window.harness.view.lookFrom(window.harness.Standpoint.Top, false));
  expect(await count(stage, RED)).not.toBe(before);
  const accepted = await stage.evaluate((state) => window.harness.view.setCamera(state), written);
  expect(accepted).toBe(true);
  expect(await count(stage, RED)).toBe(before);
  const nonsense = { ...written, height: Number.NaN };
  expect(await stage.evaluate((state) => window.harness.view.setCamera(state), nonsense)).toBe(false);
});

test("nothing is drawn while nothing changes, and nothing sent anew while the cloud turns", async ({ stage }) => {
  const draws = await stage.evaluate(async () => {
    let draws = 0;
    let sent = 0;
    for (const name of ["bufferData", "bufferSubData", "texImage2D", "texSubImage2D"] as const) {
      const send = WebGL2RenderingContext.prototype[name] as (...details: unknown[]) => void;
      Object.assign(WebGL2RenderingContext.prototype, {
        [name](this: WebGL2RenderingContext, ...details: unknown[]) {
          for (const detail of details) if (ArrayBuffer.isView(detail)) sent += detail.byteLength;
          send.apply(this, details);
        },
      });
    }
    const draw = WebGL2RenderingContext.prototype.drawArrays;
    WebGL2RenderingContext.prototype.drawArrays = function (...details) {
      draws++;
      draw.apply(this, details);
    };
    await window.harness.rest();
    const idle = draws;
    for (let step = 0; step < 5; step++) {
      window.harness.view.turn(0.1, 0);
      await new Promise((drawn) => requestAnimationFrame(drawn));
    }
    await window.harness.rest();
    const turning = sent;
    window.harness.view.setPatches([]);
    window.harness.view.setLabels(0, window.harness.block(60).labels);
    await window.harness.rest();
    return { idle, changed: draws, turning, labels: sent };
  });
  expect(draws.idle).toBe(0);
  expect(draws.changed).toBeGreaterThan(0);
  // Whatever the number of points: a frame costs the processor the same.
  expect(draws.turning).toBeLessThan(5 * 1000);
  expect(draws.labels).toBeGreaterThan(10_000);
});

test("eye-dome lighting shades edges and leaves colours alone when off", async ({ stage }) => {
  const shades = async (strength: number) => {
    await stage.evaluate((strength) => window.harness.view.setEyeDome(strength), strength);
    return stage.evaluate(async () => {
      const { view, decode } = window.harness;
      const file = await view.picture({ width: 400, height: 250, transparent: false });
      const { data } = await decode(file);
      return new Set(Array.from({ length: data.length / 4 }, (_, at) => data.slice(4 * at, 4 * at + 3).join())).size;
    });
  };
  const [off, on] = [await shades(0), await shades(1)];
  expect(on).toBeGreaterThan(2 * off);
});

test("scalars take the colours of the map and NaN that of label 0", async ({ stage }) => {
  await stage.evaluate(() => {
    const { view, block, bytes } = window.harness;
    const { positions } = block(60);
    const heights = Float32Array.from({ length: positions.length / 3 }, (_, index) => positions[3 * index + 2] ?? 0);
    view.setColours(0, bytes(["#00aa00"]));
    view.setColourMap(0, ["#0000ff", "#ff0000"]);
    view.setScalars(0, heights.map((z) => (z > 0.49 ? Number.NaN : z)));
    view.colourByScalar(0, -10, -5);
  });
  expect(await count(stage, "#ff0000", 0, 0.5)).toBeGreaterThan(5000);
  expect(await count(stage, "#00aa00", 0, 0.5)).toBeGreaterThan(3000);
});

test("a brush takes what can be seen, a lasso through the block both sides", async ({ stage }) => {
  const taken = await stage.evaluate(() => {
    const { view, block } = window.harness;
    const { labels } = block(60);
    const place = view.project(0, [0, 0, 0.5]) ?? { x: 0, y: 0 };
    const faces = (indices: Uint32Array) => [...new Set(Array.from(indices, (index) => labels[index] ?? 0))].sort((a, b) => a - b);
    const circle = { kind: "circle", ...place, radius: 12 } as const;
    const [w, h] = [12, 12];
    const corners = [[-w, -h], [w, -h], [w, h], [-w, h]].map(([x = 0, y = 0]) => [place.x + x, place.y + y] as const);
    return {
      seen: faces(view.pointsIn(0, circle)),
      through: faces(view.pointsIn(0, { kind: "polygon", corners }, false)),
      ascending: Array.from(view.pointsIn(0, circle)).every((index, at, all) => at === 0 || index > (all[at - 1] ?? 0)),
    };
  });
  expect(taken.seen).toEqual([6]);
  expect(taken.through.length).toBeGreaterThan(1);
  expect(taken.through).toContain(6);
  expect(taken.ascending).toBe(true);
});

test("a patch is drawn over the points, with its axis in ink", async ({ stage }) => {
  const before = await count(stage, "#00ff00");
  await stage.evaluate(() => {
    const { view, PatchMark } = window.harness;
    view.setPatches([
      {
        side: 0,
        colour: [0, 255, 0],
        positions: Float32Array.of(-1, -0.7, 0.9, 1, -0.7, 0.9, 1, 0.7, 0.9, -1, 0.7, 0.9),
        normals: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1),
        triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
        lines: Float32Array.of(-1, -0.7, 0.9, 1, -0.7, 0.9, 0, 0, -1, 0, 0, 2),
        marks: Uint8Array.of(PatchMark.Rim, PatchMark.Axis),
      },
    ]);
  });
  expect(before).toBe(0);
  expect(await count(stage, "#00ff00", 0, 0.5)).toBeGreaterThan(100);
  expect(await count(stage, "#00ff00", 0.5, 1)).toBe(0);
  await stage.evaluate(() => window.harness.view.setPatches([]));
  expect(await count(stage, "#00ff00")).toBe(0);
});

test("a saved picture has the size asked for, no seams, and a clear background where wanted", async ({ stage }) => {
  const saved = await stage.evaluate(async (colour) => {
    const { view, decode, count } = window.harness;
    const small = await decode(await view.picture({ width: 600, height: 375, transparent: true }));
    // Wider and higher than one tile.
    const large = await decode(await view.picture({ width: 4200, height: 2625, transparent: false }));
    const alpha = new Set(Array.from({ length: small.data.length / 4 }, (_, at) => small.data[4 * at + 3] ?? -1));
    return {
      size: [large.width, large.height],
      corner: [...small.data.slice(0, 4)],
      clear: alpha.has(0) && alpha.has(255),
      shares: [small, large].map((picture) => count(picture, colour) / (picture.width * picture.height)),
      background: [...large.data.slice(0, 4)],
    };
  }, PURPLE);
  expect(saved.size).toEqual([4200, 2625]);
  expect(saved.corner[3]).toBe(0);
  expect(saved.clear).toBe(true);
  expect(saved.background).toEqual([255, 255, 255, 255]);
  const [small = 0, large = 0] = saved.shares;
  expect(large).toBeGreaterThan(0.9 * small);
  expect(large).toBeLessThan(1.1 * small);
});

test("a lost context comes back with everything in it", async ({ stage }) => {
  const before = await count(stage, RED, 0.5, 1);
  await stage.evaluate(async () => {
    const { view, canvas, rest } = window.harness;
    const told: boolean[] = [];
    view.on("context", (usable) => told.push(usable));
    Object.assign(window, { told });
    const loss = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
    loss?.loseContext();
    await rest();
    // Work goes on meanwhile and must not be lost.
    view.setStates(0, [2, 2, 0]);
    if ((await view.pick(200, 250)) !== undefined) throw new Error("picked without a context");
    loss?.restoreContext();
    await rest();
  });
  expect(await stage.evaluate(() => (window as unknown as { told: boolean[] }).told)).toEqual([false, true]);
  expect(await count(stage, RED, 0.5, 1)).toBe(before);
  expect(await count(stage, YELLOW, 0, 0.5)).toBe(0);
  expect(await count(stage, YELLOW, 0.5, 1)).toBeGreaterThan(3000);
});

test("without WebGL 2 the reason is told as a value", async ({ stage }) => {
  const reason = await stage.evaluate(async () => {
    const { PointView, ViewUnavailable } = window.harness;
    const canvas = document.createElement("canvas");
    canvas.getContext = () => null;
    try {
      await PointView.create(canvas);
      return "created";
    } catch (error) {
      return error instanceof ViewUnavailable ? error.reason : String(error);
    }
  });
  expect(reason).toBe("no-webgl2");
});

test("of a million points a part is seen first, then all, and whoever asks is told of all", async ({ stage }) => {
  const { total, drawn, found } = await stage.evaluate(async () => {
    const drawn: number[] = [];
    const draw = WebGL2RenderingContext.prototype.drawArrays;
    WebGL2RenderingContext.prototype.drawArrays = function (mode, first, count) {
      if (mode === this.POINTS) drawn.push(count);
      draw.call(this, mode, first, count);
    };
    const { view, block } = window.harness;
    const { positions, labels } = block(410);
    const total = labels.length;
    const give = () => {
      view.setCloud(positions);
      for (const side of [0, 1] as const) view.setLabels(side, labels);
    };
    give();
    while (drawn.at(-1) !== total) await new Promise((next) => requestAnimationFrame(next));
    give();
    const found = view.pointsIn(0, { kind: "circle", x: 205, y: 260, radius: 1000 }, false).length;
    return { total, drawn: drawn.slice(0, -1), found };
  });
  expect(drawn[0]).toBeGreaterThan(0);
  expect(drawn[0]).toBeLessThan(total / 2);
  expect(found).toBe(total);
  expect(await count(stage, RED, 0, 0.5)).toBeGreaterThan(3000);
});

test("framing a label brings it to the middle and close", async ({ stage }) => {
  const before = await camera(stage);
  await stage.evaluate(() => window.harness.view.fitLabels(0, [2]));
  await expect.poll(async () => (await camera(stage)).target[0]).toBeCloseTo(1, 3);
  expect((await camera(stage)).height).toBeLessThan(before.height);
  await stage.evaluate(() => window.harness.view.fitBox({ low: [-1, -0.7, -0.5], high: [-1, 0.7, 0.5] }, false));
  expect((await camera(stage)).target[0]).toBeCloseTo(-1, 3);
});

test("a new size of the canvas keeps the picture sharp and whole", async ({ stage }) => {
  await stage.evaluate(async () => {
    const { canvas, view, rest } = window.harness;
    canvas.style.width = "300px";
    canvas.style.height = "480px";
    await rest();
    view.fit(false);
  });
  const size = await stage.evaluate(() => [window.harness.canvas.width, window.harness.canvas.height]);
  expect(size).toEqual([300, 480]);
  // Taller than wide: one above the other, and nothing cut off at the sides.
  expect(await count(stage, RED)).toBeGreaterThan(2000);
  expect(await count(stage, RED, 0, 0.02)).toBe(0);
  expect(await count(stage, YELLOW, 0.98, 1)).toBe(0);
});
