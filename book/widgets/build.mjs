// Builds dist/ from this folder: `npm ci && npm run build`. The same sources give the same bytes.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

process.chdir(import.meta.dirname);
const read = (path) => readFileSync(path, 'utf8');

// One hash over all that is written by hand and the versions of all that is not; a test compares it.
const sources = readdirSync('.')
  .filter((name) => /\.(mjs|css|txt)$|^package-lock\.json$/.test(name))
  .sort();
const hash = createHash('sha256');
for (const name of sources) hash.update(readFileSync(name));

// anywidget is published as an AMD module that keeps errors to itself: make it an ES module that passes each widget
// through failure.mjs, without the limit of two seconds that on a slow machine would be reported as an error.
const PATCHES = [
  ['define(["@jupyter-widgets/base"], widget_default);', 'export default widget_default;'],
  ['loadWidget(esm(), id).then(', 'guarded(loadWidget(esm(), id)).then('],
  ['resolvers.reject(new Error("[anywidget] Failed to initialize model."));', ''],
];
const packages = {
  name: 'packages',
  setup({ onLoad }) {
    onLoad({ filter: /[\\/]anywidget[\\/]dist[\\/]index\.js$/ }, ({ path }) => {
      let contents = read(path);
      for (const [from, to] of PATCHES) {
        if (contents.split(from).length !== 2) throw new Error(`anywidget has changed: ${from}`);
        contents = contents.replace(from, to);
      }
      contents = `import { guarded } from './failure.mjs';\n${contents}`;
      return { contents, resolveDir: import.meta.dirname };
    });
    // Some packages import their package.json for the version in it: leave the rest out.
    onLoad({ filter: /package\.json$/ }, ({ path }) => ({
      contents: JSON.stringify({ version: JSON.parse(read(path)).version }),
      loader: 'json',
    }));
  },
};

const common = {
  bundle: true,
  minify: true,
  write: false,
  metafile: true,
  legalComments: 'none',
  target: 'es2022',
};
const css = await build({ ...common, entryPoints: ['theme.css'] });
const js = await build({
  ...common,
  entryPoints: ['runtime.mjs'],
  format: 'iife',
  plugins: [packages],
  alias: { 'sanitize-html': './sanitize.mjs' },
  define: { RUNTIME_CSS: JSON.stringify(css.outputFiles[0].text.trim()) },
});

const banner = `/*! The book's widgets without a kernel; built by book/widgets/build.mjs, licences in rlswaim-widgets.LICENSES.txt
sources sha256: ${hash.digest('hex')} */
`;
writeFileSync('dist/rlswaim-widgets.js', banner + js.outputFiles[0].text);

// The licence of every package in the bundle. anywidget holds two more; those without a licence file share one text.
const inputs = Object.keys({ ...css.metafile.inputs, ...js.metafile.inputs });
const folders = inputs.flatMap((path) => path.match(/^node_modules\/(@[^/]+\/)?[^/]+/)?.[0] ?? []);
folders.push('node_modules/solid-js', 'node_modules/@lukeed/uuid');
const licences = [...new Set(folders)].sort().map((folder) => {
  const { name, license } = JSON.parse(read(`${folder}/package.json`));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  if (!file && license !== 'BSD-3-Clause') throw new Error(`${name} has no licence file`);
  return `${name} (${license})\n\n${read(file ? `${folder}/${file}` : 'BSD-3-Clause.txt').trim()}\n`;
});
writeFileSync('dist/rlswaim-widgets.LICENSES.txt', licences.join(`\n${'-'.repeat(80)}\n\n`));
