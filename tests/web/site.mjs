// The built page on a server of its own, and a browser that opens it and notes all that goes wrong.
import { after, before } from 'node:test';
import { chromium } from 'playwright-core';
import { executablePath, sleep, until } from './browser.mjs';
import { serve } from './serve.mjs';

const args = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const size = { width: 320, height: 240 };

export const dist = process.env.TERRELLA_DIST;

// There from before a file's first test until after its last.
export function testSite() {
  const site = {};
  before(async () => {
    site.server = await serve(dist);
    site.browser = await chromium.launch({ executablePath, args });
  });
  after(async () => {
    await site.browser?.close();
    site.server?.close();
  });

  // options: a browser context's, and
  //   script   runs before the page's own
  //   bare     whether the page is not the one with window.terrella
  //   broken   whether its planet will not come
  //   newcomer whether it has never been here, and is shown around
  // Without a service worker unless options allow it: it would ask the server while others count.
  site.open = async (query = '', options = {}) => {
    const context = await site.browser.newContext({ viewport: size, screen: { width: 1920, height: 1080 }, serviceWorkers: 'block', ...options });
    const page = await context.newPage();
    page.setDefaultTimeout(120_000);
    page.wrong = [];
    page.on('console', message => { if (message.type() === 'error') page.wrong.push(message.text()); });
    page.on('pageerror', error => page.wrong.push(error.message));
    page.on('request', request => {
      if (!request.url().startsWith(site.server.url) && !request.url().startsWith('blob:')) page.wrong.push(request.url());
    });
    if (!options.newcomer) await page.addInitScript(hasBeenHere);
    if (options.script) await page.addInitScript(options.script);
    await page.goto(site.server.url + query);
    if (options.bare) return page;
    await until(page, () => Boolean(window.terrella));
    if (!options.broken) await page.evaluate(() => terrella.ready);
    return page;
  };
  return site;
}

// No bubbles over the planet, which tests take hold of.
function hasBeenHere() {
  try {
    if (localStorage.getItem('terrella.panel') === null) localStorage.setItem('terrella.panel', '');
  } catch { /* a frame, or a browser, without memory */ }
}

// Waits until nothing has been drawn for two seconds, and returns the number of frames until then.
// planet: the name of a global.
export async function settled(page, planet = 'terrella') {
  let before = -1, rests = 0;
  for (let i = 0; i < 120; ++i) {
    await sleep(500);
    const now = await page.evaluate(name => window[name].stats().frames, planet);
    rests = now === before ? rests + 1 : 0;
    if (rests === 4) return now;
    before = now;
  }
  throw new Error('it draws and draws');
}

// Mean brightness and number of different colours of what is on screen, or of one element, or of a part: clip, in CSS
// pixels.
export async function look(page, selector, clip) {
  const png = (await (selector ? page.locator(selector) : page).screenshot({ clip })).toString('base64');
  return page.evaluate(async data => {
    const bytes = Uint8Array.from(atob(data), c => c.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes]));
    const sheet = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
    sheet.drawImage(picture, 0, 0);
    const pixels = sheet.getImageData(0, 0, picture.width, picture.height).data;
    const colors = new Set();
    let sum = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      sum += pixels[i] + pixels[i + 1] + pixels[i + 2];
      colors.add((pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2]);
    }
    return { brightness: sum / pixels.length / 0.75 / 255, colors: colors.size };
  }, png);
}

// Takes the planet's context away, gives it back, and waits for a picture.
export async function loseContext(page) {
  await page.evaluate(() => {
    window.loser = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
    loser.loseContext();
  });
  await sleep(300);
  await page.evaluate(() => loser.restoreContext());
  await until(page, frames => terrella.stats().frames > frames, await page.evaluate(() => terrella.stats().frames));
}
