// A planet on a canvas: a program of its own, fed with what hands do, and what it offers to other programs. Of a page it
// knows only what it is told, so that there may be several on one. The program is that of miniatures, until its scene is of
// a planet of real size: then a larger one is fetched and goes on in its place.

// In the order of terrella::Key.
const keys = ['', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'PageUp', 'PageDown', 'Home', 'End', '+', '-', ' ',
  'Enter', 'Escape', 'Tab', 'Backspace', 'Delete', 'a', 'c', 'd', 'e', 'f', 'g', 'h', 'n', 'q', 'r', 's', 't', 'v', 'w', 'x',
  'y', 'z', '1', '2', '3'];

const scale = () => Math.max(0.5, Math.min(devicePixelRatio || 1, 3));

const fingersPoint = () => matchMedia('(pointer: coarse)').matches;

const rest = milliseconds => new Promise(done => setTimeout(done, milliseconds));

// A value as a link writes it.
const asText = value => typeof value === 'string' ? value : JSON.stringify(value) ?? String(value);

export class Planet {
  #canvas;
  #around;
  #program = null;      // the module's exports
  #realSize = null;     // a promise, while the program for planets of real size is on its way
  #realSizeFailed = 0;  // times that it could not be fetched
  #maps = [];           // files of maps of heights: as many as a program keeps, the last one last
  #begun = false;       // the program has the context
  #context = null;
  #loser = null;        // what gives the context back, while it is given back
  #lost = false;
  #asleep = false;
  #unseen = false;
  #scheduled = false;
  #keepReady;
  #breakReady;
  #listeners = { change: new Set() };
  #describing = 0;
  #screenKeys = null;

  api;  // what programs get; see terrella.d.ts

