// How the element looks around its picture. A constructed sheet needs no 'unsafe-inline' in style-src.
const text = `
:host { display: block; position: relative; width: 300px; height: 150px; contain: strict; }
:host([hidden]) { display: none; }
canvas { width: 100%; height: 100%; display: block; outline: none; touch-action: none; }
:host(:not([camera-controls])) canvas { touch-action: auto; }
canvas:focus-visible { outline: 3px solid #2f7cf6; outline-offset: -3px; }
.poster { position: absolute; inset: 0; background: center / contain no-repeat; pointer-events: none; }
.poster[hidden], .bar[hidden], .message[hidden] { display: none; }
.bar { position: absolute; left: 0; bottom: 0; width: 100%; height: 4px; appearance: none; border: 0; background: #0003; }
.bar::-webkit-progress-bar { background: transparent; }
.bar::-webkit-progress-value { background: #2f7cf6; }
.bar::-moz-progress-bar { background: #2f7cf6; }
.message { position: absolute; inset: auto 0 0 0; margin: 0; padding: 0.6em 1em; font: 14px/1.4 system-ui, sans-serif; color: #fff; background: #8b1a1a; }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`;

let sheet;

export function styleSheet() {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(text.replace(/\n/g, ""));
  }
  return sheet;
}
