// OpenEXR for the browser, every compression: hdrify (MIT), bundled on its own so that only an .exr fetches it.
export { readExr } from "hdrify";
