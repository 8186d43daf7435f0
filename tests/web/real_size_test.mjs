// Planets of real size, which the page draws with a program of their own: it is fetched when a scene asks for it, and goes on
// where the first has come to.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { sleep, until } from './browser.mjs';
import { look, loseContext, settled, testSite } from './site.mjs';

const site = testSite();
const open = site.open;
const quick = '&pause=1&quality.resolution_scale=0.5&quality.pixel_error=4';

// The names of the programs' files that a page has asked for.
function programsAsked(page) {
  const names = [];
  page.on('request', request => { const name = /\w+\.wasm/.exec(request.url()); if (name) names.push(name[0]); });
  return names;
}

const ground = page => page.evaluate(() => terrella.stats().slots.ground);
const drawsNodes = page => until(page, () => terrella.stats().slots.ground === 'triangle_lod' && terrella.stats().frames > 0);

describe('a planet of real size', () => {
  test('is drawn as such from its link, from orbit and near the ground', async () => {
    const page = await open('?preset=blue&panel=0' + quick);
    assert.equal(await ground(page), 'triangle_lod');
    const orbit = await look(page);
    assert.ok(orbit.brightness > 0.03 && orbit.colors > 500, JSON.stringify(orbit));
    await page.evaluate(() => terrella.load('preset=highlands&clouds.model=none&quality.pixel_error=4'));
    await settled(page);
    const low = await look(page);
    assert.ok(low.brightness > 0.1 && low.colors > 500, JSON.stringify(low));
    assert.deepEqual((await page.evaluate(() => terrella.stats().issues)).filter(text => /program/.test(text)), []);
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('comes by a preset, once, and all that was done before is still there', async () => {
    const page = await open('?preset=storm&panel=0' + quick);
    const asked = programsAsked(page);
    await page.evaluate(() => {
      window.before = terrella;
      window.changes = 0;
      terrella.on('change', () => ++changes);
      terrella.render(12.5);
      terrella.set('water.level', 0.03);
    });
    await sleep(800);  // what follows is another step
    await page.focus('canvas');
    await page.keyboard.press('2');
    const changes = await page.evaluate(() => window.changes);
    await page.evaluate(() => terrella.load('preset=blue&quality.pixel_error=4'));
    assert.equal(await ground(page), 'icosphere');  // until the other is there
    await drawsNodes(page);
    assert.deepEqual(asked, ['terrella_real_size.wasm']);
    assert.deepEqual(await page.evaluate(() => terrella.scene()), { terrella: 1, preset: 'blue', quality: { pixel_error: 4 } });
    assert.equal(await page.evaluate(() => window.terrella === before), true);
    assert.equal(await page.evaluate(() => window.changes), changes + 1);
    await settled(page);
    await until(page, () => location.search.includes('preset=blue'));

    await page.keyboard.press('Control+z');
    assert.deepEqual(await page.evaluate(() => [terrella.scene().preset, terrella.get('water.level')]), ['storm', 0.03]);
    await until(page, () => terrella.stats().slots.ground === 'icosphere');
    await page.keyboard.press('Control+z');
    assert.notEqual(await page.evaluate(() => terrella.get('water.level')), 0.03);
    await page.keyboard.press('Control+y');
    await page.keyboard.press('Control+y');
    await drawsNodes(page);
    await page.keyboard.down('e');  // which rolls in flight only
    await until(page, () => terrella.get('camera.roll') > 1);
    await page.keyboard.up('e');
    assert.equal(asked.length, 1);
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('comes by a value, once the hand has let go', async () => {
    const page = await open('?panel=0&terrain.model=none' + quick);
    await page.mouse.move(160, 120);
    await page.mouse.down();
    await page.evaluate(() => terrella.set('terrain.model', 'triangle_lod'));
    await sleep(1500);
    const longitude = () => page.evaluate(() => terrella.get('camera.longitude'));
    const before = await longitude();
    await page.mouse.move(120, 120, { steps: 4 });
    let held;
    do {  // until the page has drawn all of it: no throw
      held = await longitude();
      await sleep(300);
    } while (held === before || held !== await longitude());
    assert.equal(await ground(page), 'icosphere');
    await page.mouse.up();
    await drawsNodes(page);
    assert.equal(await longitude(), held);
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('is waited for by screenshots', async () => {
    const page = await open('?panel=0' + quick);
    const [before, after] = await page.evaluate(async () => {
      terrella.load('preset=blue&quality.pixel_error=4');
      const ground = terrella.stats().slots.ground;
      const picture = await createImageBitmap(await terrella.screenshot({ width: 64, height: 48 }));
      return [ground, picture.width];
    });
    assert.deepEqual([before, after], ['icosphere', 64]);
    assert.equal(await ground(page), 'triangle_lod');
    await page.context().close();
  });

  test('that cannot be fetched is said to be so, and drawn as a miniature is; the next scene asks again', async () => {
    const page = await open('?panel=0' + quick);
    await page.route(/real_size/, route => route.abort());
    await page.evaluate(() => terrella.load('preset=blue&quality.pixel_error=4'));
    await until(page, () => terrella.stats().issues.some(text => /program for planets of real size could not be fetched/.test(text)));
    await settled(page);
    const seen = await look(page);
    assert.equal(await ground(page), 'icosphere');
    assert.ok(seen.brightness > 0.03 && seen.colors > 100, JSON.stringify(seen));
    const said = await page.evaluate(() => terrella.stats().issues.length);
    await page.evaluate(() => terrella.set('planet.radius', 7e6));
    await settled(page);
    assert.equal(await page.evaluate(() => terrella.stats().issues.length), said);
    await page.unroute(/real_size/);
    await page.evaluate(() => terrella.load('preset=isles&quality.pixel_error=4'));
    await drawsNodes(page);
    assert.deepEqual(await page.evaluate(() => terrella.stats().issues), []);
    await page.context().close();
  });

  test('whose program takes long is a miniature meanwhile, and ready when it is none', async () => {
    const page = await open('LICENSES.txt', { bare: true });
    let letIn;
    const mayCome = new Promise(done => { letIn = done; });
    await page.route(/real_size/, async route => {
      await mayCome;
      await route.continue();
    });
    await page.goto(site.server.url + '?preset=blue&panel=0' + quick);
    await until(page, () => Boolean(window.terrella));
    await page.evaluate(() => { terrella.ready.then(() => { window.groundWhenReady = terrella.stats().slots.ground; }); });
    await until(page, () => document.getElementById('loading').hidden);
    const meanwhile = await look(page);
    assert.equal(await ground(page), 'icosphere');
    assert.ok(meanwhile.brightness > 0.03, JSON.stringify(meanwhile));
    await settled(page);
    assert.equal(await page.evaluate(() => window.groundWhenReady), undefined);
    letIn();
    await page.evaluate(() => terrella.ready);
    assert.equal(await page.evaluate(() => window.groundWhenReady), 'triangle_lod');
    await page.context().close();
  });

  test('has the maps of heights that miniatures were given', async () => {
    const page = await open('?panel=0' + quick);
    const mapped = () => page.evaluate(() => terrella.stats().needs.find(decision => decision.what === 'ground.map')?.chosen);
    await page.evaluate(() => {
      const texels = new Float32Array(32 * 16).map((_, i) => (i % 32) / 32);
      const dropped = new DataTransfer();
      dropped.items.add(new File(['Pf\n32 16\n-1\n', texels], 'steps.pfm'));
      document.querySelector('canvas').dispatchEvent(new DragEvent('drop', { dataTransfer: dropped, bubbles: true }));
    });
    await until(page, () => terrella.get('terrain.map') === 'steps.pfm');
    await page.evaluate(() => terrella.load('preset=blue&terrain.map=steps.pfm&quality.pixel_error=4'));
    await drawsNodes(page);
    assert.equal(await mapped(), 'steps.pfm');
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('has its context taken and given back like any other', async () => {
    const page = await open('?preset=blue&panel=0' + quick);
    await loseContext(page);
    await settled(page);
    const seen = await look(page);
    assert.ok(seen.brightness > 0.03 && seen.colors > 500, JSON.stringify(seen));
    await page.context().close();
  });
});
