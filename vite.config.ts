import { readFileSync } from "node:fs";
import preact from "@preact/preset-vite";
import { defineConfig, type Plugin } from "vite";
import { VitePWA } from "vite-plugin-pwa";
import { parse } from "yaml";
import { resultsPlugin } from "./scripts/lib/results-plugin.mjs";

/** The development server puts style sheets and its own markup into the page and talks to it over a socket. */
const developmentPolicy: Plugin = {
  name: "development-policy",
  apply: "serve",
  transformIndexHtml: (html, { server }) =>
    server
      ? html
          .replace("style-src 'self'", "style-src 'self' 'unsafe-inline'")
          .replace("connect-src 'self'", "connect-src 'self' ws:")
          .replace("; require-trusted-types-for 'script'; trusted-types fit4cad", "")
      : html,
};

/** Where the source is kept: a workflow that builds the page knows, and a fork's page names the fork. */
const { GITHUB_SERVER_URL, GITHUB_REPOSITORY } = process.env;
const repository = GITHUB_SERVER_URL && GITHUB_REPOSITORY ? { "repository-code": `${GITHUB_SERVER_URL}/${GITHUB_REPOSITORY}` } : {};

/** What the page says of how to cite it is what CITATION.cff says. */
const citation: Plugin = {
  name: "citation",
  load: (id) => {
    if (!id.endsWith(".cff")) return null;
    const works: object = parse(readFileSync(id, "utf8"));
    return { code: `export default ${JSON.stringify({ ...works, ...repository })}`, moduleType: "js" };
  },
};

/** Everything the page is made of is kept at the first visit; what is dropped or downloaded is not. */
const offline = VitePWA({
  registerType: "prompt",
  // A module registers it: the content security policy allows no inline script.
  injectRegister: false,
  includeAssets: ["icon.svg"],
  manifest: {
    name: "Fit4CAD Playground",
    short_name: "Fit4CAD",
    description: "Score, fit and look at simple primitives in point clouds of CAD objects.",
    display: "standalone",
    start_url: "./",
    scope: "./",
    background_color: "#ffffff",
    theme_color: "#14324a",
    icons: [{ src: "icon.svg", sizes: "any", type: "image/svg+xml", purpose: "any" }],
  },
  workbox: {
    globPatterns: ["**/*.{html,js,css,wasm,svg,json}"],
    // Every model of every method of the standing table: fetched with the method's page.
    globIgnores: ["results/*"],
    maximumFileSizeToCacheInBytes: 8 * 1024 * 1024,
    ignoreURLParametersMatching: [/./],
    cleanupOutdatedCaches: true,
  },
});

export default defineConfig({
  root: "www",
  // Relative addresses, so that the built page works under any path of any host.
  base: "./",
  plugins: [preact(), citation, resultsPlugin(), developmentPolicy, offline],
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    rolldownOptions: {
      output: {
        chunkFileNames: ({ facadeModuleId }) => (facadeModuleId?.endsWith("/scores.json") ? "results/[name]-[hash].js" : "assets/[name]-[hash].js"),
      },
    },
  },
  worker: {
    format: "es",
  },
});
