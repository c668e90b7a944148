// Bundles the page into src/ropewalk/live/page/: `node build.mjs [FOLDER]`.

import { copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "../src/ropewalk/live/page");
const PARTS = ["three", "uplot", "lil-gui"];

// lil-gui's sheet has an icon font inside as data; our content-security policy allows no fonts, and
// every system has these few signs.
const plainSheet = {
  name: "plain-sheet",
  setup(bundler) {
    bundler.onResolve({ filter: /^lil-gui-plain\.css$/ }, () => ({
      path: "lil-gui.css",
      namespace: "plain",
    }));
    bundler.onLoad({ filter: /.*/, namespace: "plain" }, () => ({
      contents: readFileSync(join(here, "node_modules/lil-gui/dist/lil-gui.css"), "utf8")
        .replace(/@font-face\s*\{[^}]*\}/g, "")
        .replace(/font-family: "lil-gui";/g, ""),
      loader: "css",
    }));
  },
};

const common = {
  absWorkingDir: here,
  bundle: true,
  minify: true,
  legalComments: "none", // the licences lie in LICENSES.txt
  target: "es2022",
  charset: "utf8",
};
mkdirSync(out, { recursive: true });
await build({
  ...common,
  entryPoints: ["src/main.js"],
  outfile: join(out, "bundle.js"),
  format: "iife",
});
await build({
  ...common,
  entryPoints: ["src/lab/main.js"],
  outfile: join(out, "lab.js"),
  format: "iife",
});
await build({
  ...common,
  entryPoints: ["src/lab/sheet.css"],
  outfile: join(out, "lab.css"),
});
await build({
  ...common,
  entryPoints: ["src/style/style.css"],
  outfile: join(out, "style.css"),
  plugins: [plainSheet],
  external: [],
});
copyFileSync(join(here, "src/index.html"), join(out, "index.html"));
copyFileSync(join(here, "src/lab/lab.html"), join(out, "lab.html"));

const licences = PARTS.map((name) => {
  const folder = join(here, "node_modules", name);
  const licence = readdirSync(folder).find((file) => file.startsWith("LICENSE"));
  const { version } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  return `${name} ${version}\n\n${readFileSync(join(folder, licence), "utf8").trim()}\n`;
});
writeFileSync(
  join(out, "LICENSES.txt"),
  `bundle.js and style.css contain:\n\n${licences.join("\n\n")}`,
);
