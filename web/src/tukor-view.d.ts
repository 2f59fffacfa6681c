// Types of <tukor-view>. Attributes are properties too, in camel case; values are the attribute's text.

export interface TukorViewEventMap {
  /** Fraction of loading that is done, in [0, 1]. */
  progress: CustomEvent<{ totalProgress: number }>;
  /** Model and environment are there and have been drawn. */
  load: CustomEvent<{ url: string | null }>;
  /** Something could not be loaded or understood; the picture before stays, and the message until it is corrected. */
  error: CustomEvent<{ message: string; sourceError: Error }>;
  "camera-change": CustomEvent<{ source: "user-interaction" | "none" }>;
  play: CustomEvent<undefined>;
  pause: CustomEvent<undefined>;
  /** A frame was drawn; `samples` a pixel are accumulated at rest. */
  frame: CustomEvent<{ samples: number; moving: boolean }>;
}

export interface StillOptions {
  /** Pixels; the size of the element unless given. */
  width?: number;
  height?: number;
  /** A pixel; 64 unless given. */
  samples?: number;
}

export declare class TukorView extends HTMLElement {
  /** URL of a .glb, .gltf, .obj, .ply or .stl, or a built-in shape: sphere, torus-knot, teapot, brilliant, tumbler, water, wine-glass, cube. */
  src: string | null;
  /** URL of an .hdr, .exr, .png, .jpg, .ktx2, .ktx or .dds, or a built-in: studio (also where none is given, or nothing can be loaded), sky. */
  environment: string | null;
  /** About +Y, "30deg". */
  environmentRotation: string | null;
  environmentIntensity: string | null;
  /** "X,Y,Z" or "X,Y,Z/R,G,B", several separated by semicolons: from where light shines besides, on rough, diffuse and textured surfaces. */
  light: string | null;
  /** A height in metres, or "lowest" for the lowest point of the model: shadows and caustics on what is behind, at double and exact. */
  ground: string | null;
  /** quad, box, dome or none (transparent). */
  background: string | null;
  /** From 0, sharp, to 1. What lies behind the model alone; what is seen in it stays sharp. */
  backgroundBlur: string | null;
  /** "gold", or "Stone=diamond; Band=gold" by part or material name, or figures: "ior:1.2". */
  material: string | null;
  /** Factor on the dispersion of clear materials, 1 as measured; without it named ones have none and those of the model what it says. */
  dispersion: string | null;
  /** One of the model's own looks (KHR_materials_variants), by name. */
  variant: string | null;
  /** One of the model's animations, by name, or else by number from 0; the first unless given. */
  animation: string | null;
  /** Plays it once it is there, but not for those who ask for less motion. */
  autoplay: boolean;
  /** A moment of the animation; as modelled unless given. */
  timeSeconds: string | null;
  /** single, double or exact. */
  fidelity: string | null;
  /** exact or schlick. */
  fresnel: string | null;
  /** Events along one branch of the light path, 1 to 64; 64 unless given. */
  maxDepth: string | null;
  /** Stops. */
  exposure: string | null;
  /** none, reinhard, aces, agx or neutral. */
  toneMap: string | null;
  /** "30deg 75deg 4m", each part may be auto, the last, which is above 0, a percentage of the framing distance. */
  cameraOrbit: string | null;
  cameraTarget: string | null;
  /** Vertical, "40deg". */
  fieldOfView: string | null;
  autoRotate: boolean;
  /** Mouse, touch and keyboard steer; a finger moving up or down first scrolls the page. */
  cameraControls: boolean;
  alt: string | null;
  poster: string | null;
  loading: "auto" | "lazy" | "eager" | null;
  reveal: "auto" | "manual" | null;

  readonly loaded: boolean;
  readonly accumulatedSamples: number;
  readonly parts: { name: string; material: string }[];
  /** The `tukor render` command for the present view. */
  readonly command: string;

  readonly availableAnimations: string[];
  /** Of the animation, in seconds; 0 where there is none. */
  readonly duration: number;
  readonly paused: boolean;
  currentTime: number;

  /** Round and round, from the present moment on. */
  play(): void;
  pause(): void;
  jumpCameraToGoal(): void;
  getCameraOrbit(): { theta: number; phi: number; radius: number; toString(): string };
  getCameraTarget(): { x: number; y: number; z: number; toString(): string };
  dismissPoster(): void;
  partAtPoint(clientX: number, clientY: number): Promise<string | null>;
  warnings(): Promise<string[]>;
  render(options?: StillOptions): Promise<ImageData>;
  toBlob(options?: StillOptions & { mimeType?: string; qualityArgument?: number }): Promise<Blob>;
  toDataURL(mimeType?: string, qualityArgument?: number): Promise<string>;
  /** A model, and the files that it names: buffers and textures of a .gltf, the .mtl of an .obj. */
  loadModelFile(file: File, ...named: File[]): Promise<void>;
  loadEnvironmentFile(file: File): Promise<void>;

  addEventListener<K extends keyof TukorViewEventMap>(type: K, listener: (this: TukorView, event: TukorViewEventMap[K]) => unknown, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "tukor-view": TukorView;
  }
}
