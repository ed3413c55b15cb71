import preact from "@preact/preset-vite";
import { defineConfig, type Plugin } from "vite";

/** The development server puts style sheets into the page and talks to it over a socket. */
const developmentPolicy: Plugin = {
  name: "development-policy",
  apply: "serve",
  transformIndexHtml: (html, { server }) =>
    server
      ? html.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'").replace("connect-src 'self'", "connect-src 'self' ws:")
      : html,
};

export default defineConfig({
  root: "www",
  // Relative addresses, so that the built page works under any path of any host.
  base: "./",
  plugins: [preact(), developmentPolicy],
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
  },
  worker: {
    format: "es",
  },
});
