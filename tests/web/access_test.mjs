// The page for those who do not see it, or do not want it to move.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { describe, test } from 'node:test';
import { sleep, until } from './browser.mjs';
import { look, settled, testSite } from './site.mjs';

const { open } = testSite();

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

// What axe-core finds, serious or critical, and how many of its rules had something to look at.
async function faults(page) {
  await page.evaluate(axe + '; 0');  // not as a script of the page, which its security policy would forbid
  return page.evaluate(async () => {
    const { passes, violations } = await window.axe.run();
    const serious = violations.filter(fault => ['serious', 'critical'].includes(fault.impact));
    return { rules: passes.length, serious: serious.map(({ id, help, nodes }) => ({ id, help, where: nodes.map(node => node.html) })) };
  });
}

const label = page => page.getAttribute('canvas', 'aria-label');

describe('the page, to everyone', () => {
  test('describes the planet in words, which follow the scene', async () => {
    const page = await open('?panel=0&pause=1&preset=storm');
    assert.equal(await page.getAttribute('canvas', 'role'), 'img');
    assert.match(await label(page), /^Storm at sea, a procedural planet\. .*\. Seen from above \d+ degrees north/);
    await page.evaluate(() => terrella.load('?preset=moon&terrain.height=0.1'));
    await until(page, () => /planet.* 1 setting changed\.$/.test(document.querySelector('canvas').getAttribute('aria-label')));
    assert.doesNotMatch(await label(page), /Storm/);
    await page.context().close();
  });

  test('stands still for who wants less motion, unless the link says otherwise', async () => {
    const frames = page => page.evaluate(() => terrella.stats().frames);
    const still = await open('?panel=0', { reducedMotion: 'reduce' });
    const before = await settled(still);  // it would not, with the clock running
    await sleep(1000);
    assert.equal(await frames(still), before);
    assert.deepEqual(await still.evaluate(() => terrella.stats().issues), []);
    await still.context().close();

    const moving = await open('?panel=0&pause=0', { reducedMotion: 'reduce' });
    const first = await frames(moving);
    await until(moving, count => terrella.stats().frames > count + 10, first);
    assert.match(await moving.evaluate(() => terrella.link()), /pause=0/);
    await moving.context().close();
  });

  test('lets go of the keys when the focus goes elsewhere', async () => {
    const page = await open('?panel=0&pause=1');
    const longitude = () => page.evaluate(() => terrella.get('camera.longitude'));
    await page.focus('canvas');
    const start = await longitude();
    await page.keyboard.down('ArrowRight');
    await until(page, before => terrella.get('camera.longitude') !== before, start);
    await page.evaluate(() => document.querySelector('canvas').blur());
    await page.keyboard.up('ArrowRight');
    await sleep(1500);  // it coasts a little
    const rest = await longitude();
    await sleep(500);
    assert.equal(await longitude(), rest);
    await page.context().close();
  });

  test('leads by keys alone from the open page to a copied link, and out again', async () => {
    const page = await open('?pause=1&preset=moon&quality.resolution_scale=0.25', { viewport: { width: 800, height: 500 }, permissions: ['clipboard-read', 'clipboard-write'] });
    await page.evaluate(() => { document.body.append(Object.assign(document.createElement('button'), { id: 'next' })); });
    const focused = () => page.evaluate(() => document.activeElement.id);
    const tap = async key => { await page.keyboard.press(key, { delay: 100 }); await sleep(400); };
    const start = await page.evaluate(() => terrella.scene());
    assert.equal(await focused(), 'planet');  // from the start
    const unmarked = await look(page);
    await tap('Tab');  // into the panel: undo and redo are not to be had yet
    assert.notDeepEqual(await look(page), unmarked);
    for (const step of ['Tab', 'Tab', 'Tab', 'ArrowDown']) await tap(step);  // full screen, fold, presets, what lies below
    assert.equal(await focused(), 'planet');
    await tap('Enter');
    await until(page, async () => (await navigator.clipboard.readText()) === terrella.link());
    assert.deepEqual(await page.evaluate(() => terrella.scene()), start);  // the arrow turned no planet
    await tap('Escape');
    await tap('Tab');
    assert.equal(await focused(), 'next');
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('breaks no serious rule of accessibility, nor does its failure or an element', async () => {
    const planet = await open('?pause=1&preset=moon&quality.resolution_scale=0.25', { viewport: { width: 800, height: 500 } });
    const failure = await open('', { broken: true, script: () => { delete window.WebAssembly; } });
    await until(failure, () => /WebAssembly/.test(document.getElementById('message').textContent));
    const element = await open('examples/index.html', { bare: true });
    await until(element, () => Boolean(customElements.get('terrella-planet')));
    for (const page of [planet, failure, element]) {
      const found = await faults(page);
      assert.ok(found.rules > 10, `${found.rules} rules had something to look at`);
      assert.deepEqual(found.serious, []);
      await page.context().close();
    }
  });

  test('would be told of a serious fault', async () => {
    const page = await open('?panel=0&pause=1&preset=moon');
    await page.evaluate(() => {
      document.documentElement.removeAttribute('lang');
      document.querySelector('canvas').removeAttribute('aria-label');
    });
    assert.deepEqual((await faults(page)).serious.map(fault => fault.id).sort(), ['html-has-lang', 'role-img-alt']);
    await page.context().close();
  });
});
