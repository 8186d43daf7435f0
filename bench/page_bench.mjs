// What the page costs in a real browser, beside a load that never changes (yardstick/), whose median frame is Y:
//   node bench/page_bench.mjs [--sea] [swiftshader|llvmpipe ...]
// --sea: only the open sea and Y.
// Frames are timed until one of their pixels has been read back. Figures hold within one run only.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { executablePath, until } from '../tests/web/browser.mjs';
import { serve } from '../tests/web/serve.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const { chromium } = createRequire(join(here, '../tests/web/'))('playwright-core');
const drivers = {
  swiftshader: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  llvmpipe: ['--use-angle=gl-egl', '--ignore-gpu-blocklist'],
};
const rounds = 3, warmUp = 25, timed = 12;
const viewport = { width: 1280, height: 720 };

const median = values => values.toSorted((a, b) => a - b)[values.length >> 1];
const ms = value => `${value.toFixed(0)} ms`;
const inY = (time, y) => `${ms(time)} = ${(time / y.frame).toFixed(2)} Y`;

// Runs in a page before its own scripts: notes how long each frame takes, and when the first one was done.
function watch() {
  const contexts = new Set(), pixel = new Uint8Array(4);
  let drawn = false;
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (...request) {
    const context = getContext.apply(this, request);
    if (context?.readPixels) contexts.add(context);
    return context;
  };
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced']) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...of) { drawn = true; draw.apply(this, of); };
  }
  window.watched = { frames: [], first: 0, before: () => {} };
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = callback => request(now => {
    const start = performance.now();
    drawn = false;
    if (watched.first) watched.before(now);
    callback(now);
    if (!drawn) return;
    for (const context of contexts) {
      // A frame may end with a picture of floats bound, which cannot be read as bytes and so would not be waited for.
      const bound = context.getParameter(context.READ_FRAMEBUFFER_BINDING);
      context.bindFramebuffer(context.READ_FRAMEBUFFER, null);
      context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, pixel);
      context.bindFramebuffer(context.READ_FRAMEBUFFER, bound);
    }
    watched.frames.push(performance.now() - start);
    watched.first ||= performance.now();
  });
}

async function open(browser, url, size = viewport) {
  const page = await (await browser.newContext({ viewport: size, serviceWorkers: 'block' })).newPage();
  await page.addInitScript(watch);
  await page.addInitScript(() => localStorage.setItem('terrella.panel', ''));  // no newcomer, who is shown around
  await page.goto(url);
  return page;
}

// Times of frames and of the first one. slide: whether terrain.height changes before each frame.
async function visit(browser, url, slide) {
  const page = await open(browser, url);
  await until(page, () => watched.first > 0);
  if (slide) await page.evaluate(() => { watched.before = now => terrella.set('terrain.height', 0.16 + 0.02 * Math.sin(now)); });
  await until(page, count => watched.frames.length >= count, warmUp + timed);
  const seen = await page.evaluate(() => watched);
  const stats = await page.evaluate(() => window.terrella?.stats());
  await page.context().close();
  return { frames: seen.frames.slice(warmUp, warmUp + timed), first: seen.first, stats };
}

// Visits the pages in turn, several times. visits: of each its address, and whether its slider moves.
async function compare(browser, visits) {
  const all = visits.map(() => ({ frames: [], firsts: [] }));
  for (let round = 0; round < rounds; ++round) {
    for (const [i, [url, slide]] of visits.entries()) {
      const { frames, first, stats } = await visit(browser, url, slide);
      all[i].frames.push(...frames);
      all[i].firsts.push(first);
      all[i].stats = stats;
    }
  }
  return all.map(({ frames, firsts, stats }) => ({ frame: median(frames), first: median(firsts), stats }));
}

