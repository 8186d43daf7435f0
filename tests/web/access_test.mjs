// The page for those who do not see it, or do not want it to move.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { sleep, until } from './browser.mjs';
import { settled, testSite } from './site.mjs';

const { open } = testSite();

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
});
