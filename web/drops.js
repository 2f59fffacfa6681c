// Files dropped on a picture: models and environments. They never leave the page.

const isEnvironment = ({ name }) => /\.(hdr|exr|png|jpe?g)$/i.test(name);

/** `take(file, kind)` is called for every file dropped on `view`; kind is "model" or "environment". */
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

export function takeAll(files, take) {
  for (const file of files) take(file, isEnvironment(file) ? "environment" : "model");
}
