// The tap: microphone or sound files, which taps can be used and why not, the spectrum with the tones that are expected.

import { Chart } from "../charts/chart.js";
import { button } from "../controls/controls.js";
import { keep, kept } from "../shell/kept.js";
import { Lights } from "../controls/lights.js";
import { Listening } from "../controls/listening.js";
import { make, showWords, tableOf } from "../controls/parts.js";
import { upload, whereTo } from "../controls/upload.js";
/** @import { HeardTaps, OwnAnswer, TapSpectrum } from "../answers.js" */
/** @import { AppOf, State } from "../shell/main.js" */

export const SOUNDS = [".wav", ".flac", ".ogg", ".mp3", ".aiff", ".m4a", ".aac", ".mp4", ".mov", ".3gp", ".amr", ".wma", ".webm"];
const TAPS = "taps";
const GONE = "The recordings are not on the server any more; what was heard in them still counts. Tap again for more.";
const LARGEST = 60e6; // bytes of a sound
const LIVE = 100; // ms between two pictures of what is heard now
const SPECTRUM = [{ title: "What rings, dB below the loudest", kind: "count", height: 150, empty: [-60, 0], lines: [{ key: "level", label: "the last good tap", color: "blue", width: 1.4 }] }];
const WAVE = [{ title: "The last recording, full scale 1", kind: "ratio", height: 70, empty: [-1, 1], lines: [{ key: "high", label: "", color: "blue", width: 1 }, { key: "low", label: "", color: "blue", width: 1, silent: true }] }];
const ROOM = "room’s?: a tone that the room may have added, or the same mode in another plane. Such a tone holds less energy than another within 10 % of it, or less than a thousandth of the greatest.";
/** @type {{ recordings: string[], found: HeardTaps | null, of: string | null, expected: string }} of: which implement; expected: its tones when they were named */
const heard = { recordings: kept(TAPS, []), found: null, of: null, expected: "" }; // as long as the page is open; where sounds lie, as long as the tab

export class TapPlace {
  /** @param {AppOf<"own">} app */
  constructor(app) {
    this.app = app;
    this.signal = app.signal;
    this.asking = false;
    this.more = false;
    this.reloaded = heard.recordings.length > 0 && !heard.found;
    /** @type {string[]} */
    this.refused = []; // why of the sounds handed in last some are not among the recordings
    this.ear = new Listening({
      onLevel: (part) => (this.level.value = Math.min(1, part)),
      onTap: (file) => this.add([file]),
      onDoubt: (words) => this.say(words),
      onEnd: () => this.heard(),
    });
    app.signal.addEventListener("abort", () => this.ear.stop());
    this.listen = button("Listen", () => this.toggle(), { primary: true });
    this.level = make("meter", { min: 0, max: 1, high: 0.98, value: 0, ariaLabel: "Loudness" });
    this.file = make("input", { type: "file", id: "tap-file", accept: `${SOUNDS.join(",")},audio/*`, multiple: true });
    this.file.addEventListener("change", () => {
      this.add([...(this.file.files ?? [])]);
      this.file.value = "";
    });
    this.clear = button("Forget the taps", () => this.forget());
    this.words = make("p", { className: "note" });
    this.words.setAttribute("role", "status");
    this.fault = make("p", { className: "fault", hidden: true });
    this.fault.setAttribute("role", "alert");
    this.lights = new Lights("The taps");
    this.tones = make("div");
    this.chart = new Chart(app, { label: "Spectrum of the tap", panels: SPECTRUM, axis: { kind: "frequency_hz", label: "" } });
    this.wave = new Chart(app, { label: "The sound of the last recording", panels: WAVE, axis: { kind: "time_s", label: "" } });
    this.progress = make("progress", { hidden: true, ariaLabel: "Recordings heard" });
    this.again = make("p", { className: "note", hidden: true }, "These tones do not count now. ", button("Count them", () => heard.found && this.count(heard.found)));
    this.element = make("div", {}, make("div", { className: "row" }, this.listen, this.level, this.clear),
      make("p", { className: "own" }, make("label", { htmlFor: "tap-file", textContent: "Or sound files of taps; drop them anywhere" }), this.file),
      this.words, this.progress, this.fault, this.chart.element, this.wave.element, this.lights.element, this.again, this.tones);
    this.heard();
  }

  async toggle() {
    this.say("");
    if (this.ear.on) {
      this.ear.stop();
      return;
    }
    try {
      await this.ear.start();
      this.live();
    } catch (fault) {
      this.say(fault.message);
    }
    this.heard();
  }

