// The npm package: what is in it, and whether its types say what there is.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { serve } from './serve.mjs';
import { dist, testSite } from './site.mjs';

const folder = join(dist, '../package');
const site = testSite();
const types = readFileSync(join(folder, 'terrella.d.ts'), 'utf8');

// The names of what an interface or a class declares.
function membersOf(name) {
  const body = types.match(new RegExp(`(?:interface|class) ${name}\\b[^{]*\\{\\n([^]*?)\\n\\}`))[1];
  return [...body.matchAll(/^  (?:readonly )?(\w+)[?(:]/gm)].map(match => match[1]).sort();
}

describe('the package', () => {
  test('is packed whole, and nothing else', () => {
    const { stdout, status } = spawnSync('npm', ['pack', '--dry-run', '--json'], { cwd: folder, encoding: 'utf8' });
    assert.equal(status, 0);
    const [packed] = JSON.parse(stdout);
    assert.deepEqual(packed.files.map(file => file.path).sort(), ['LICENSE', 'LICENSES.txt', 'README.md', 'element.mjs',
      'package.json', 'planet.mjs', 'terrella.d.ts', 'terrella.js', 'terrella.wasm', 'terrella_real_size.js', 'terrella_real_size.wasm']);
    assert.ok(packed.size < 760_000, `${packed.size} bytes`);
    assert.match(readFileSync(join(folder, 'LICENSES.txt'), 'utf8'), /Dear ImGui/);
  });

  test('has the files that its entry asks for', () => {
    const { exports, files, types: named } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    for (const path of [exports['.'].default, exports['.'].types, named, ...files]) readFileSync(join(folder, path));
  });

  test('draws a planet by itself', async t => {
    const server = await serve(folder);
    t.after(server.close);
    const page = await site.browser.newPage();
    await page.goto(server.url + 'LICENSE');
    const scene = await page.evaluate(async entry => {
      await import(new URL(entry, location));
      document.body.innerHTML = '<terrella-planet preset="moon" panel="0" pause="1"></terrella-planet>';
      const planet = document.querySelector('terrella-planet');
      await planet.ready;
      return planet.scene();
    }, './element.mjs');
    assert.deepEqual(scene, { terrella: 1, preset: 'moon' });
    assert.deepEqual(server.log.missing.filter(path => path !== '/favicon.ico'), []);  // which browsers ask for unasked
    await page.close();
  });

  test('declares each member that there is, and no other', async () => {
    const page = await site.open('?panel=0&pause=1');
    assert.deepEqual(membersOf('Planet'), await page.evaluate(() => Object.keys(terrella).sort()));
    assert.deepEqual(membersOf('Stats'), await page.evaluate(() => Object.keys(terrella.stats()).sort()));
    assert.deepEqual(membersOf('TerrellaPlanet'), membersOf('Planet'));
    await page.context().close();
  });
});
