// The example page: every picture takes dropped files.
import { acceptDrops } from "./drops.js";

for (const view of document.querySelectorAll("tukor-view"))
  acceptDrops(view, (kind, files) => (kind === "environment" ? view.loadEnvironmentFile(...files) : view.loadModelFile(...files)));
