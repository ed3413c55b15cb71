import preact from "@preact/preset-vite";
import { defineConfig, type Plugin } from "vite";
import { VitePWA } from "vite-plugin-pwa";

/** The development server puts style sheets into the page and talks to it over a socket. */
const developmentPolicy: Plugin = {
  name: "development-policy",
  apply: "serve",
  transformIndexHtml: (html, { server }) =>
    server
      ? html.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'").replace("connect-src 'self'", "connect-src 'self' ws:")
      : html,
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
    maximumFileSizeToCacheInBytes: 8 * 1024 * 1024,
    ignoreURLParametersMatching: [/./],
    cleanupOutdatedCaches: true,
  },
});

export default defineConfig({
  root: "www",
  // Relative addresses, so that the built page works under any path of any host.
  base: "./",
  plugins: [preact(), developmentPolicy, offline],
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
  },
  worker: {
    format: "es",
  },
});