  // Until a tap freezes the picture, it shows what is heard now.
  live() {
    let last = 0;
    const taps = this.ear.taps;
    const end = this.app.onFrame((now) => {
      if (!this.ear.on || this.ear.taps > taps || this.ear.left > 0) end();
      else if (now - last > LIVE && this.app.answer) {
        last = now;
        const spectrum = this.ear.spectrum(this.most(this.app.answer, null));
        if (spectrum) this.picture(this.app.answer, spectrum, "heard now");
      }
    });
  }

  heard() {
    this.listen.textContent = this.ear.on ? "Stop listening" : "Listen";
    this.listen.setAttribute("aria-pressed", String(this.ear.on));
    this.level.hidden = !this.ear.on;
    const count = heard.recordings.length;
    keep(TAPS, count ? heard.recordings : null);
    this.clear.disabled = count === 0;
    this.words.textContent = `${this.ear.on ? "Listening: hang it from rubber bands, tap it near the tip with something small and hard, let it ring. " : ""}` +
      `${count ? `${count} recording${count > 1 ? "s" : ""}. ` : ""}The dashed lines are where it rings as described. ${whereTo("The sound")}`;
  }

  /** @param {string} words */
  say(words) {
    showWords(this.fault, words);
  }

  // Sounds handed to the server, then all of them heard anew.
  /** @param {File[]} files */
  async add(files) {
    this.refused = [];
    for (const file of files) {
      if (!file.size) {
        this.refused.push(`${file.name} is empty; record it anew.`);
        continue;
      }
      if (file.size > LARGEST) {
        this.refused.push(`${file.name} has ${(file.size / 1e6).toFixed(0)} MB; at most ${LARGEST / 1e6}. Cut out the taps.`);
        continue;
      }
      try {
        heard.recordings.push(await upload(file));
      } catch (fault) {
        this.refused.push(fault.message);
      }
    }
    this.heard();
    this.say(this.refused.join(" "));
    await this.hear();
  }

  // All recordings together, one question at a time: a tap that comes meanwhile is asked about next. Again: after a reload,
  // when the address holds what was heard.
  async hear({ again = false } = {}) {
    if (this.asking) {
      this.more = true;
      return;
    }
    this.asking = true;
    this.app.waits("taps");
    do {
      this.more = false;
      await this.ask([...heard.recordings], again && !this.more);
    } while (this.more && !this.signal.aborted);
    this.asking = false;
    if (!this.signal.aborted) this.app.waits("taps", false);
  }

  /** @param {string[]} recordings @param {boolean} again */
  async ask(recordings, again) {
    if (!recordings.length) return;
    const [expected, of] = [tonesOf(this.app.answer), this.app.state.implement];
    let found;
    const busy = this.works(recordings.length);
    try {
      for (const [i, one] of recordings.slice(0, -1).entries()) { // each alone first, which the server remembers: so that it can be told how far it is
        busy.at(i);
        await this.answerTo({ ...this.app.state, recordings: [one] });
      }
      busy.at(recordings.length - 1);
      found = await this.answerTo({ ...this.app.state, recordings });
    } catch (fault) {
      const gone = fault?.field === "upload"; // the server began anew
      if (gone) heard.recordings = [];
      this.heard();
      this.say([...this.refused, gone ? GONE : fault.message].join(" "));
      return;
    } finally {
      busy.end();
    }
    this.refused.push(...found.refused.map(({ fault }) => sentence(fault)));
    const bad = found.refused.map(({ recording }) => recording);
    heard.recordings = heard.recordings.filter((key) => !bad.includes(key));
    this.heard();
    this.say(this.refused.join(" "));
    if (!heard.recordings.length || this.signal.aborted) return; // none of them, forgotten, or gone elsewhere, meanwhile
    Object.assign(heard, { found, expected, of });
    this.say([...this.refused, ...(found.fault ? [sentence(found.fault)] : []), ...found.doubts].join(" "));
    this.draw(this.app.answer);
    if (!again) this.count(found.unlike ? { ...found, damping: undefined } : found);
    this.app.announce(found.words);
  }

  // Tones among the measurements; none where the taps hold none that counts.
  /** @param {HeardTaps} found */
  count({ damping, measured }) {
    if (damping) this.app.setState({ tones: measured.map(([name, hertz, error]) => [name, tidy(hertz), tidy(error)]), damping: tidy(damping[0]), damping_error: tidy(damping[1]) });
    else if (this.app.state.tones.length) this.app.setState({ tones: [], damping: null });
  }

  // How far the hearing is: of several recordings how many, and for how long it has gone on.
  /** @param {number} count */
  works(count) {
    const began = performance.now();
    const { progress, words } = this;
    let now = 0;
    const tell = () => {
      const seconds = Math.floor((performance.now() - began) / 1000);
      words.textContent = `Hearing ${count > 1 ? `recording ${now + 1} of ${count}` : "what was recorded"}${seconds > 1 ? `, ${seconds} s` : ""} …`;
      if (count > 1) Object.assign(progress, { max: count, value: now });
      else progress.removeAttribute("value");
    };
    progress.hidden = false;
    const timer = setInterval(tell, 1000);
    return {
      /** @param {number} number */
      at(number) {
        now = number;
        tell();
      },
      end() {
        clearInterval(timer);
        progress.hidden = true;
      },
    };
  }

