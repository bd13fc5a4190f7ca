// Makes the page's one script, dist/milling.js: src/ and what it uses of three, minified, no module loader, ASCII only.
import { readFileSync } from "node:fs";
import { build } from "esbuild";

// The licence asks that its text goes with every copy.
const licence = `/* Holds parts of three.js.\n${readFileSync("node_modules/three/LICENSE", "utf8").trim()} */`;

await build({
  entryPoints: ["src/main.ts"],
  outfile: "dist/milling.js",
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome110", "firefox110", "safari16"],
  charset: "ascii",
  legalComments: "none",
  banner: { js: licence },
  logLevel: "warning",
});
