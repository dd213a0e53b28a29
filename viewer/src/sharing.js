// What can be taken from a page: its link, the code that embeds it, its spec, a picture, a film.
import { canFilm, Film } from "./film.js";
import { worded } from "./numbers.js";
import { decimal, say } from "./say.js";

const HEIGHT = 760; // pixels of an embedded frame: picture, controls and time bar stand in it without scrolling
const [SHORTEST, USUAL, LONGEST] = [0.5, 10, 60]; // s that a film takes to watch
const element = (id) => document.getElementById(id);

export class Sharing {
  /**
   * @param page with address, timebar, instrument, motion, and `shot(into)`, which returns the large picture on its ground
   */
  constructor(page) {
    this.page = page;
    const on = (id, act) => element(id).addEventListener("click", act);
    on("link", () => this.copyLink());
    on("embed", () => this.copyEmbedCode());
    on("spec", () => this.copySpec());
    on("picture", () => this.savePicture());
    on("film", () => (this.film ? this.film.stop() : this.saveFilm()));
    element("film-length").addEventListener("change", () => this.check());
  }

  /** Forget what was said of the motion before, and offer a film of one period of this one. */
  take() {
    element("spec").hidden = !this.page.instrument?.kind.toml;
    for (const id of ["copied", "saved"]) element(id).hidden = true;
    this.say("");
    this.given = null;
    this.suggest();
  }

  say(words, values) {
    element("shared").textContent = say(words, values);
  }

  /** Put a text where it can be copied from by hand, and into the clipboard where the browser allows it. */
  async copy(text, copied) {
    const place = element("copied");
    place.value = text;
    place.hidden = false;
    try {
      await navigator.clipboard.writeText(text);
      this.say(copied);
    } catch {
      this.say("This browser keeps the clipboard from pages in frames: copy the text from the field below.");
      place.select();
    }
  }

  copyLink() {
    const { whole, fragment } = this.page.address;
    if (whole === null) return this.copy(`#${fragment}`, "A page in a notebook has no address of its own. Write it to a file with write_page, and add this to the file's address.");
    return this.copy(whole, whole.startsWith("file:") ? "The link is copied. It opens on this computer only: put the file on a web server to give it to others." : "The link is copied.");
  }

  copyEmbedCode() {
    const { whole } = this.page.address;
    if (whole === null) return this.say("A page in a notebook has no address that another page could embed. Write it to a file with write_page, and put the file on a web server.");
    const name = `polhode: ${element("name").textContent}`;
    const [source, title] = [whole, name].map((text) => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;"));
    const code = `<iframe src="${source}" title="${title}" loading="lazy" sandbox="allow-scripts allow-downloads" allow="clipboard-write" style="width:100%; height:${HEIGHT}px; border:0"></iframe>`;
    return this.copy(code, "The code is copied: paste it into the HTML of a page.");
  }

  copySpec() {
    const text = this.page.instrument.toml(this.page.motion.span);
    if (text === null) return this.say("No spec says this start. A gyrostat needs its rotor's moment, and a free rotor a principal axis; a disk must begin in steady rolling.");
    return this.copy(text, "The spec is copied: paste it into a file, and run polhode report on it.");
  }

  savePicture() {
    const shot = this.page.shot();
    if (isKept()) {
      const place = element("saved");
      place.src = shot.toDataURL("image/png");
      place.hidden = false;
      return this.say("A frame like this one may not save files: save the picture below by a right click, or by a long press.");
    }
    shot.toBlob((blob) => this.save(blob, "png"), "image/png");
    return this.say("The picture is saved.");
  }

  /** Record the large picture while the motion plays, from the time that is shown. */
  saveFilm() {
    if (!canFilm()) return this.say("This browser cannot record films: it has no MediaRecorder for canvases. Firefox and Chromium have.");
    const seconds = this.check();
    if (seconds === null) return undefined;
    const { timebar } = this.page;
    const played = timebar.playing;
    const told = () => this.say("Recording: {passed} of {seconds} s.", { passed: decimal(Math.min(this.film.passed, seconds).toFixed(1)), seconds: worded(seconds, 3) });
    const telling = setInterval(told, 200);
    this.film = new Film(this.page.shot(), seconds, (blob, kind) => {
      clearInterval(telling);
      this.film = null;
      element("film").textContent = say("Save film");
      if (!played) timebar.pause();
      if (blob) this.save(blob, kind);
      this.say(!blob ? "The browser has recorded nothing." : isKept() ? "The film is recorded. If it was not saved, this frame may not save files: open the page on its own." : "The film is saved.");
    });
    element("film").textContent = say("Stop");
    if (!played) timebar.toggle();
    return told();
  }

  /** Paint the film's next picture. */
  frame() {
    this.film?.paint((into) => this.page.shot(into));
  }

  /** Offer the time that one period takes to watch at this speed, unless a length was typed. */
  suggest() {
    if (this.given !== null) return;
    const { instrument, motion, timebar } = this.page;
    const { period = null, nutationPeriod = null } = motion?.solver ?? {};
    const finite = [period, nutationPeriod, instrument?.event ?? null].find((time) => time !== null && Number.isFinite(time) && time > 0);
    const seconds = (finite ?? motion?.span ?? 0) / timebar.rate;
    const length = seconds > 0 && Number.isFinite(seconds) ? Math.min(LONGEST, Math.max(SHORTEST, seconds)) : USUAL;
    element("film-length").value = decimal(String(Number(length.toFixed(1))));
  }

  /** Return the film's length that stands in the field [s]; null, and why, of one that is none. */
  check() {
    const field = element("film-length");
    const seconds = Number(field.value.trim().replace(",", "."));
    const fits = field.value.trim() !== "" && seconds >= SHORTEST && seconds <= LONGEST;
    field.setAttribute("aria-invalid", String(!fits));
    const got = field.value.trim() || say("nothing");
    this.say(fits ? "" : "A film takes {least} to {most} s; got {got}. Type a number between these.", { least: SHORTEST, most: LONGEST, got });
    this.given = fits ? seconds : this.given;
    return fits ? seconds : null;
  }

  save(blob, kind) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `${element("name").textContent.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-+|-+$/g, "") || "motion"}.${kind}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }
}

/** Whether the page stands in a frame that keeps it from everything of its own, and so most likely from saving files. */
function isKept() {
  try {
    return window.self !== window.top && !window.localStorage;
  } catch {
    return true;
  }
}
