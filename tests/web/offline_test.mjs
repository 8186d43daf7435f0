// The page where there is no network, and where there is a new one.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { sleep, until } from './browser.mjs';
import { serve } from './serve.mjs';
import { dist, look, testSite } from './site.mjs';

const script = join(dirname(fileURLToPath(import.meta.url)), '../../web/worker.cmake');
const site = testSite();
const own = {};  // a server that can be stopped, and a copy of the page that can be changed

afterEach(() => {
  own.server?.close();
  if (own.folder) rmSync(own.folder, { recursive: true });
  delete own.folder;
});

async function visit() {
  own.server = await serve(own.folder ?? dist);
  const context = await site.browser.newContext({ viewport: { width: 320, height: 240 } });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.goto(own.server.url + '?panel=0&pause=1&preset=moon');
  await page.evaluate(() => terrella.ready);
  return page;
}

const keptUnder = page => page.evaluate(() => caches.keys());
const holdsRealSize = page => page.evaluate(async () => Boolean(await caches.match(new URL('terrella_real_size.wasm', location))));
const kept = page => page.evaluate(async () => { await navigator.serviceWorker.ready; });

// Writes the worker as the build does.
function makeWorker() {
  const worker = readFileSync(join(dist, 'worker.js'), 'utf8');
  const listed = list => [...worker.match(new RegExp(`const ${list} = \\[(.*?)\\]`))[1].matchAll(/'(.*?)'/g)].map(match => match[1]);
  const names = listed('files').map(name => name === './' ? 'index.html' : name).join(',');
  assert.equal(spawnSync('cmake', [`-DDIST=${own.folder}`, `-DFILES=${names}`, `-DFILES_OF_REAL_SIZE=${listed('filesOfRealSize')}`, '-P', script]).status, 0);
}

describe('the page, visited again', () => {
  test('opens without a network', async () => {
    const page = await visit();
    const asked = own.server.log.requests;
    await kept(page);
    assert.ok(own.server.log.requests > asked, 'kept before the first picture');
    own.server.close();
    await page.context().setOffline(true);
    await page.reload();
    await page.evaluate(() => terrella.ready);
    assert.equal(await page.evaluate(() => terrella.scene().preset), 'moon');
    const seen = await look(page);
    assert.ok(seen.brightness > 0.02 && seen.colors > 300, JSON.stringify(seen));
    await page.goto(own.server.url + 'index.html?preset=storm&panel=0&pause=1');
    await page.evaluate(() => terrella.ready);
    assert.equal(await page.evaluate(() => terrella.scene().preset), 'storm');
    await page.context().close();
  });

  test('draws planets of real size without a network, if it has drawn one before', async () => {
    const page = await visit();
    await kept(page);
    assert.equal(await holdsRealSize(page), false);
    const few = '&panel=0&pause=1&quality.pixel_error=4&quality.resolution_scale=0.5';
    await page.evaluate(scene => terrella.load(scene), '?preset=blue' + few);
    await until(page, () => terrella.stats().slots.ground === 'triangle_lod');
    while (!await holdsRealSize(page)) await sleep(100);
    own.server.close();
    await page.context().setOffline(true);
    await page.goto(own.server.url + 'index.html?preset=blue' + few);
    await page.evaluate(() => terrella.ready);
    assert.equal(await page.evaluate(() => terrella.stats().slots.ground), 'triangle_lod');
    await page.context().close();
  });

  test('shows a new version at once, and keeps that instead', async () => {
    own.folder = mkdtempSync(join(tmpdir(), 'terrella-'));
    cpSync(dist, own.folder, { recursive: true });
    makeWorker();
    assert.equal(readFileSync(join(own.folder, 'worker.js'), 'utf8'), readFileSync(join(dist, 'worker.js'), 'utf8'));
    const page = await visit();
    await kept(page);
    const before = await keptUnder(page);
    assert.equal(before.length, 1);
    await page.evaluate(async () => { (await navigator.serviceWorker.ready).active.postMessage('keep real size'); });
    while (!await holdsRealSize(page)) await sleep(100);

    const index = join(own.folder, 'index.html');
    writeFileSync(index, readFileSync(index, 'utf8').replace('<title>Terrella', '<title>Terrella, anew'));
    makeWorker();
    await page.reload();
    assert.equal(await page.title(), 'Terrella, anew');
    await until(page, async old => { const now = await caches.keys(); return now.length === 1 && now[0] !== old; }, before[0]);
    assert.equal(await holdsRealSize(page), true, 'what was needed before is kept again');
    own.server.close();
    await page.context().setOffline(true);
    await page.reload();
    assert.equal(await page.title(), 'Terrella, anew');
    await page.evaluate(() => terrella.ready);
    await page.context().close();
  });

  test('does without where there are no service workers', async () => {
    const page = await site.open('?panel=0&pause=1', { script: () => { delete Navigator.prototype.serviceWorker; } });
    await new Promise(done => setTimeout(done, 2500));
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('has a manifest whose icons are there, of the sizes that it says', async () => {
    const page = await site.open('LICENSES.txt', { bare: true });
    const sizes = await page.evaluate(async () => {
      const manifest = await (await fetch('manifest.webmanifest')).json();
      return Promise.all([...manifest.icons, { src: 'apple-touch-icon.png', sizes: '180x180' }, { src: 'preview.png', sizes: '1200x630' }].map(async icon => {
        const picture = await createImageBitmap(await (await fetch(icon.src)).blob());
        return [icon.sizes, `${picture.width}x${picture.height}`];
      }));
    });
    for (const [said, is] of sizes) assert.equal(said, is);
    await page.context().close();
  });
});
