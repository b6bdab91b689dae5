// Builds the two scripts that are committed, from package-lock.json's packages. The same sources give the
// same bytes.
//
//   node build.mjs          writes them
//   node build.mjs --check  compares them with what is committed
//
// book/widgets/dist: the runtime, which shows widgets in a page without a kernel, and the licences of what is
// in it. src/rlswaim/explorers/built: all live views, in one script and one style sheet.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

process.chdir(import.meta.dirname);
const RUNTIME = 'book/widgets';
const VIEWS = 'src/rlswaim/explorers';
/** @satisfies {import('esbuild').BuildOptions} */
const common = {
  bundle: true,
  minify: true,
  write: false,
  metafile: true,
  legalComments: /** @type {const} */ ('none'),
  target: 'es2022',
};

/** @param {string} path */
const read = (path) => readFileSync(path, 'utf8');

/** @param {import('esbuild').BuildResult} result */
const textOf = (result) => result.outputFiles?.[0].text ?? '';

// anywidget is published as an AMD module that keeps errors to itself: make it an ES module that passes each
// widget through failure.mjs, without the limit of two seconds that on a slow machine would be reported as an
// error.
const PATCHES = [
  ['define(["@jupyter-widgets/base"], widget_default);', 'export default widget_default;'],
  ['loadWidget(esm(), id).then(', 'guarded(loadWidget(esm(), id)).then('],
  ['resolvers.reject(new Error("[anywidget] Failed to initialize model."));', ''],
];

/** @type {import('esbuild').Plugin} */
const packages = {
  name: 'packages',
  setup({ onLoad, onResolve }) {
    // Lumino's own sources, module by module: of its one built file all panels and menus would stay in.
    onResolve({ filter: /^@lumino\/\w+$/ }, ({ path }) => ({
      path: `${import.meta.dirname}/node_modules/${path}/src/index.ts`,
      sideEffects: false,
    }));
    onLoad({ filter: /[\\/]anywidget[\\/]dist[\\/]index\.js$/ }, ({ path }) => {
      let contents = read(path);
      for (const [from, to] of PATCHES) {
        if (contents.split(from).length !== 2) throw new Error(`anywidget has changed: ${from}`);
        contents = contents.replace(from, to);
      }
      contents = `import { guarded } from './failure.mjs';\n${contents}`;
      return { contents, resolveDir: `${import.meta.dirname}/${RUNTIME}` };
    });
    // Some packages import their package.json for the version in it: leave the rest out.
    onLoad({ filter: /package\.json$/ }, ({ path }) => ({
      contents: JSON.stringify({ version: JSON.parse(read(path)).version }),
      loader: 'json',
    }));
  },
};

/**
 * The licence of every package in the runtime. anywidget holds two more; those without a licence file share
 * one text.
 * @param {string[]} inputs
 */
function licencesOf(inputs) {
  const used = inputs.map((path) => path.match(/^node_modules\/(@[^/]+\/)?[^/]+/)?.[0]).filter(Boolean);
  const folders = [...used, 'node_modules/solid-js', 'node_modules/@lukeed/uuid'];
  const licences = [...new Set(folders)].sort().map((folder) => {
    const { name, license } = JSON.parse(read(`${folder}/package.json`));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    if (!file && license !== 'BSD-3-Clause') throw new Error(`${name} has no licence file`);
    const text = read(file ? `${folder}/${file}` : `${RUNTIME}/BSD-3-Clause.txt`);
    return `${name} (${license})\n\n${text.trim()}\n`;
  });
  return licences.join(`\n${'-'.repeat(80)}\n\n`);
}

/** @returns {Promise<Record<string, string>>} the texts of the files by path */
async function runtime() {
  const css = await build({ ...common, entryPoints: [`${RUNTIME}/theme.css`] });
  const js = await build({
    ...common,
    entryPoints: [`${RUNTIME}/runtime.mjs`],
    format: 'iife',
    plugins: [packages],
    alias: { 'sanitize-html': `./${RUNTIME}/sanitize.mjs`, jquery: 'jquery/dist/jquery.slim.js' },
    tsconfigRaw: { compilerOptions: { useDefineForClassFields: false } },
    define: { RUNTIME_CSS: JSON.stringify(textOf(css).trim()) },
  });
  const banner = `/*! The book's widgets without a kernel; licences in rlswaim-widgets.LICENSES.txt */\n`;
  const inputs = Object.keys({ ...css.metafile.inputs, ...js.metafile.inputs });
  return {
    [`${RUNTIME}/dist/rlswaim-widgets.js`]: banner + textOf(js),
    [`${RUNTIME}/dist/rlswaim-widgets.LICENSES.txt`]: licencesOf(inputs),
  };
}

// The views are a script for a plain page, which makes one global name. Python adds the line that makes it a
// module.
/** @returns {Promise<Record<string, string>>} the texts of the files by path */
async function views() {
  const worker = await build({ ...common, entryPoints: [`${VIEWS}/js/views/map_worker.js`], format: 'esm' });
  const css = await build({ ...common, entryPoints: [`${VIEWS}/css/views.css`] });
  const js = await build({
    ...common,
    entryPoints: [`${VIEWS}/js/views/index.js`],
    format: 'iife',
    globalName: 'rlswaimViews',
    define: { MAP_WORKER: JSON.stringify(textOf(worker)) },
  });
  const banner = `/*! The live views; built from explorers/js and explorers/css */\n`;
  return {
    [`${VIEWS}/built/rlswaim-views.js`]: banner + textOf(js),
    [`${VIEWS}/built/rlswaim-views.css`]: banner + textOf(css),
  };
}

const check = process.argv.includes('--check');
for (const [path, text] of Object.entries({ ...(await runtime()), ...(await views()) })) {
  if (!check) writeFileSync(path, text);
  else if (!existsSync(path) || read(path) !== text) {
    console.error(`${path} was not built from its sources: run make scripts and commit what it writes`);
    process.exitCode = 1;
  }
}
