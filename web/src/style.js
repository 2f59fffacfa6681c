// How the element looks around its picture. A constructed sheet needs no 'unsafe-inline' in style-src; without spaces, for every page fetches it.
const text = `
:host{display:block;position:relative;width:300px;height:150px;contain:strict}
:host([hidden]){display:none}
:host([camera-controls]) canvas{touch-action:pan-y}
*{position:absolute;inset:auto 0 0;width:100%;box-sizing:border-box;margin:0}
canvas,.poster{height:100%}
canvas:focus-visible{outline:3px solid #2f7cf6;outline-offset:-3px}
.poster{background:center/contain no-repeat;pointer-events:none}
progress{height:4px;appearance:none;border:0;background:#0003}
::-webkit-progress-bar{background:none}
::-webkit-progress-value{background:#2f7cf6}
::-moz-progress-bar{background:#2f7cf6}
p{padding:0.6em 1em;font:14px/1.4 system-ui,sans-serif;white-space:pre-line;color:#fff;background:#8b1a1a}
[role=status]{clip-path:inset(50%)}`;

export const sheet = new CSSStyleSheet();
sheet.replaceSync(text);