// Scenes, told by links: the median of a number of frames of each, after a third as many. Each in a page of its own, which
// is ready when the program is there that its planet needs.
async function timeScenes(browser, url, links, count) {
  const rows = [];
  for (const link of links) {
    const page = await open(browser, `${url}${link}&panel=0&pause=1`);
    await page.evaluate(() => terrella.ready);
    const { times, triangles } = await page.evaluate(count => {
      const times = [], before = Math.ceil(count / 3);
      for (let i = 0; i < before + count; ++i) {
        const start = performance.now();
        terrella.render(100 + 0.04 * i);
        if (i >= before) times.push(performance.now() - start);
      }
      return { times, triangles: terrella.stats().triangles };
    }, count);
    rows.push({ time: median(times), triangles });
    await page.context().close();
  }
  return rows;
}

// Runs in a page before its own scripts: notes the two shaders of each program.
function noteShaders() {
  const { shaderSource, attachShader } = WebGL2RenderingContext.prototype;
  const texts = new Map(), programs = new Map();
  window.shaderPairs = () => [...programs.values()].filter(stages => stages.length === 2);
  WebGL2RenderingContext.prototype.shaderSource = function (shader, text) { texts.set(shader, text); shaderSource.call(this, shader, text); };
  WebGL2RenderingContext.prototype.attachShader = function (program, shader) {
    programs.set(program, [...programs.get(program) ?? [], texts.get(shader)]);
    attachShader.call(this, program, shader);
  };
}

// Views that need all programs of planets between them.
const views = ['', '?preset=storm', '?preset=alps', '?preset=moon', '?preset=archipelago&camera.altitude=0.05'];

const launch = driver => chromium.launch({ executablePath, args: ['--no-sandbox', '--hide-scrollbars', '--use-gl=angle', '--disable-frame-rate-limit', '--disable-gpu-vsync', ...drivers[driver]] });

// The most time that a program takes to compile and link, and for its first draw: in a browser that has not seen it yet,
// or it would come from a cache.
async function timePrograms(driver, browser, url) {
  const pairs = new Map();
  for (const view of views) {
    const page = await browser.newPage();
    await page.addInitScript(noteShaders);
    await page.goto(url + view);
    await page.evaluate(() => terrella.ready);
    for (const pair of await page.evaluate(() => shaderPairs())) pairs.set(pair.join(), pair);
    await page.close();
  }
  const fresh = await launch(driver);
  const page = await fresh.newPage();
  const times = await page.evaluate(all => all.map(([vertex, fragment]) => {
    const gl = document.createElement('canvas').getContext('webgl2');
    const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    gl.clear(gl.COLOR_BUFFER_BIT);
    wait();
    const start = performance.now(), program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const linked = performance.now();
    gl.useProgram(program);
    gl.bindBuffer(gl.UNIFORM_BUFFER, gl.createBuffer());
    gl.bufferData(gl.UNIFORM_BUFFER, 65536, gl.STATIC_DRAW);
    let unit = 0;
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORM_BLOCKS); ++i) {
      gl.uniformBlockBinding(program, i, i);
      gl.bindBufferBase(gl.UNIFORM_BUFFER, i, gl.getParameter(gl.UNIFORM_BUFFER_BINDING));
    }
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
      const { name, type } = gl.getActiveUniform(program, i);
      if (type === gl.SAMPLER_CUBE || type === gl.SAMPLER_2D) gl.uniform1i(gl.getUniformLocation(program, name), unit++);
    }
    const ready = performance.now();
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    wait();
    const drawn = performance.now();
    gl.getExtension('WEBGL_lose_context').loseContext();
    return [linked - start, drawn - ready];
  }), [...pairs.values()]);
  await fresh.close();
  return [Math.max(...times.map(t => t[0])), Math.max(...times.map(t => t[1]))];
}

// GPU memory before and after many frames.
async function growth(browser, url, frames) {
  const page = await open(browser, url + '?panel=0&pause=1', { width: 96, height: 54 });
  await page.evaluate(() => terrella.ready);
  const bytes = [];
  for (let done = 0; done <= frames; done += 500) {
    bytes.push(await page.evaluate(from => {
      for (let i = 0; i < 500; ++i) terrella.render(100 + (from + i) / 30);
      return terrella.stats().gpu_bytes;
    }, done));
  }
  await page.context().close();
  return [bytes[0], Math.max(...bytes)];
}

