// From the data in the page to its panels, and from each change of time, view or colours to a new picture.
import { View } from "./camera.js";
import { Motion } from "./motion.js";
import { axisPanel } from "./panels/axis.js";
import { bodyPanel } from "./panels/body.js";
import { poinsotPanel } from "./panels/poinsot.js";
import { spherePanel } from "./panels/sphere.js";
import { Readouts } from "./readouts.js";
import { dispose } from "./shapes.js";
import { Stage } from "./stage.js";
import { THEMES } from "./theme.js";
import { Timebar } from "./timebar.js";
import * as tools from "./tools.js";

// pictures that fit any body, and those that scripts before this one have brought
const MAKERS = { axis: axisPanel, body: bodyPanel, poinsot: poinsotPanel, sphere: spherePanel, ...globalThis.polhodePanels };
const element = (id) => document.getElementById(id);

function start() {
  const data = JSON.parse(element("motion").textContent);
  const motion = new Motion(data);
  write(data);
  const view = new View(() => draw());
  view.elevation = data.panels[0].elevation ?? view.elevation;
  const stage = new Stage(view);
  const canvases = data.panels.map((panel) => addFrame(panel, view));
  const readouts = new Readouts(element("readouts"), motion, data);
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  let theme = system.matches ? THEMES.dark : THEMES.light;
  let panels = [];
  let now = motion.at(0);
  const sizes = () => canvases.map((canvas) => `${canvas.clientWidth} ${canvas.clientHeight}`).join();
  let shapes = "";
  let waiting = null;

  function build() {
    for (const panel of panels) dispose(panel.scene);
    document.documentElement.dataset.theme = theme.name;
    panels = data.panels.map((panel) => Object.assign(MAKERS[panel.type](motion, panel, theme, tools), { type: panel.type }));
    panels.forEach((panel, k) => caption(canvases[k], panel, data));
    draw();
  }

  /** Draw all panels once before the next frame is shown; nothing is drawn while nothing changes. */
  function draw() {
    waiting ??= requestAnimationFrame(drawNow);
  }

  function drawNow() {
    cancelAnimationFrame(waiting);
    waiting = null;
    shapes = sizes();
    for (const panel of panels) panel.update(now);
    stage.draw(panels, canvases, theme);
    readouts.show(now);
    window.polhode.drawn += 1;
    window.polhode.firstPicture ??= performance.now();
  }

  const timebar = new Timebar(element("timebar"), motion, {
    seek: (position) => {
      now = motion.at(position);
      draw();
    },
  });
  const change = () => {
    theme = theme === THEMES.dark ? THEMES.light : THEMES.dark;
    build();
  };
  element("theme").addEventListener("click", change);
  // a button that was pressed by hand gives the keys back to the time bar; one reached by key keeps them
  for (const button of document.querySelectorAll("button")) button.addEventListener("pointerup", () => button.blur());
  system.addEventListener("change", (event) => {
    theme = event.matches ? THEMES.dark : THEMES.light;
    build();
  });
  new ResizeObserver(() => sizes() !== shapes && draw()).observe(element("panels"));
  window.polhode = probe(motion, timebar, view, () => panels, () => ({ theme: theme.name, position: now.position }), drawNow);
  window.seek = (index) => window.polhode.seek(index);
  build();
  timebar.go(0);
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!calm && motion.count > 1 && motion.span > 0) requestAnimationFrame(() => timebar.toggle());
}

/** Put the words of the page in their places, as text and never as markup. */
function write(data) {
  element("name").textContent = data.name;
  element("summary").textContent = data.summary;
  for (const note of data.notes) {
    const line = document.createElement("li");
    line.textContent = note;
    element("notes").append(line);
  }
}

function addFrame(panel, view) {
  const frame = document.createElement("figure");
  frame.className = panel.flat ? "panel flat" : "panel";
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  if (!panel.flat) {
    canvas.tabIndex = 0;
    view.listen(canvas);
    canvas.addEventListener("keydown", (event) => {
      if (view.key(event.key)) event.preventDefault();
    });
  }
  frame.append(canvas, document.createElement("figcaption"));
  element("panels").append(frame);
  return canvas;
}

function caption(canvas, panel, data) {
  const place = canvas.nextElementSibling;
  const title = document.createElement("strong");
  title.textContent = panel.title;
  const words = document.createElement("span");
  words.className = "words";
  words.textContent = [panel.words, panel.title === "The body in space" && data.up === "L" ? "L points up" : ""].filter(Boolean).join("; ");
  const legend = document.createElement("span");
  legend.className = "legend";
  for (const { color, text } of panel.legend) {
    const [item, swatch] = [document.createElement("span"), document.createElement("i")];
    swatch.style.background = color;
    item.append(swatch, text);
    legend.append(item);
  }
  place.replaceChildren(title, words, legend);
  const turns = panel.flat ? "." : ". Arrow keys turn the view, page up and down bring it closer.";
  canvas.setAttribute("aria-label", [panel.title, panel.words].filter(Boolean).join(": ") + turns);
}

/** What tests and the curious read: where things are in the scenes that are drawn. */
function probe(motion, timebar, view, panels, state, drawNow) {
  return {
    count: motion.count,
    times: motion.times,
    drawn: 0,
    firstPicture: null,
    view,
    state,
    seek(index) {
      timebar.to(index);
      drawNow();
    },
    get playing() {
      return timebar.playing;
    },
    /** Return what a panel of a type draws, or only the parts of that name. */
    measure(type, ...names) {
      const found = panels().find((panel) => panel.type === type)?.probe();
      return found && names.length ? Object.fromEntries(names.map((name) => [name, found[name]])) : found;
    },
  };
}

try {
  start();
} catch (error) {
  const words = element("failure");
  words.hidden = false;
  words.textContent = `The pictures cannot be drawn (${error.message}). They need a browser with WebGL 2.`;
  throw error;
}
