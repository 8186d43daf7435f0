// The page: starts the program, feeds it with what hands do, and offers window.terrella.
const canvas = document.getElementById('planet');
const loading = document.getElementById('loading');
const message = document.getElementById('message');
const progress = document.getElementById('progress');
const page = new URLSearchParams(location.search);

let program;         // the module's exports
let scheduled = false;
let ready, broken;   // settle terrella.ready
const readyPromise = new Promise((keep, breakIt) => { ready = keep; broken = breakIt; });
readyPromise.catch(() => {});  // the sentence is on the page; a caller may still ask for it
const listeners = { change: new Set() };

function fail(sentence) {
  loading.hidden = false;
  progress.hidden = true;
  message.textContent = sentence;
  broken(new Error(sentence));
}

// Text in and out of the program's memory.
const call = (name, types, values, returns = null) => program.ccall('terrella_' + name, returns, types, values);
const textOf = (name, ...texts) => call(name, texts.map(() => 'string'), texts, 'string');

function wake() {
  if (scheduled || !program) return;
  scheduled = true;
  requestAnimationFrame(turn);
}

function turn(now) {
  scheduled = false;
  if (canvas.lost) return;
  const result = program._terrella_frame(now / 1000);
  if (result < 1) {
    progress.value = 0.3 + 0.7 * result;
    setTimeout(wake, 15);  // not at the next frame: there is nothing to paint, and the driver is busy
    return;
  }
  const [drawn, again, whole] = [1, 2, 4].map(bit => ((result - 1) & bit) !== 0);
  if (drawn) loading.hidden = true;
  if (whole) ready();
  if (again) wake();
}

// Size: in whole device pixels, whatever the zoom of the page.
const scale = () => Math.max(0.5, Math.min(devicePixelRatio || 1, 3));
function sizeCanvas(width, height) {
  const pixels = [Math.round(width * scale()), Math.round(height * scale())];
  if (canvas.width !== pixels[0] || canvas.height !== pixels[1]) [canvas.width, canvas.height] = pixels;
}
function fit() {
  const width = Math.max(1, canvas.clientWidth), height = Math.max(1, canvas.clientHeight);
  sizeCanvas(width, height);
  program._terrella_resize(width, height, scale());
  wake();
}

// Hands
const fingers = new Map();
function place(event) {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}
const buttonOf = event => ({ 0: 0, 1: 2, 2: 1 })[event.button] ?? 0;

function twoFingers() {
  const [[ax, ay], [bx, by]] = [...fingers.values()];
  return { x: (ax + bx) / 2, y: (ay + by) / 2, span: Math.max(1, Math.hypot(ax - bx, ay - by)) };
}

function listen() {
  canvas.addEventListener('pointerdown', event => {
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    const at = place(event);
    if (event.pointerType === 'touch') fingers.set(event.pointerId, at);
    if (fingers.size > 1) {
      program._terrella_pointer_button(0, 0);
    } else {
      program._terrella_pointer_moved(...at);
      program._terrella_pointer_button(buttonOf(event), 1);
    }
    wake();
  });
  canvas.addEventListener('pointermove', event => {
    const at = place(event);
    if (fingers.has(event.pointerId) && fingers.size === 2) {
      const before = twoFingers();
      fingers.set(event.pointerId, at);
      const after = twoFingers();
      program._terrella_pinch(after.span / before.span, after.x - before.x, after.y - before.y, after.x, after.y);
    } else if (fingers.size < 2) {
      if (fingers.has(event.pointerId)) fingers.set(event.pointerId, at);
      program._terrella_pointer_moved(...at);
    }
    wake();
  });
  const up = event => {
    const wasPinch = fingers.size > 1;
    fingers.delete(event.pointerId);
    if (!wasPinch) program._terrella_pointer_button(buttonOf(event), 0);
    if (event.pointerType === 'touch') program._terrella_pointer_left();
    wake();
  };
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  canvas.addEventListener('pointerleave', () => { program._terrella_pointer_left(); wake(); });
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? event.deltaY / 3 : event.deltaMode === 2 ? event.deltaY : event.deltaY / 100;
    program._terrella_wheel(-Math.max(-4, Math.min(4, lines)));
    wake();
  }, { passive: false });

  // In the order of terrella::Key.
  const keys = ['', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'PageUp', 'PageDown', 'Home', 'End', '+', '-', ' ',
    'Enter', 'Escape', 'Tab', 'Backspace', 'Delete', 'a', 'c', 'd', 'e', 'f', 'h', 'q', 'r', 's', 'v', 'w', 'x', 'y', 'z'];
  const key = down => event => {
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const index = Math.max(0, keys.indexOf(name === '=' ? '+' : name));
    const control = event.ctrlKey || event.metaKey;
    program._terrella_key(index, down ? 1 : 0, event.shiftKey ? 1 : 0, control ? 1 : 0);
    if (down && event.key.length === 1 && !control) program._terrella_text(event.key.codePointAt(0));
    // The browser would search, scroll or open a list of its own.
    const ours = control ? name === 'z' || name === 'y' : index > 0 || event.key.length === 1;
    if (ours && event.key !== 'Tab') event.preventDefault();
    wake();
  };
  canvas.addEventListener('keydown', key(true));
  canvas.addEventListener('keyup', key(false));
  canvas.addEventListener('blur', () => { program._terrella_keys_left(); wake(); });
  document.addEventListener('paste', event => {
    call('pasted', ['string'], [event.clipboardData.getData('text')]);
    wake();
  });
  canvas.addEventListener('dragover', event => event.preventDefault());
  canvas.addEventListener('drop', async event => {
    event.preventDefault();
    const file = event.dataTransfer.files[0];
    if (file) loadText(await file.text());
  });
  addEventListener('resize', fit);
  new ResizeObserver(fit).observe(canvas);
}

