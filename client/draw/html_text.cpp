#include "client/draw/html_text.hpp"

namespace spoctree {

// The policy keeps a page from loading anything, whatever may be in it.
const char* const kHtmlHead = R"(<meta charset="utf-8"/>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
)";

const char* const kHtmlStyle = R"(
body { font: 15px/1.4 system-ui, sans-serif; color: #222; background: #f6f6f4; max-width: 70rem;
  margin: 0 auto; padding: 1rem 1.5rem; }
h1 { font-size: 1.3rem; overflow-wrap: anywhere; }
h2 { font-size: 1.05rem; margin: .5rem 0; }
.note { background: #fff0c8; padding: .4rem .7rem; border-radius: 4px; }
.controls { display: flex; gap: .8rem; align-items: center; }
.controls input { flex: 1; max-width: 40rem; accent-color: #26a; }
.controls button { min-width: 5rem; font: inherit; padding: .25rem .6rem; }
section { display: grid; grid-template-columns: minmax(0, 1fr) 17rem; gap: 0 1.5rem;
  margin-bottom: 1rem; }
section h2 { grid-column: 1 / 3; }
.paper { background: #fff; border: 1px solid #ccc; border-radius: 4px; padding: .5rem; }
.paper svg { display: block; width: 100%; height: auto; max-height: 60vh; }
dl { margin: 0; align-self: start; }
dt { color: #666; }
dd { margin: 0 0 .45rem; font-variant-numeric: tabular-nums; }
.chart { display: block; width: 100%; }
.chart rect { fill: #b8c4d0; }
.chart .bar { cursor: pointer; }
.chart .shown rect { fill: #26a; }
.chart text { font-size: 10px; text-anchor: middle; fill: #555; }
[hidden] { display: none !important; }
@media (max-width: 45rem) { section { grid-template-columns: 1fr; } section h2 { grid-column: 1; } }
)";

const char* const kHtmlControls = R"(<div class="controls" hidden="hidden">
<button type="button" id="play">Play</button>
<label for="slider">Level</label>
<input type="range" id="slider" min="0" step="1"/>
<output for="slider" id="shown"></output>
</div>
)";

const char* const kHtmlScript = R"((() => {
  "use strict";
  const sections = [...document.querySelectorAll("section")];
  const bars = [...document.querySelectorAll(".bar")];
  const slider = document.getElementById("slider");
  const button = document.getElementById("play");
  const output = document.getElementById("shown");
  const last = sections.length - 1;
  let shown = last;
  let timer = 0;
  const show = (index) => {
    shown = Math.max(0, Math.min(last, index));
    sections.forEach((section, k) => { section.hidden = k !== shown; });
    bars.forEach((bar, k) => { bar.classList.toggle("shown", k === shown); });
    slider.value = shown;
    slider.setAttribute("aria-valuetext", "level " + shown + " of " + last);
    output.textContent = shown + " of " + last;
  };
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    button.textContent = "Play";
  };
  const play = () => {
    if (timer) { stop(); return; }
    show(shown === last ? 0 : shown + 1);
    if (shown === last) return;
    button.textContent = "Pause";
    timer = setInterval(() => {
      show(shown + 1);
      if (shown === last) stop();
    }, 900);
  };
  slider.max = last;
  slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
  button.addEventListener("click", play);
  bars.forEach((bar, k) => bar.addEventListener("click", () => { stop(); show(k); }));
  const keys = { ArrowLeft: () => shown - 1, ArrowRight: () => shown + 1, Home: () => 0,
                 End: () => last };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === " " && event.target !== button) {
      event.preventDefault();
      play();
    } else if (keys[event.key] && event.target !== slider) {
      event.preventDefault();
      stop();
      show(keys[event.key]());
    }
  });
  document.querySelector(".controls").hidden = false;
  show(last);
})();
)";

}  // namespace spoctree
