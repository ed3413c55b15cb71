import preact from "@preact/preset-vite";
import { defineConfig } from "vite";

export default defineConfig({
  root: "www",
  // Relative addresses, so that the built page works under any path of any host.
  base: "./",
  plugins: [preact()],
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
  },
  worker: {
    format: "es",
  },
});
