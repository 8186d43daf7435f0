// The page on a phone.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { sleep, until } from './browser.mjs';
import { look, settled, testSite } from './site.mjs';

const { open } = testSite();

const phone = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 1, hasTouch: true, isMobile: true };
const query = '?pause=1&preset=moon&quality.resolution_scale=0.25';
const handle = [195, 815];

// Its fingers. Each takes places, [x, y] in CSS pixels.
async function fingersOn(page) {
  const session = await page.context().newCDPSession(page);
  const send = (type, places) => session.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
  const twoApart = ([x, y], d) => [[x - d, y], [x + 90 + d, y]];
  return {
    down: (...places) => send('touchStart', places),
    up: () => send('touchEnd', []),
    // As long as people do. page.touchscreen.tap is over before the next frame.
    async tap(place) {
      await send('touchStart', [place]);
      await sleep(120);
      await send('touchEnd', []);
      await sleep(120);
    },
    // Two fingers, the second a moment after the first, move apart.
    async spread(place) {
      await send('touchStart', [place]);
      await send('touchStart', twoApart(place, 0));
      for (let d = 10; d <= 60; d += 10) await send('touchMove', twoApart(place, d));
      await send('touchEnd', []);
    },
    async draw([x, y], [toX, toY]) {
      await send('touchStart', [[x, y]]);
      for (let i = 1; i <= 10; ++i) await send('touchMove', [[x + (toX - x) * i / 10, y + (toY - y) * i / 10]]);
      await sleep(300);  // no throw
      await send('touchEnd', []);
      await sleep(300);
    },
  };
}

const camera = page => page.evaluate(() => JSON.stringify(terrella.scene().camera ?? {}));
const above = page => look(page, undefined, { x: 150, y: 60, width: 90, height: 60 });

