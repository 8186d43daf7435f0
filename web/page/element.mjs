// <terrella-planet>: a planet for any page, with all that window.terrella has. README.md of the package tells its attributes.
import { Planet } from './planet.mjs';

// A sheet that is constructed: the security policies that forbid a page's own <style> allow it.
const style = new CSSStyleSheet();
style.replaceSync(`
  :host { display: block; position: relative; aspect-ratio: 16 / 9; overflow: hidden; background: #05060a; color: #e8ecf4; touch-action: none; }
  :host([hidden]) { display: none; }
  canvas { position: absolute; inset: 0; width: 100%; height: 100%; outline: none; touch-action: inherit; -webkit-user-select: none; user-select: none; -webkit-touch-callout: none; -webkit-tap-highlight-color: transparent; cursor: grab; }
  canvas:active { cursor: grabbing; }
  canvas:focus-visible:not([data-by-hand]) { outline: 2px solid #6aa9ff; outline-offset: -2px; }
  p { position: absolute; inset: 0; display: grid; place-content: center; margin: 1.5rem; text-align: center; font: 16px/1.5 system-ui, sans-serif; }
  p[hidden] { display: none; }
`);

// What follows the question mark of a link, or a query as it is.
function queryOf(link) {
  const question = link.indexOf('?');
  if (question < 0) return link.includes('://') ? '' : link;
  return link.slice(question + 1).replace(/#.*/, '');
}

export class TerrellaPlanet extends HTMLElement {
  static observedAttributes = ['preset', 'scene', 'panel', 'pause'];

  #canvas = document.createElement('canvas');
  #message = document.createElement('p');
  #planet;
  #begun = false;
  #around;  // ends what listens outside of the element while it is in a document

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open', delegatesFocus: true });
    root.adoptedStyleSheets = [style];
    this.#canvas.tabIndex = 0;
    this.#canvas.setAttribute('role', 'img');
    this.#canvas.setAttribute('aria-label', 'A procedural planet');
    this.#message.hidden = true;
    this.#message.setAttribute('role', 'status');
    root.append(this.#canvas, this.#message);
    this.#planet = new Planet(this.#canvas, {
      query: () => this.#query(),
      failed: sentence => {
        this.#message.textContent = sentence;
        this.#message.hidden = false;
      },
    });
    Object.assign(this, this.#planet.api);
    this.on('change', () => this.dispatchEvent(new Event('change')));
    this.#watchSight();
  }

  // Not before it is ready, which others may wait for.
  #watchSight() {
    const watcher = new IntersectionObserver(entries => this.#planet.setSeen(entries.at(-1).isIntersecting));
    this.ready.then(() => watcher.observe(this), () => {});
  }

  connectedCallback() {
    this.#listen();
    if (this.#begun) return this.#planet.rouse();
    this.#begun = true;
    this.#planet.start();
  }

  disconnectedCallback() {
    this.#around.abort();
    // An element that is moved is taken out and put back at once.
    queueMicrotask(() => { if (!this.isConnected) this.#planet.sleep(); });
  }

  attributeChangedCallback(name) {
    if (name === 'panel') this.#planet.showPanel();
    else if (name === 'pause') this.#planet.setClock();
    else this.#planet.loadQuery();
  }

  // Browsers give what is pasted to the document. It is for the planet that has the focus.
  #listen() {
    this.#around = new AbortController();
    const signal = this.#around.signal;
    document.addEventListener('paste', event => {
      if (this.shadowRoot.activeElement) this.#planet.paste(event.clipboardData.getData('text'));
    }, { signal });
    addEventListener('resize', () => this.#planet.fit(), { signal });
  }

  // The scene's link, in which the other attributes have the last word.
  #query() {
    const query = new URLSearchParams(queryOf(this.getAttribute('scene') ?? ''));
    for (const key of ['preset', 'panel', 'pause']) if (this.hasAttribute(key)) query.set(key, this.getAttribute(key));
    return query.toString();
  }
}

if (!customElements.get('terrella-planet')) customElements.define('terrella-planet', TerrellaPlanet);
