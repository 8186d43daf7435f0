// What a planet offers: `window.terrella` of the page, and each <terrella-planet>.

/** The name of a parameter, "group.name": see the manual, or what `scene()` holds. */
export type Path = string;

/** A parameter's value. A colour is "#rrggbb" (sRGB), a choice its name. */
export type Value = number | boolean | string;

/** A scene as JSON: the version, a preset to start from, and the groups of what differs from it. Lengths are in metres,
 *  angles in degrees. */
export interface SceneJson {
  terrella: 1;
  preset?: string;
  [group: string]: { [name: string]: Value } | string | number | undefined;
}

export interface Decision {
  /** What was decided about: a slot, or a part of it. */
  what: string;
  /** The technique that was chosen. */
  chosen: string;
  /** The reason, in a sentence. */
  why: string;
}

export interface Stats {
  /** The graphics driver's name. */
  renderer: string;
  /** Width and height of the planet's picture, in pixels. */
  size: [number, number];
  /** Milliseconds from one frame to the next, over the last sixty: median, and the 10th and 90th of a hundred. */
  frame_ms: { median: number; p10: number; p90: number };
  /** The same from one picture on screen to the next: on slow machines one is drawn in several frames. */
  picture_ms: { median: number; p10: number; p90: number };
  /** Milliseconds from the program's start until its first frame. */
  first_frame_ms: number;
  /** Pictures shown since the program's start: planets of real size have one of their own. */
  frames: number;
  /** Frames that a picture is drawn in while nothing but time goes on; 1 where it is drawn and shown in one. */
  bands: number;
  /** Triangles of the last picture. */
  triangles: number;
  /** Draw calls of the last picture. */
  draw_calls: number;
  /** Evaluations of noise for the last picture, at the most. */
  noise_evaluations: number;
  /** Bytes of graphics memory in use. */
  gpu_bytes: number;
  /** Names of the GPU programs in use. */
  programs: string[];
  /** How many textures are in use. */
  textures: number;
  /** The technique in each slot. */
  slots: { ground: string; water: string; clouds: string; air: string; stars: string };
  /** What is modelled, how finely and why. */
  needs: Decision[];
  /** Pixels without a number, counted in stills of the desktop program only; else 0. */
  nonfinite_pixels: number;
  /** The sentences about what was refused or skipped, the latest last. */
  issues: string[];
}

export interface PictureOptions {
  /** In pixels; the canvas's width where it is left out. */
  width?: number;
  /** In pixels; the canvas's height where it is left out. */
  height?: number;
  /** Whether to draw the planet alone, with opacity: no stars, no sun. */
  transparent?: boolean;
}

export interface Planet {
  /** Kept when the first full frame is on screen, of a planet of real size as such; broken with a sentence where there can
   *  be none. All below but `on`
   *  throws an Error before there is a program, which is some time before. */
  readonly ready: Promise<void>;

  /** A parameter's value, in the unit of the manual: metres, degrees, degrees or radians or metres a second, or a plain
   *  number. Throws an Error where there is no such parameter. */
  get(path: Path): Value;
  /** Sets a parameter, in the same unit. Throws an Error with a sentence for a bad value and changes nothing. */
  set(path: Path, value: Value): void;

  /** The whole scene; `load` takes it back value for value. */
  scene(): SceneJson;
  /** Takes a scene, or a link or its query ("preset=storm&waves.count=8"). Returns the sentences for what it skipped. */
  load(scene: SceneJson | string): string[];
  /** The link of the scene as it stands; of an element the link's query, "?preset=storm". */
  link(): string;

  stats(): Stats;

  /** A PNG of the planet alone, of any size that the machine can draw, once the program is here that draws planets of
   *  real size where the scene is of one. Breaks with a sentence where it cannot. */
  screenshot(options?: PictureOptions): Promise<Blob>;
  /** Draws one frame as it is so many seconds after the scene began, and returns when the GPU has finished it. */
  render(seconds: number): void;

  /** Calls the listener after each change of the scene. Returns what ends this. */
  on(event: 'change', listener: () => void): () => void;
}

/** <terrella-planet>. Attributes: `preset`, `scene` (a link or its query), `panel` ("0": no panel), `pause` ("1": the clock
 *  stands, "0": it runs even for who wants less motion). Dispatches `change` as well. */
export class TerrellaPlanet extends HTMLElement implements Planet {
  readonly ready: Promise<void>;
  get(path: Path): Value;
  set(path: Path, value: Value): void;
  scene(): SceneJson;
  load(scene: SceneJson | string): string[];
  link(): string;
  stats(): Stats;
  screenshot(options?: PictureOptions): Promise<Blob>;
  render(seconds: number): void;
  on(event: 'change', listener: () => void): () => void;
}

declare global {
  interface HTMLElementTagNameMap {
    'terrella-planet': TerrellaPlanet;
  }
  interface Window {
    /** On the page of Terrella itself. */
    terrella?: Planet;
  }
}