describe('the page on a phone', () => {
  test('has its panel folded under the planet; unfolded, the planet makes room for it', async () => {
    const page = await open(query, phone);
    await settled(page);
    const fingers = await fingersOn(page);
    const [start, folded] = [await camera(page), await above(page)];
    await fingers.draw([100, 700], [140, 690]);
    assert.notEqual(await camera(page), start);  // the planet is there, not the panel

    await page.touchscreen.tap(...handle);
    await settled(page);
    const unfolded = await above(page), turned = await camera(page);
    assert.ok(unfolded.brightness > 2 * folded.brightness, JSON.stringify([folded, unfolded]));
    await fingers.draw([100, 700], [100, 600]);
    assert.equal(await camera(page), turned);  // it scrolls the panel
    await fingers.draw([100, 200], [140, 190]);
    assert.notEqual(await camera(page), turned);
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('presses nothing where a second finger comes', async () => {
    const page = await open(query, phone);
    await settled(page);
    const fingers = await fingersOn(page);
    const folded = await above(page);
    await fingers.down(handle);
    await sleep(300);
    await fingers.down(handle, [195, 400]);
    await sleep(300);
    await fingers.up();
    await settled(page);
    assert.deepEqual(await above(page), folded);
    await page.touchscreen.tap(...handle);
    await settled(page);
    assert.notDeepEqual(await above(page), folded);
    await page.context().close();
  });

  test('has its panel at the left when the phone is turned, folded at first; the planet makes room there, too', async () => {
    const page = await open(query, phone);
    await page.setViewportSize({ width: 844, height: 390 });
    await settled(page);
    const right = () => look(page, undefined, { x: 560, y: 100, width: 120, height: 190 });
    const folded = await right();
    await page.touchscreen.tap(35, 32);
    await settled(page);
    const unfolded = await right();
    assert.ok(unfolded.brightness > 1.5 * folded.brightness, JSON.stringify([folded, unfolded]));
    const start = await camera(page);
    const fingers = await fingersOn(page);
    await fingers.draw([100, 330], [100, 250]);  // on the panel
    assert.equal(await camera(page), start);
    await fingers.draw([700, 200], [650, 200]);
    assert.notEqual(await camera(page), start);
    await page.context().close();
  });

  test('shows the keyboard of the screen for what can be typed, and takes it away again', async () => {
    const page = await open(query, phone);
    await settled(page);
    await page.touchscreen.tap(...handle);
    await settled(page);
    const field = () => page.evaluate(() => document.activeElement.localName + ' ' + document.querySelectorAll('input').length);
    assert.equal(await field(), 'canvas 0');
    const fingers = await fingersOn(page);
    await fingers.tap([150, 746]);  // the search
    await until(page, () => document.activeElement.localName === 'input');
    await sleep(300);
    assert.equal(await field(), 'input 1');  // the mouse that browsers imitate after a finger has not taken the focus
    // A keyboard that guesses words: it writes, takes back and writes better; keys have no names.
    const writes = text => page.keyboard.insertText(text);
    const before = await look(page);
    await writes('wafes');
    const misspelt = await look(page);
    assert.notDeepEqual(misspelt, before);  // nothing is called so
    await page.evaluate(() => {
      const input = document.activeElement;
      input.value = input.value.slice(0, -3) + 'ves.count';
      input.dispatchEvent(new InputEvent('input'));
    });
    await settled(page);
    await page.keyboard.press('Enter');
    await until(page, () => document.activeElement.localName === 'canvas');
    assert.equal(await field(), 'canvas 0');
    const count = await page.evaluate(() => terrella.get('waves.count'));
    await fingers.tap([250, 820]);  // on the one slider that is found
    await until(page, before => terrella.get('waves.count') !== before, count);
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });

  test('stays where it is on a tablet while the keyboard of the screen takes part of the height', async () => {
    const page = await open(query, { ...phone, viewport: { width: 768, height: 1024 } });
    await settled(page);
    const fingers = await fingersOn(page);
    await fingers.tap([384, 995]);
    await settled(page);
    await fingers.tap([300, 845]);  // the search
    await until(page, () => document.activeElement.localName === 'input');
    const start = await camera(page);
    await page.keyboard.insertText('w');
    await page.setViewportSize({ width: 768, height: 640 });
    await settled(page);
    await page.keyboard.type('wad');
    await settled(page);
    assert.equal(await camera(page), start);  // the letters went to the field
    assert.equal(await page.evaluate(() => document.activeElement.localName), 'input');
    await page.context().close();
  });

  test('leaves the planet alone where two fingers come down on its panel', async () => {
    const page = await open(query, phone);
    await settled(page);
    const fingers = await fingersOn(page);
    await fingers.tap(handle);
    await settled(page);
    const start = await camera(page);
    await fingers.spread([150, 700]);
    await settled(page);
    assert.equal(await camera(page), start);
    await fingers.spread([150, 200]);
    await settled(page);
    assert.notEqual(await camera(page), start);
    await page.context().close();
  });

  test('unfolds for the sentence about a bad link', async () => {
    const good = await open(query, phone), bad = await open(query + '&terrain.height=abc', phone);
    await settled(good);
    await settled(bad);
    assert.ok((await above(bad)).brightness > 2 * (await above(good)).brightness);  // the planet has made room
    await good.context().close();
    await bad.context().close();
  });

  test('neither selects, zooms nor pulls the page under a finger', async () => {
    const page = await open(query, phone);
    const fingers = await fingersOn(page);
    await fingers.draw([195, 60], [195, 700]);
    await page.touchscreen.tap(195, 400);
    await page.touchscreen.tap(195, 400);
    await fingers.spread([150, 400]);
    await until(page, () => terrella.get('camera.altitude') < 1);
    const page_is = await page.evaluate(() => [visualViewport.scale, scrollY, getSelection().toString(),
      getComputedStyle(document.documentElement).overscrollBehaviorY, getComputedStyle(document.body).touchAction]);
    assert.deepEqual(page_is, [1, 0, '', 'none', 'none']);
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  });
});
