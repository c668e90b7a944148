// Fails when the committed page is not what the sources make: `node check.mjs`.

import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { spawnSync } from "node:child_process";

const here = dirname(fileURLToPath(import.meta.url));
const committed = join(here, "../src/ropewalk/live/page");
const fresh = mkdtempSync(join(tmpdir(), "ropewalk-page-"));
let wrong = [];
try {
  const { status } = spawnSync(process.execPath, [join(here, "build.mjs"), fresh], {
    stdio: "inherit",
  });
  if (status !== 0) process.exit(1);
  const names = new Set([...readdirSync(committed), ...readdirSync(fresh)]);
  wrong = [...names].filter((name) => read(committed, name) !== read(fresh, name));
} finally {
  rmSync(fresh, { recursive: true });
}
if (wrong.length) {
  console.error(
    `src/ropewalk/live/page is not what page/ makes: ${wrong.join(", ")}. Run make page and commit.`,
  );
  process.exit(1);
}
console.log("src/ropewalk/live/page is what page/ makes");

/** @param {string} folder @param {string} name */
function read(folder, name) {
  try {
    return readFileSync(join(folder, name), "utf8");
  } catch {
    return null;
  }
}