async function benchSea(driver, url, yardstick) {
  const browser = await launch(driver);
  const [y] = await compare(browser, [[yardstick, false]]);
  console.log(`\n${driver}, ${viewport.width}x${viewport.height}, open sea from 20 m: Y is ${ms(y.frame)}`);
  const rows = await timeScenes(browser, url, Object.values(seas).map(sea => `${openSea}&${sea}`), 6);
  for (const [i, name] of Object.keys(seas).entries()) {
    const { time, triangles } = rows[i];
    console.log(`${name}: ${inY(time, y)}, ${(time / rows[0].time).toFixed(2)} times as much as without water, ${triangles} triangles`);
  }
  await browser.close();
}

async function bench(driver, url, yardstick) {
  const browser = await launch(driver);
  const [y, page, slide] = await compare(browser, [[yardstick, false], [url, false], [url, true]]);
  console.log(`\n${driver}, ${viewport.width}x${viewport.height}: Y is ${ms(y.frame)}`);
  console.log(`default, everything moving, with the panel: ${inY(page.frame, y)}, ${page.stats.triangles} triangles, ${page.stats.programs.length} programs, ${(page.stats.gpu_bytes / 1e6).toFixed(1)} MB`);
  console.log(`the same while terrain.height changes with every frame: ${inY(slide.frame, y)}`);
  console.log(`first frame: ${ms(page.first)}, that of Y's page ${ms(y.first)}: ${(page.first / y.first).toFixed(2)} times`);
  const ofPresets = await timeScenes(browser, url, presets.map(name => '?preset=' + name), 11);
  for (const [i, { time, triangles }] of ofPresets.entries()) console.log(`${presets[i]}: ${inY(time, y)}, ${triangles} triangles`);
  const [linked, drawn] = await timePrograms(driver, browser, url);
  console.log(`programs of all views: compiled and linked in at most ${ms(linked)} each, first draw at most ${ms(drawn)}`);
  const [before, after] = await growth(browser, url, 10_000);
  console.log(`GPU memory after 500 frames ${before} bytes, the most in 10,000 frames ${after} bytes`);
  await browser.close();
}

// Waves of a wind of 8 m/s, looked down on from 20 m.
const openSea = '?preset=blue&clouds.model=none&camera.latitude=0&camera.altitude=1020&waves.spectrum=wind&waves.wind=8';
const seas = { 'no water': 'water.model=none', 'still water': 'waves.count=0&water.ripples=0', '20 waves': 'waves.count=20', '50 waves': 'waves.count=50', '100 waves': 'waves.count=100', '1,000 waves': 'waves.count=1000' };

const dist = join(here, '../build/web/dist');
const presets = readFileSync(join(here, '../presets/order.txt'), 'utf8').split(/\s+/).filter(Boolean);
const server = await serve(dist), load = await serve(join(here, 'yardstick'), '/y/', {});
const probe = await chromium.launch({ executablePath, args: ['--no-sandbox', '--use-gl=angle', ...drivers.swiftshader] });
await (await open(probe, server.url)).evaluate(() => terrella.ready);
await probe.close();
console.log(`page: ${(server.log.gzipped / 1000).toFixed(0)} kB gzipped in ${server.log.requests} requests`);
const named = process.argv.slice(2).filter(argument => argument !== '--sea'), onlySea = process.argv.includes('--sea');
for (const driver of named.length > 0 ? named : Object.keys(drivers)) {
  if (!drivers[driver]) throw new Error(`There is no driver "${driver}"; there are ${Object.keys(drivers).join(', ')}.`);
  if (!onlySea) await bench(driver, server.url, load.url);
  await benchSea(driver, server.url, load.url);
}
server.close();
load.close();
