// Files dropped on a picture: models, with the files that they name, and environments. They never leave the page.

const MODEL = /\.(glb|gltf|obj|ply|stl)$/i;
const NAMES_OTHERS = /\.(gltf|obj)$/i;
const ENVIRONMENT = /\.(hdr|exr|png|jpe?g|ktx2?|dds)$/i;
const NO_TEXTURE = /\.(hdr|exr)$/i; // beside a model that names others, the rest may be its own

/** `take(kind, files)` is called for what is dropped on `view`; kind is "model" or "environment". */
export function acceptDrops(view, take) {
  const mark = (over) => view.classList.toggle("drop", over);
  view.addEventListener("dragover", (event) => {
    event.preventDefault();
    mark(true);
  });
  view.addEventListener("dragleave", () => mark(false));
  view.addEventListener("drop", (event) => {
    event.preventDefault();
    mark(false);
    takeAll(event.dataTransfer.files, take);
  });
}

/** A model that names other files comes with all that lie beside it. */
export async function takeAll(files, take) {
  const all = [...files];
  const model = all.find(({ name }) => NAMES_OTHERS.test(name)) ?? all.find(({ name }) => MODEL.test(name)) ?? all.find(({ name }) => !ENVIRONMENT.test(name));
  const set = model && NAMES_OTHERS.test(model.name);
  const environment = all.find(({ name }) => (set ? NO_TEXTURE : ENVIRONMENT).test(name));
  if (model) await take("model", set ? [model, ...all.filter((file) => file !== model && file !== environment)] : [model]);
  if (environment) await take("environment", [environment]);
}