  // around: what belongs to the surroundings.
  //   query()            scene, panel and pause, as in a link
  //   linkTo(query)      the link that leads to a scene
  //   firstSize()        in CSS pixels, where the canvas may not have been laid out yet
  //   habits()           the panel's, as they were kept
  //   keepHabits(text)   for the next visit
  //   progressed(share), shown(), failed(sentence)
  //   becameRealSize()   the program for planets of real size was fetched
  constructor(canvas, around) {
    this.#canvas = canvas;
    this.#around = { linkTo: query => '?' + query, firstSize: () => [canvas.clientWidth, canvas.clientHeight],
      habits: () => '', keepHabits() {}, progressed() {}, shown() {}, failed() {}, becameRealSize() {}, ...around };
    const ready = new Promise((keep, breakIt) => { this.#keepReady = keep; this.#breakReady = breakIt; });
    ready.catch(() => {});  // the surroundings show the sentence; a caller may still ask for it
    this.api = this.#offers(ready);
    this.#watchContext();
  }

  async start() {
    if (typeof WebAssembly !== 'object') {
      return this.#fail('Terrella needs WebAssembly, which this browser does not have or does not allow.');
    }
    const coming = import('./terrella.js').then(module => module.default(this.#host()));
    coming.catch(() => {});  // told below, unless the canvas has told already
    this.#around.progressed(0.1);
    // To ask for a context is to wait until the driver has set itself up: a program that is nearly here comes first, and
    // the driver does so while one is on its way that is not.
    await Promise.race([coming, rest(200)]).catch(() => {});
    this.#size(...this.#around.firstSize());
    this.#context = this.#canvas.getContext('webgl2', { alpha: false, depth: false, antialias: false, powerPreference: 'high-performance' });
    if (!this.#context) {
      return this.#fail('Terrella draws with WebGL 2, which this browser or its graphics driver does not offer.');
    }
    if (this.#asleep) this.sleep();  // since before there was one
    try {
      this.#program = await coming;
    } catch (error) {
      return this.#fail('Terrella could not start its WebAssembly program: ' + error.message);
    }
    this.#around.progressed(0.3);
    this.#call('take_habits', ['string'], [this.#around.habits()]);
    if (this.#around.query()) this.loadQuery();
    this.showPanel();
    this.setClock();
    this.#describe();
    const hand = { canvas: this.#canvas, call: (name, ...values) => this.#program['_terrella_' + name](...values), wake: () => this.#wake() };
    this.#screenKeys = new ScreenKeys(hand);
    listenToPointers(hand, this.#screenKeys);
    listenToKeys(hand, this.#canvas);
    this.#listenToDrops();
    new ResizeObserver(() => this.fit()).observe(this.#canvas);
    // Who comes for a planet of real size is shown no other, unless it takes long: two sets of shaders take the driver longer.
    await Promise.race([this.#realSize, rest(1000)]);
    if (!this.#begun) this.#begin();
  }

  // The program for planets of real size takes the place of the one that is here, which goes on until then. It draws miniatures
  // as well, so that there is no way back.

  #wantRealSize() {
    this.#realSize ??= this.#becomeRealSize().catch(error => {
      ++this.#realSizeFailed;
      this.#note([`The program for planets of real size could not be fetched, so that the ground near the eye stays coarse: ${error.message}`]);
    }).finally(() => {
      this.#realSize = null;
      this.#wake();
    });
  }

  async #becomeRealSize() {
    // Some browsers remember of a module that it could not be fetched: then it is asked for by another address.
    const again = `${new URL('terrella_real_size.js', import.meta.url)}?${this.#realSizeFailed}`;
    const module = await (this.#realSizeFailed === 0 ? import('./terrella_real_size.js') : import(again));
    const program = await module.default(this.#host());
    // Maps first, those as well that a hand gives meanwhile; then the rest at once, while no hand holds anything.
    const given = new Set();
    for (;;) {
      const file = this.#maps.find(map => !given.has(map));
      if (file) {
        given.add(file);
        await readMap(file).then(map => giveMap(program, map, false)).catch(() => {});  // the file may have gone
      } else if (this.#program._terrella_hands_rest()) break;
      else await rest(50);
    }
    const all = this.#text('hand_over');
    this.#program._terrella_context_lost();  // for this one: the next finds nothing in it, and the picture stays on screen
    this.#program = program;
    this.#call('take_over', ['string'], [all]);
    this.#around.becameRealSize();
    this.#begin();
  }

  // Scene, panel and clock as the surroundings' query has them; nothing before there is a program, which asks by itself.

  loadQuery() {
    if (!this.#program) return;
    this.#note(this.#sentences('load_link', this.#around.query()));
    this.#wake();
  }
  showPanel() {
    this.#program?._terrella_show_panel(this.#asked('panel') === '0' ? 0 : 1);
    this.#wake();
  }
  setClock() {
    const asked = this.#asked('pause');
    const stopped = asked === '1' || (asked !== '0' && matchMedia('(prefers-reduced-motion: reduce)').matches);
    this.#program?._terrella_set_paused(stopped ? 1 : 0);
    this.#wake();
  }
  #asked(key) { return new URLSearchParams(this.#around.query()).get(key); }

  // Gives the context back, and all that lies on the GPU with it, until it is wanted again.
  sleep() {
    this.#asleep = true;
    this.#loser ??= this.#context?.getExtension('WEBGL_lose_context') ?? null;
    this.#loser?.loseContext();
  }
  rouse() {
    this.#asleep = false;
    if (this.#lost) this.#loser?.restoreContext();
    this.#wake();
  }

  // A planet that nobody sees is not drawn, except into screenshots.
  setSeen(seen) {
    this.#unseen = !seen;
    this.#wake();
  }

  // A text from the clipboard.
  paste(text) {
    if (!this.#program) return;
    this.#call('pasted', ['string'], [text]);
    this.#wake();
  }

  // To be called as well when the page's zoom has changed, of which nobody tells the canvas.
  fit() {
    if (!this.#program || !this.#canvas.isConnected) return;
    const width = Math.max(1, this.#canvas.clientWidth), height = Math.max(1, this.#canvas.clientHeight);
    this.#size(width, height);
    this.#program._terrella_resize(width, height, scale(), fingersPoint() ? 1 : 0);
    this.#wake();
  }

  // In whole device pixels, whatever the zoom of the page.
  #size(width, height) {
    const canvas = this.#canvas, pixels = [Math.round(width * scale()), Math.round(height * scale())];
    if (canvas.width !== pixels[0] || canvas.height !== pixels[1]) [canvas.width, canvas.height] = pixels;
  }

  #fail(sentence) {
    this.#around.failed(sentence);
    this.#breakReady(new Error(sentence));
  }

  // Text in and out of the program's memory.
  #call(name, types, values, returns = null) {
    if (!this.#program) throw new Error('The planet is still waking up; wait for its `ready` first.');
    return this.#program.ccall('terrella_' + name, returns, types, values);
  }
  #text(name, ...texts) { return this.#call(name, texts.map(() => 'string'), texts, 'string'); }
  #sentences(name, text) { return JSON.parse(this.#text(name, text)); }

  // Frames

  #wake() {
    if (this.#scheduled || this.#asleep || this.#unseen || !this.#program) return;
    this.#scheduled = true;
    requestAnimationFrame(now => this.#turn(now));
  }

  #turn(now) {
    this.#scheduled = false;
    if (!this.#canDraw() || this.#asleep || this.#unseen) return;
    const result = this.#program._terrella_frame(now / 1000);
    if (result < 1) {
      this.#around.progressed(0.3 + 0.7 * result);
      setTimeout(() => this.#wake(), 15);  // not at the next frame: there is nothing to paint, and the driver is busy
      return;
    }
    this.#screenKeys.follow();
    const [drawn, again, whole, bare] = [1, 2, 4, 8].map(bit => ((result - 1) & bit) !== 0);
    if (drawn && !bare) this.#around.shown();
    if (whole && !this.#realSize) this.#keepReady();
    if (again) this.#wake();
  }

  // Whatever lies on the GPU is made here: at first, and again when a context that was lost has come back, even one that
  // was lost before there was a program.
  #begin() {
    if (!this.#program || !this.#canDraw()) return;
    this.#begun = true;
    this.fit();
    if (!this.#program._terrella_start()) {
      return this.#fail('Terrella draws into float textures, which this graphics driver does not offer.');
    }
    this.#wake();
  }

  // The context may be gone before its event has told so.
  #canDraw() { return !this.#lost && !this.#context?.isContextLost(); }

  #watchContext() {
    this.#canvas.addEventListener('webglcontextlost', event => {
      event.preventDefault();
      this.#lost = true;
      this.#program?._terrella_context_lost();
      // Wanted again before the loss was told, when it could not be restored yet.
      if (!this.#asleep) setTimeout(() => { if (this.#lost && !this.#asleep) this.#loser?.restoreContext(); });
    });
    this.#canvas.addEventListener('webglcontextrestored', () => {
      this.#lost = false;
      this.#loser = null;
      if (this.#asleep) this.sleep();
      else this.#begin();
    });
  }

  // For those who do not see it. Not at every step of a hand: a screen reader would read each aloud.
  #describe() { this.#canvas.setAttribute('aria-label', this.#text('description')); }
  #sceneChanged() {
    for (const listener of this.#listeners.change) listener();
    clearTimeout(this.#describing);
    this.#describing = setTimeout(() => this.#describe(), 300);
  }

  // Files

  #listenToDrops() {
    this.#canvas.addEventListener('dragover', event => event.preventDefault());
    this.#canvas.addEventListener('drop', async event => {
      event.preventDefault();
      const file = event.dataTransfer.files[0];
      if (file) this.#loadFile(file);
    });
  }

  async #loadFile(file) {
    if (isPFM(file) || file.type.startsWith('image/')) await this.#loadMap(file);
    else this.#note(this.#sentences('load_json', await file.text()));
    this.#wake();
  }
  async #loadMap(file) {
    try {
      giveMap(this.#program, await readMap(file), true);
      this.#maps = [...this.#maps.filter(known => known.name !== file.name), file].slice(-4);
    } catch (error) {
      this.#note([error.message]);
    }
  }
  #note(sentences) { for (const sentence of sentences) this.#call('add_notice', ['string'], [sentence]); }

  // What the program asks of its surroundings (web/main.cpp).
  #host() {
    return {
      canvas: this.#canvas,
      onSceneChanged: () => this.#sceneChanged(),
      onCopyText: text => this.#copy(text.startsWith('{') ? text : this.api.link()),
      onCopyTyped: text => this.#copy(text),
      onSaveJson: text => save(new Blob([text], { type: 'application/json' }), 'planet.json'),
      onOpenJson: () => {
        const input = document.createElement('input');
        input.type = 'file';
        input.accept = '.json,application/json,image/png,.pfm';
        input.onchange = () => { if (input.files[0]) this.#loadFile(input.files[0]); };
        input.click();
      },
      // Not on an iPhone, nor in a frame that may not.
      onFillScreen: document.fullscreenEnabled && this.#canvas.requestFullscreen ? () => this.#fillScreen() : null,
      onWantRealSize: () => this.#wantRealSize(),
      onKeepHabits: text => this.#around.keepHabits(text),
      onSavePicture: wish => this.#screenshot(wish).then(blob => save(blob, 'planet.png')),
    };
  }

  async #copy(text) {
    if (await copied(text) || copiedByField(text, this.#canvas)) return;
    this.#program._terrella_copy_failed();
    this.#wake();
  }

  // Or back.
  #fillScreen() {
    const filled = this.#canvas.getRootNode().fullscreenElement === this.#canvas;
    (filled ? document.exitFullscreen() : this.#canvas.requestFullscreen()).catch(() => {});
  }

  async #screenshot({ width = this.#canvas.width, height = this.#canvas.height, transparent = false } = {}) {
    const most = this.#call('largest_picture', [], [], 'number');
    await this.#realSize;
    if (!this.#begun || !this.#canDraw() || this.#asleep) throw new Error('The planet has no graphics context at the moment, so that it cannot draw.');
    for (const side of [width, height]) {
      if (!Number.isInteger(side) || side < 1 || side > most) {
        throw new Error(`A screenshot's width and height are whole numbers, 1 to ${most}; ${side} is not.`);
      }
    }
    const at = this.#program._terrella_picture(width, height, transparent ? 1 : 0);
    const bytes = new Uint8ClampedArray(this.#program.HEAPU8.buffer, at, 4 * width * height).slice();
    const sheet = new OffscreenCanvas(width, height);
    sheet.getContext('2d').putImageData(new ImageData(bytes, width, height), 0, 0);
    this.#wake();
    return sheet.convertToBlob({ type: 'image/png' });
  }

  #offers(ready) {
    return {
      ready,
      get: path => {
        const text = this.#text('get', String(path));
        if (text === '') throw new Error(this.#text('no_such_parameter', String(path)));
        return JSON.parse(text);
      },
      set: (path, value) => {
        const sentence = this.#text('set', String(path), asText(value));
        if (sentence !== '') throw new Error(sentence);
        this.#wake();
      },
      scene: () => JSON.parse(this.#text('scene')),
      load: scene => {
        const sentences = typeof scene === 'string' ? this.#sentences('load_link', scene) : this.#sentences('load_json', JSON.stringify(scene));
        this.#wake();
        return sentences;
      },
      link: () => this.#around.linkTo(this.#text('link')),
      stats: () => JSON.parse(this.#text('stats')),
      screenshot: size => this.#screenshot(size),
      render: seconds => { if (this.#canDraw()) this.#call('render', ['number'], [seconds]); },
      on: (event, listener) => {
        const listeners = this.#listeners[event];
        if (!listeners) throw new Error(`There is no event "${event}"; there is change.`);
        listeners.add(listener);
        return () => listeners.delete(listener);
      },
    };
  }
}

// Browsers have no clipboard for pages that came over plain http, and may refuse it to others.
async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

// The old way, which needs a field to copy from.
function copiedByField(text, canvas) {
  const field = document.createElement('textarea');
  Object.assign(field.style, { position: 'fixed', opacity: '0' });
  field.value = text;
  canvas.after(field);
  field.select();
  const done = document.execCommand('copy');
  field.remove();
  canvas.focus({ preventScroll: true });
  return done;
}

// Maps of heights. What is wrong with one is an Error with a sentence.

const isPFM = file => /\.pfm$/i.test(file.name);

async function readMap(file) {
  if (!isPFM(file)) return readPicture(file);
  const bytes = new Uint8Array(await file.arrayBuffer());
  return { name: file.name, bytes, width: bytes.length, height: 0 };
}

// As the browser reads it: 8 bits, heights and no colours.
async function readPicture(file) {
  const asItStands = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' };
  const picture = await createImageBitmap(file, asItStands).catch(() => null);
  if (!picture) throw new Error(`${file.name}: is no picture that this browser can read.`);
  const { width, height } = picture;
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  const context = canvas.getContext('2d');
  context.drawImage(picture, 0, 0);
  return { name: file.name, bytes: context.getImageData(0, 0, width, height).data, width, height };
}

// atOnce: the scene takes it, else those do that name it.
function giveMap(program, { name, bytes, width, height }, atOnce) {
  const at = program._malloc(bytes.length);
  if (!at) throw new Error(`${name}: is larger than the memory of this page.`);
  program.HEAPU8.set(bytes, at);
  const sentence = program.ccall('terrella_take_map', 'string', ['string', 'number', 'number', 'number', 'number'], [name, at, width, height, atOnce ? 1 : 0]);
  program._free(at);
  if (sentence) throw new Error(sentence);
}

function save(blob, name) {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(blob);
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 10_000);
}

// Hands

const buttonOf = event => ({ 0: 0, 1: 2, 2: 1 })[event.button] ?? 0;

function listenToPointers({ canvas, call, wake }, screenKeys) {
  const fingers = new Map();
  const place = event => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const twoFingers = () => {
    const [[ax, ay], [bx, by]] = [...fingers.values()];
    const span = Math.max(1, Math.hypot(ax - bx, ay - by)), angle = Math.atan2(by - ay, bx - ax);
    return { x: (ax + bx) / 2, y: (ay + by) / 2, span, angle };
  };
  const moved = event => {
    const at = place(event);
    if (fingers.has(event.pointerId) && fingers.size === 2) {
      const before = twoFingers();
      fingers.set(event.pointerId, at);
      const after = twoFingers();
      const turned = after.angle - before.angle, twist = Math.atan2(Math.sin(turned), Math.cos(turned));
      call('pinch', after.span / before.span, twist, after.x - before.x, after.y - before.y, after.x, after.y);
    } else if (fingers.size < 2) {
      if (fingers.has(event.pointerId)) fingers.set(event.pointerId, at);
      else call('pointer_is_finger', 0);
      call('pointer_moved', ...at);
    }
  };
  const down = event => {
    // A frame around the planet is for who came by keys; browsers draw it as well after a call of focus.
    canvas.toggleAttribute('data-by-hand', true);
    // The mouse that browsers imitate after a finger would take the focus from the field of the keyboard on the screen.
    if (event.pointerType === 'touch') event.preventDefault();
    if (!screenKeys.shown) canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    const at = place(event);
    if (event.pointerType === 'touch') fingers.set(event.pointerId, at);
    if (fingers.size > 1) {
      call('pointer_left');  // the first finger presses nothing: it was the beginning of this
      call('pointer_button', 0, 0);
    } else {
      call('pointer_is_finger', event.pointerType === 'touch' ? 1 : 0);
      call('pointer_moved', ...at);
      call('pointer_button', buttonOf(event), 1);
    }
  };
  const up = event => {
    const wasPinch = fingers.size > 1;
    fingers.delete(event.pointerId);
    if (!wasPinch) call('pointer_button', buttonOf(event), 0);
    if (event.pointerType === 'touch') call('pointer_left');
    screenKeys.pressed(event);
  };
  const wheel = event => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? event.deltaY / 3 : event.deltaMode === 2 ? event.deltaY : event.deltaY / 100;
    call('wheel', -Math.max(-4, Math.min(4, lines)));
  };
  const on = (name, act, options) => canvas.addEventListener(name, event => { act(event); wake(); }, options);
  on('pointerdown', down);
  on('pointermove', moved);
  on('pointerup', up);
  on('pointercancel', up);
  on('pointerleave', () => call('pointer_left'));
  on('wheel', wheel, { passive: false });
  canvas.addEventListener('contextmenu', event => event.preventDefault());
}

// The keyboard on the screen of a device that has no other: browsers show it only for a field of their own. One that nobody
// sees stands where the finger was, and what is typed into it goes to the panel's field.
class ScreenKeys {
  // So that there is always something to delete.
  static #filler = '\u2007'.repeat(16);

  #hand;
  #field = document.createElement('input');
  #before = '';
  #byFinger = false;

  constructor(hand) {
    this.#hand = hand;
    const field = this.#field;
    Object.assign(field, { type: 'text', autocomplete: 'off', autocapitalize: 'off', spellcheck: false, tabIndex: -1, enterKeyHint: 'done' });
    field.setAttribute('aria-label', 'What is typed goes to the panel of the planet');
    // Letters of 16 pixels: a phone would zoom into smaller ones.
    Object.assign(field.style, { position: 'fixed', width: '1px', height: '1px', border: '0', padding: '0', opacity: '0', pointerEvents: 'none', fontSize: '16px' });
    listenToKeys(hand, field);
    field.addEventListener('input', () => this.#typed());
    field.addEventListener('paste', event => event.preventDefault());  // it goes to the panel by itself
  }

  get shown() { return this.#field.isConnected; }

  // The end of a press: the moment at which a browser lets a keyboard be shown.
  pressed(event) {
    this.#byFinger = event.pointerType === 'touch';
    if (!this.#byFinger) return;
    Object.assign(this.#field.style, { left: event.clientX + 'px', top: event.clientY + 'px' });
    if (this.#hand.call('wants_text')) this.#show();
  }

  // After a frame, in which the panel may have begun or ended to wait for text.
  follow() {
    const wanted = this.#byFinger && this.#hand.call('wants_text') === 1;
    if (wanted && !this.shown) this.#show();
    if (!wanted && this.shown) this.#hide();
  }

  #show() {
    if (!this.shown) this.#hand.canvas.after(this.#field);
    this.#empty();
    this.#field.blur();  // where its keyboard was sent away it comes again
    this.#field.focus({ preventScroll: true });
  }
  #hide() {
    const focused = this.#field.getRootNode().activeElement === this.#field;
    if (focused) this.#hand.canvas.focus({ preventScroll: true });
    this.#field.remove();
  }
  #empty() {
    this.#field.value = this.#before = ScreenKeys.#filler;
    this.#field.setSelectionRange(this.#before.length, this.#before.length);
  }

  // Keyboards that guess words change what they have written: what has gone is deleted, and what has come is typed.
  #typed() {
    const before = [...this.#before], now = [...this.#field.value];
    let same = 0;
    while (same < before.length && before[same] === now[same]) ++same;
    const backspace = keys.indexOf('Backspace'), { call, wake } = this.#hand;
    for (let i = same; i < before.length; ++i) for (const down of [1, 0]) call('key', backspace, down, 0, 0);
    for (const letter of now.slice(same)) call('text', letter.codePointAt(0));
    this.#before = this.#field.value;
    if (now.length < 4) this.#empty();
    wake();
  }
}

// element: the canvas, or what has the focus in its place.
function listenToKeys({ canvas, call, wake }, element) {
  const key = down => event => {
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    // On some keyboards digits are printed above what their keys write.
    const digit = /^Digit([123])$/.exec(event.code)?.[1];
    const index = Math.max(0, keys.indexOf(name === '=' ? '+' : digit ?? name));
    const control = event.ctrlKey || event.metaKey;
    const used = call('key', index, down ? 1 : 0, event.shiftKey ? 1 : 0, control ? 1 : 0);
    if (down && event.key.length === 1 && !control) call('text', event.key.codePointAt(0));
    // The browser would search, scroll or open a list of its own.
    const ours = control ? name === 'z' || name === 'y' : index > 0 || event.key.length === 1;
    if (ours && (used || event.key !== 'Tab')) event.preventDefault();
    wake();
  };
  element.addEventListener('keydown', key(true));
  element.addEventListener('keyup', key(false));
  // Where the focus has gone somebody else hears of the key that goes up.
  element.addEventListener('blur', () => { canvas.removeAttribute('data-by-hand'); call('keys_left'); wake(); });
}
