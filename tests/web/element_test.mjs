// The element terrella-planet, on the page of examples and elsewhere.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { sleep, until } from './browser.mjs';
import { look, settled, testSite } from './site.mjs';

const site = testSite();
const examples = 'examples/index.html';

async function openExamples(options = {}) {
  const page = await site.open(examples, { bare: true, viewport: { width: 480, height: 800 }, ...options });
  await page.evaluate(async () => {
    await customElements.whenDefined('terrella-planet');
    for (const planet of document.querySelectorAll('terrella-planet')) await planet.ready;
  });
  return page;
}

const get = (page, id, path) => page.evaluate(([name, what]) => document.getElementById(name).get(what), [id, path]);
const lost = (page, id) => page.evaluate(name => window[name].shadowRoot.querySelector('canvas').getContext('webgl2').isContextLost(), id);

describe('the element', () => {
  test('draws several planets side by side, each its own', async () => {
    const page = await openExamples();
    const seen = {};
    for (const id of ['storm', 'linked', 'changed']) {
      seen[id] = await look(page, '#' + id);
      assert.ok(seen[id].brightness > 0.03 && seen[id].colors > 500, id + JSON.stringify(seen[id]));
    }
    assert.ok(Math.abs(seen.storm.brightness - seen.linked.brightness) > 0.005, JSON.stringify(seen));
    assert.deepEqual(await page.evaluate(() => storm.scene()), { terrella: 1, preset: 'storm' });
    assert.deepEqual(await page.evaluate(() => linked.scene()), { terrella: 1, preset: 'alien', sun: { longitude: -30 }, clouds: { coverage: 0.15 } });
    assert.equal(await page.evaluate(() => storm.link()), '?preset=storm');
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('is set by a program, tells of it, and takes other attributes', async () => {
    const page = await openExamples();
    const before = await get(page, 'changed', 'water.level');
    const frames = await settled(page, 'changed');
    const brightness = (await look(page, '#changed')).brightness;
    await page.click('#flood');
    assert.ok(await get(page, 'changed', 'water.level') > before);
    await until(page, () => told.textContent.includes('46 mm'));
    await until(page, count => changed.stats().frames > count, frames);
    await settled(page, 'changed');
    assert.notEqual((await look(page, '#changed')).brightness, brightness);
    assert.equal(await get(page, 'storm', 'water.level'), await page.evaluate(() => linked.load('?preset=storm') && linked.get('water.level')));
    await page.evaluate(() => { linked.setAttribute('scene', 'https://example.org/?preset=moon&terrain.height=0.1#here'); });
    assert.deepEqual(await page.evaluate(() => linked.scene()), { terrella: 1, preset: 'moon', terrain: { height: 0.1 } });
    await page.evaluate(() => { linked.setAttribute('preset', 'desert'); });
    assert.equal(await page.evaluate(() => linked.scene().preset), 'desert');
    assert.match(await page.evaluate(() => { try { storm.set('waves.count', -1); } catch (error) { return error.message; } }), /waves\.count/);
    const png = await page.evaluate(async () => (await storm.screenshot({ width: 64, height: 48 })).type);
    assert.equal(png, 'image/png');
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('gives its context back when it is taken out, and lives again when it is put back', async () => {
    const page = await openExamples();
    await page.evaluate(() => { window.kept = changed; window.other = storm; changed.set('water.level', 0.05); });
    assert.equal(await lost(page, 'kept'), false);
    await page.click('#away');
    await until(page, () => kept.shadowRoot.querySelector('canvas').getContext('webgl2').isContextLost());
    const frames = await page.evaluate(() => kept.stats().frames);
    assert.match(await page.evaluate(() => kept.screenshot().then(() => '', error => error.message)), /no graphics context/);
    await page.evaluate(() => kept.set('clouds.coverage', 0.2));
    await sleep(500);
    assert.equal(await page.evaluate(() => kept.stats().frames), frames);
    assert.equal(await lost(page, 'other'), false);

    await page.click('#away');
    await until(page, count => kept.stats().frames > count, frames);
    await settled(page, 'kept');
    assert.equal(await lost(page, 'kept'), false);
    assert.equal(await get(page, 'changed', 'water.level'), 0.05);
    const seen = await look(page, '#changed');
    assert.ok(seen.brightness > 0.03 && seen.colors > 500, JSON.stringify(seen));
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('keeps its context when it is moved, and survives being taken out and put back at any moment', async () => {
    const page = await openExamples();
    await page.evaluate(() => {
      window.losses = 0;
      changed.shadowRoot.querySelector('canvas').addEventListener('webglcontextlost', () => ++losses);
      document.body.prepend(changed);
    });
    await sleep(300);
    assert.equal(await page.evaluate(() => losses), 0);
    for (const wait of ['0', 'Promise.resolve()', 'new Promise(done => setTimeout(done))', 'new Promise(done => setTimeout(done, 40))']) {
      const frames = await page.evaluate(() => changed.stats().frames);
      await page.evaluate(`(async () => { const planet = changed; planet.remove(); await ${wait}; document.body.prepend(planet); })()`);
      await page.evaluate(() => changed.set('clouds.coverage', Math.random()));
      await until(page, count => changed.stats().frames > count, frames);
    }
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('draws only while it is in sight', async () => {
    const page = await openExamples();
    const frames = () => page.evaluate(() => storm.stats().frames);
    await page.evaluate(() => { storm.setAttribute('pause', '0'); });
    await until(page, count => storm.stats().frames > count + 3, await frames());
    await page.evaluate(() => { document.body.style.paddingBottom = '3000px'; scrollTo(0, 3000); });
    const before = await settled(page, 'storm');  // which it would not, as its clock runs
    await page.evaluate(() => scrollTo(0, 0));
    await until(page, count => storm.stats().frames > count + 3, before);
    await page.context().close();
  });

  test('comes and goes more often than a browser has contexts', async () => {
    const page = await openExamples();
    await page.evaluate(async () => {
      window.first = storm;
      for (let i = 0; i < 20; ++i) {
        const planet = document.createElement('terrella-planet');
        document.body.append(planet);
        await new Promise(done => setTimeout(done, 20));
        planet.remove();
        await new Promise(done => setTimeout(done, 20));
      }
    });
    await sleep(1000);
    assert.equal(await lost(page, 'first'), false);
    await page.context().close();
  });

  test('hears keys and pasted text only while it has the focus', async () => {
    const page = await openExamples();
    const longitudes = async () => [await get(page, 'storm', 'camera.longitude'), await get(page, 'linked', 'camera.longitude')];
    const paste = text => page.evaluate(what => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text', what);
      document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
    }, text);
    const [left, right] = await longitudes();
    await page.evaluate(() => linked.focus());
    await page.keyboard.press('ArrowRight');
    await until(page, before => linked.get('camera.longitude') !== before, right);
    await paste('preset=moon');
    assert.equal(await page.evaluate(() => linked.scene().preset), 'moon');
    assert.deepEqual((await longitudes())[0], left);
    assert.equal(await page.evaluate(() => storm.scene().preset), 'storm');
    await page.evaluate(() => document.activeElement.blur());
    await paste('preset=lava');
    assert.equal(await page.evaluate(() => linked.scene().preset), 'moon');
    await page.context().close();
  });

  test('is asked too early in a sentence, and says in one what it needs', async () => {
    const page = await site.open(examples, { bare: true, script: () => {
      const original = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === 'webgl2' ? null : original.call(this, kind, ...rest); };
    } });
    await page.evaluate(() => customElements.whenDefined('terrella-planet'));
    assert.match(await page.evaluate(() => storm.ready.then(() => '', error => error.message)), /WebGL 2/);
    assert.match(await page.evaluate(() => storm.shadowRoot.querySelector('p:not([hidden])').textContent), /WebGL 2/);
    assert.match(await page.evaluate(() => { try { storm.get('waves.count'); } catch (error) { return error.message; } }), /waking up/);
    await page.context().close();
  });
});
