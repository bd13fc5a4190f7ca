// Checks the grooves of examples/groove from memory with the core that emscripten made.
// usage: node smoke.mjs <build/core/bin/obrys_core.js> <examples/groove>
import { createRequire } from "node:module";
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";

const [core, folder] = process.argv.slice(2).map((p) => resolve(p));
const obrys = await createRequire(import.meta.url)(core)();
const call = (name, result, ...words) =>
  obrys.ccall(name, result, words.map((w) => (typeof w === "string" ? "string" : "number")), words);

const workspace = call("obrys_new", "number");
for (const name of readdirSync(folder)) {
  const bytes = readFileSync(join(folder, name));
  const at = call("malloc", "number", bytes.length + 1);
  obrys.HEAPU8.set(bytes, at);
  call("obrys_put", null, workspace, name, at, bytes.length);
  call("free", null, at);
}

const expect = (holds, what) => {
  console.log(`${holds ? "ok" : "FAILED"}: ${what}`);
  if (!holds) process.exitCode = 1;
};
const check = (job) => {
  const begin = process.cpuUsage();
  const report = JSON.parse(call("obrys_check", "string", workspace, job));
  const spent = process.cpuUsage(begin);
  console.log(`${job}: ${report.verdict}, ${report.summary?.moves ?? report.stats?.moves} moves, ${Math.round((spent.user + spent.system) / 1000)} ms`);
  return report;
};
const good = check("groove.job.toml"), wrong = check("groove_wrong.job.toml");
expect(good.verdict === "clean" && good.findings.length === 0, "the groove is clean");
expect(wrong.verdict === "findings", "the wrong one is not");
const gouge = wrong.findings.find((f) => f.code === "gouge");
expect(gouge?.where.file === "GROOVE_LAYER.SPF" && gouge.where.line === 9, "its gouge is found at its line");
expect(call("obrys_check", "string", workspace, "NONE.MPF").startsWith("there is no file NONE.MPF"), "what is not there is said");
expect(call("obrys_status", "number", workspace) === 1, "and told from a report");
call("obrys_delete", null, workspace);
