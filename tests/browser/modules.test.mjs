// The modules of the pages: each name that one uses is its own, imported, or the browser's; each
// import is used and exported where it says; each export is imported. And what joins them into one
// script refuses what it cannot join. CMAKE: the program.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { test } from "node:test";

const require = createRequire(path.join(process.env.BROWSER_PACKAGES, "package.json"));
const { parse } = require("acorn");
const { analyze } = require("eslint-scope");

const root = fileURLToPath(new URL("../../", import.meta.url));
const folder = path.join(root, "app/report/page");

// What the browser and the plotting libraries give.
const GLOBALS = new Set(`AbortController Array Blob Boolean DOMParser DecompressionStream Error Event FileReader Image MediaRecorder Promise XMLSerializer createImageBitmap performance Float32Array Float64Array Infinity Int32Array Intl JSON Map Math
  MutationObserver NaN Number Object RegExp ResizeObserver Response SVGElement Set String TextDecoder TextEncoder URL URLSearchParams Uint8Array WebAssembly Worker
  addEventListener atob clearTimeout d3 decodeURIComponent devicePixelRatio document getComputedStyle getSelection history localStorage
  encodeURIComponent fetch location matchMedia navigator open parseFloat print requestAnimationFrame self sessionStorage setInterval setTimeout uPlot undefined`.split(/\s+/));

// What a script imports, as {name, from}, exports, uses without declaring it, and leaves unused.
function moduleOf(file) {
  const ast = parse(readFileSync(file, "utf8"), { ecmaVersion: 2024, sourceType: "module", ranges: true });
  const { globalScope } = analyze(ast, { ecmaVersion: 2024, sourceType: "module" });
  const top = globalScope.childScopes[0];
  const imports = ast.body.filter(({ type }) => type === "ImportDeclaration").flatMap(({ source, specifiers }) =>
    specifiers.map(({ local }) => ({ name: local.name, from: path.resolve(path.dirname(file), source.value) })));
  const exports = ast.body.filter(({ type }) => type === "ExportNamedDeclaration").flatMap(({ declaration }) =>
    declaration.id?.name ?? declaration.declarations.map(({ id }) => id.name));
  const unused = top.variables.filter(({ references, name }) => !exports.includes(name) && references.every((one) => one.init)).map(({ name }) => name);
  return { imports, exports, unused, free: [...new Set(globalScope.through.map(({ identifier }) => identifier.name))] };
}

const scripts = (from, ending) => readdirSync(from, { recursive: true }).filter((name) => name.endsWith(ending) && !name.includes("node_modules")).map((name) => path.join(from, name));
const modules = new Map(scripts(folder, ".js").map((file) => [file, moduleOf(file)]));

test("names are a module's own, imported or the browser's", () => {
  assert.ok(modules.size > 50);
  for (const [file, { free }] of modules) assert.deepEqual(free.filter((name) => !GLOBALS.has(name)), [], file);
});

test("what is imported is exported there, and what is imported, declared or exported is used", () => {
  const tests = scripts(path.join(root, "tests"), ".mjs").map((file) => moduleOf(file));
  const imported = new Set([...modules.values(), ...tests].flatMap(({ imports }) => imports.map(({ name, from }) => `${from} ${name}`)));
  for (const [file, { imports, exports, unused }] of modules) {
    for (const { name, from } of imports) assert.ok(modules.get(from)?.exports.includes(name), `${file}: ${name} of ${from}`);
    assert.deepEqual(unused, [], file);
    assert.deepEqual(exports.filter((name) => !imported.has(`${file} ${name}`)), [], file);
  }
});

// What modules.cmake makes of `files` from main.js on: its script, or its message.
function joined(files) {
  const scratch = mkdtempSync(path.join(tmpdir(), "cognate-modules-"));
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(path.dirname(path.join(scratch, name)), { recursive: true });
    writeFileSync(path.join(scratch, name), text);
  }
  writeFileSync(path.join(scratch, "join.cmake"), `cmake_minimum_required(VERSION 3.25)
include("${root}/app/report/modules.cmake")
join_modules(main.js script modules)
file(WRITE joined.js "\${script}")\n`);
  const { status, stderr } = spawnSync(process.env.CMAKE ?? "cmake", ["-P", "join.cmake"], { cwd: scratch, encoding: "utf8" });
  const script = status === 0 ? readFileSync(path.join(scratch, "joined.js"), "utf8") : null;
  rmSync(scratch, { recursive: true });
  return { script, message: stderr.replace(/\s+/g, " ") };
}

test("modules are joined after those that they import, each once", () => {
  const { script } = joined({
    "main.js": 'import { a,\n  b } from "./part/b.js";\nimport { c } from "./c.js";\nresult = [a, b(), c];\n',
    "part/b.js": '// Both.\nimport { c } from "../c.js";\n\nexport const a = `;[${c}`;\nexport function b() { return 2; }\n',
    "c.js": 'export const c = "import { x } from nowhere";\n',
  });
  const result = new Function(`let result; ${script} return result;`)();
  assert.deepEqual(result, [";[import { x } from nowhere", 2, "import { x } from nowhere"]);
});

for (const [what, files, message] of [
  ["modules that import one another", { "main.js": 'import { a } from "./a.js";\n', "a.js": 'import { b } from "./b.js";\nexport const a = 1;\n',
    "b.js": 'import { a } from "./a.js";\nexport const b = 2;\n' }, /import one another/],
  ["a name that is not exported", { "main.js": 'import { a } from "./a.js";\n', "a.js": "const a = 1;\n" }, /imports a, which .*a\.js does not export/],
  ["a name of two modules", { "main.js": 'import { a } from "./a.js";\nconst { b } = a;\n', "a.js": "export const a = 1;\nfunction b() {}\n" }, /another module of the page has a b as well/],
  ["a module that is not there", { "main.js": 'import { a } from "./a.js";\n' }, /a\.js/],
]) test(`${what} cannot be joined`, () => {
  const { script, message: said } = joined(files);
  assert.equal(script, null);
  assert.match(said, message);
});