  // The same question until it is answered: with the taps that came meanwhile it would be another, begun from the start.
  /** @param {State} question */
  async answerTo(question) {
    for (;;) {
      try {
        return await this.app.ask("own/tap", question);
      } catch (fault) {
        if (!fault?.again || this.signal.aborted) throw fault;
        await new Promise((done) => setTimeout(done, 1000));
      }
    }
  }

  forget() {
    this.empty();
    this.app.setState({ tones: [], damping: null });
  }

  // The recordings go; what of them counts stays.
  empty() {
    Object.assign(heard, { recordings: [], found: null, expected: "" });
    this.refused = [];
    this.say("");
    this.heard();
  }

  // How far up the spectrum is drawn, Hz.
  /** @param {OwnAnswer} answer @param {TapSpectrum | null} spectrum */
  most(answer, spectrum) {
    return spectrum?.frequency_hz.at(-1) ?? Math.min(2600, 1.1 * (answer.expected.at(-1)?.frequency_hz ?? 1000));
  }

  /** @param {OwnAnswer} answer @param {TapSpectrum | null} spectrum @param {string} of */
  picture(answer, spectrum, of) {
    const most = this.most(answer, spectrum);
    if (SPECTRUM[0].lines[0].label !== of) SPECTRUM[0].lines = [{ ...SPECTRUM[0].lines[0], label: of }];
    this.chart.draw({ x: spectrum?.frequency_hz ?? [0, most], lines: { level: spectrum?.level_db ?? [null, null] }, range: [0, most],
      marks: answer.expected.filter(({ frequency_hz: at }) => at < most).map(({ name, frequency_hz: at }) => ({ at, color: "muted", label: name })) });
    this.chart.label(`Spectrum of the tap; ${answer.expected_words[this.app.units]}`);
  }

  // The same taps of something that is described otherwise now: its modes may have other names.
  /** @param {OwnAnswer} answer */
  rename(answer) {
    if (this.asking || heard.expected === tonesOf(answer) || tonesOf(answer) !== tonesOf(this.app.answer)) return;
    heard.expected = tonesOf(answer);
    this.hear({ again: Boolean(heard.found?.damping) && !heard.found?.unlike && !this.app.state.tones.length }); // what was undone stays so
  }

  /** @param {OwnAnswer | null} answer */
  draw(answer) {
    if (!answer) return;
    if (this.reloaded) {
      this.reloaded = false;
      this.hear({ again: true });
    }
    if (heard.found && heard.of !== this.app.state.implement) this.empty(); // of something else
    if (heard.found && heard.expected !== tonesOf(answer)) this.app.afterwards(this, () => this.rename(answer));
    const { found } = heard, { app } = this;
    this.wave.element.hidden = !found?.waveform;
    if (found?.waveform) {
      const { time_s: time, low, high } = found.waveform;
      this.wave.draw({ x: time, lines: { high, low }, range: [time[0], time[time.length - 1]] });
      this.wave.label("The sound of the last recording over time.");
    }
    this.again.hidden = !found?.damping || app.state.tones.length > 0;
    this.picture(answer, found?.spectrum ?? null, "the last good tap");
    this.lights.show((found?.taps ?? []).map(({ recording, time_s: time, good, fault }) => ({
      state: good ? "pass" : "fail", name: `${recording}, ${time.toFixed(2)} s`, words: good ? "used" : fault ?? "" })));
    const tones = found?.tones ?? [];
    this.tones.replaceChildren(...(tones.length ? [tableOf("The tones of all good taps", ["Mode", "heard", "expected", "damping", "taps", "whose"], tones.map((tone) => [
      tone.name ?? "no mode of this bat", `${tone.frequency_hz.toFixed(1)} ± ${tone.half_hz.toFixed(1)} Hz`, tone.expected_hz ? `${tone.expected_hz.toFixed(0)} Hz` : "–",
      app.text("share", tone.damping_ratio, 2), String(tone.taps), tone.from_bat ? "its own" : "room’s?"]))] : []), ...(tones.every(({ from_bat: own }) => own) ? [] : [make("p", { className: "note", textContent: ROOM })]));
  }
}

const tonesOf = (/** @type {OwnAnswer | null} */ answer) => JSON.stringify(answer?.expected ?? null);
const tidy = (/** @type {number} */ value) => Number(value.toPrecision(7));
// Words of the library as a sentence of several.
const sentence = (/** @type {string} */ words) => (/[.!?]$/.test(words) ? words : `${words}.`);
