// What belongs to the page, not to its planet: the loading screen, the address bar and window.terrella.
import { Planet } from './planet.mjs';

const canvas = document.getElementById('planet');
const loading = document.getElementById('loading');
const message = document.getElementById('message');
const progress = document.getElementById('progress');
const asked = new URLSearchParams(location.search);

// The panel's habits, from visit to visit. Where a browser lends pages no memory, there are none, and no tour that would
// come each time. Who asks for no panel is not shown around in it.
const habitsKey = 'terrella.panel';
function habits() {
  try {
    if (localStorage.getItem(habitsKey) === null && asked.get('panel') !== '0') keepHabits('tour');
    return localStorage.getItem(habitsKey) ?? '';
  } catch {
    return '';
  }
}
function keepHabits(text) {
  try { localStorage.setItem(habitsKey, text); } catch { /* it forgets */ }
}

const planet = new Planet(canvas, {
  query: withoutTrackers,
  linkTo,
  habits,
  keepHabits,
  firstSize: () => [innerWidth, innerHeight],  // the style sheet may be on its way
  progressed(share) { progress.value = share; },
  shown() { loading.hidden = true; },
  becameRealSize() { keepRealSize().catch(() => {}); },
  failed(sentence) {
    loading.hidden = false;
    progress.hidden = true;
    message.textContent = sentence;
  },
});

// What others add to links that are shared through them.
function withoutTrackers() {
  const query = new URLSearchParams(location.search);
  const trackers = [...query.keys()].filter(key => /^(utm_\w+|\w*clid|igsh(id)?|mc_[ce]id)$/.test(key));
  if (trackers.length === 0) return location.search;  // to the letter, for the sentences about it
  for (const key of trackers) query.delete(key);
  return '?' + query;
}

function linkTo(scene) {
  const query = new URLSearchParams(scene);
  for (const key of ['panel', 'pause']) if (asked.has(key)) query.set(key, asked.get(key));
  const text = query.toString();
  return location.origin + location.pathname + (text ? '?' + text : '');
}

// The address follows the scene, a moment after the hand has rested: browsers refuse more.
let addressTimer = 0;
planet.api.on('change', () => {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => history.replaceState(null, '', planet.api.link()), 300);
});

// The planet is all there is, so that it need not have the focus for these.
document.addEventListener('paste', event => planet.paste(event.clipboardData.getData('text')));
addEventListener('resize', () => planet.fit());

// Keys are for it from the start, without a frame around it.
canvas.toggleAttribute('data-by-hand', true);
canvas.focus({ preventScroll: true });

window.terrella = planet.api;
planet.start();

// Keeps the page for when there is no network, where a browser and the way here (https, or this machine) allow it. Long
// after the first picture, which has better use for the wire.
async function keepForLater() {
  await planet.api.ready;
  await new Promise(done => setTimeout(done, 2000));
  await navigator.serviceWorker.register('worker.js');
}
keepForLater().catch(() => {});

// What few visits need is not kept before one has needed it: it is as large as all the rest.
async function keepRealSize() {
  const { active } = await navigator.serviceWorker.ready;
  active.postMessage('keep real size');
}
