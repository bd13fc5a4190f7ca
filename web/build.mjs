// Makes the page's one script, dist/milling.js: src/ and what it uses of three, minified, no module loader, ASCII only.
import { build } from "esbuild";

await build({
  entryPoints: ["src/main.ts"],
  outfile: "dist/milling.js",
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome110", "firefox110", "safari16"],
  charset: "ascii",
  legalComments: "inline",
  logLevel: "warning",
});
