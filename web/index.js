// The example page: every picture takes dropped files.
import { acceptDrops } from "./drops.js";

for (const view of document.querySelectorAll("tukor-view"))
  acceptDrops(view, (file, kind) => (kind === "environment" ? view.loadEnvironmentFile(file) : view.loadModelFile(file)));