// Whatever lies on the GPU is made here: at first, and again when a context that was lost has come back, even one that was
// lost before there was a program.
function begin() {
  if (!program || canvas.lost) return;
  if (!program._terrella_start()) {
    return fail('Terrella draws into float textures, which this graphics driver does not offer.');
  }
  fit();
}
canvas.addEventListener('webglcontextlost', event => {
  event.preventDefault();
  canvas.lost = true;
  program?._terrella_context_lost();
});
canvas.addEventListener('webglcontextrestored', () => {
  canvas.lost = false;
  begin();
});

function loadText(text) {
  const sentences = JSON.parse(textOf('load_json', text));
  for (const sentence of sentences) call('add_notice', ['string'], [sentence]);
  wake();
  return sentences;
}

// The address follows the scene, a moment after the hand has rested: browsers refuse more.
let addressTimer = 0;
function address() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => history.replaceState(null, '', link()), 300);
}

function link() {
  const query = new URLSearchParams(textOf('link'));
  for (const key of ['panel', 'pause']) if (page.has(key)) query.set(key, page.get(key));
  const text = query.toString();
  return location.origin + location.pathname + (text ? '?' + text : '');
}

function offer(blob, name) {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(blob);
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 10_000);
}

async function screenshot({ width = canvas.width, height = canvas.height } = {}) {
  const most = program._terrella_largest_picture();
  for (const side of [width, height]) {
    if (!Number.isInteger(side) || side < 1 || side > most) {
      throw new Error(`A screenshot's width and height are whole numbers, 1 to ${most}; ${side} is not.`);
    }
  }
  const at = program._terrella_picture(width, height);
  const bytes = new Uint8ClampedArray(program.HEAPU8.buffer, at, 4 * width * height).slice();
  const sheet = new OffscreenCanvas(width, height);
  sheet.getContext('2d').putImageData(new ImageData(bytes, width, height), 0, 0);
  wake();
  return sheet.convertToBlob({ type: 'image/png' });
}

// A value as a link writes it.
const asText = value => typeof value === 'string' ? value : JSON.stringify(value) ?? String(value);

window.terrella = {
  ready: readyPromise,
  get(path) {
    const text = textOf('get', String(path));
    if (text === '') throw new Error(textOf('no_such_parameter', String(path)));
    return JSON.parse(text);
  },
  set(path, value) {
    const sentence = textOf('set', String(path), asText(value));
    if (sentence !== '') throw new Error(sentence);
    wake();
  },
  scene: () => JSON.parse(textOf('scene')),
  load(scene) {
    const sentences = typeof scene === 'string' ? JSON.parse(textOf('load_link', scene)) : JSON.parse(textOf('load_json', JSON.stringify(scene)));
    wake();
    return sentences;
  },
  link,
  stats: () => JSON.parse(textOf('stats')),
  screenshot,
  render: seconds => program._terrella_render(seconds),
  on(event, listener) {
    if (!listeners[event]) throw new Error(`There is no event "${event}"; there is change.`);
    listeners[event].add(listener);
    return () => listeners[event].delete(listener);
  },
};

async function start() {
  if (typeof WebAssembly !== 'object') {
    return fail('Terrella needs WebAssembly, which this browser does not have or does not allow.');
  }
  const coming = import('./terrella.js').then(module => module.default({
    onSceneChanged() { address(); for (const listener of listeners.change) listener(); },
    onCopyText(text) {
      const whole = text.startsWith('{') ? text : link();
      navigator.clipboard?.writeText(whole).catch(() => {});
    },
    onSaveJson: text => offer(new Blob([text], { type: 'application/json' }), 'planet.json'),
    onOpenJson() {
      const input = document.createElement('input');
      input.type = 'file';
      input.accept = '.json,application/json';
      input.onchange = async () => { if (input.files[0]) loadText(await input.files[0].text()); };
      input.click();
    },
    onSavePicture: () => screenshot().then(blob => offer(blob, 'planet.png')),
  }));
  coming.catch(() => {});  // told below, unless the canvas has told already
  progress.value = 0.1;
  // While the program is on its way the driver sets itself up. The style sheet may be on its way too.
  sizeCanvas(innerWidth, innerHeight);
  if (!canvas.getContext('webgl2', { alpha: false, depth: false, antialias: false, powerPreference: 'high-performance' })) {
    return fail('Terrella draws with WebGL 2, which this browser or its graphics driver does not offer.');
  }
  try {
    program = await coming;
  } catch (error) {
    return fail('Terrella could not start its WebAssembly program: ' + error.message);
  }
  progress.value = 0.3;
  if (location.search) for (const sentence of JSON.parse(textOf('load_link', location.search))) call('add_notice', ['string'], [sentence]);
  if (page.get('panel') === '0') program._terrella_show_panel(0);
  if (page.get('pause') === '1') program._terrella_set_paused(1);
  listen();
  begin();
}

start();
