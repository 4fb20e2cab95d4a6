// Tables to the server and what becomes of them: handed in piece by piece, read in a job that can be stopped, and told.

import { button, faultPlace } from "../controls/controls.js";
import { longWork } from "../shell/longwork.js";
import { make, paragraphs, partOf, showWords } from "../controls/parts.js";
import { takeDrops, upload, whereTo } from "../controls/upload.js";
/** @import { SeasonSummary, SeasonReading } from "../answers.js" */
/** @import { App } from "../shell/main.js" */

const TABLES = /\.(csv|tsv|txt|gz|parquet)$/i;
const MOST = 60;

const stay = (/** @type {Event} */ event) => event.preventDefault(); // the browser asks whether the page is to be left

/** @type {File[]} */
let handed = []; // the last tables, while the page is open: a server begun anew has none of them

export class Reading {
  /** @param {App} app */
  constructor(app, /** @type {{ onSeason: (read: { uploads: string[], season: string }) => void }} */ { onSeason }) {
    this.app = app;
    this.onSeason = onSeason;
    /** @type {AbortController | null} */
    this.going = null;
    /** @type {SeasonSummary | null} */
    this.season = null;
    this.wrong = ""; // with the work
    this.work = longWork("season/read");
    this.file = make("input", { type: "file", id: "season-files", multiple: true, accept: ".csv,.tsv,.txt,.gz,.parquet,text/csv" });
    this.file.addEventListener("change", () => {
      const files = [...(this.file.files ?? [])];
      this.file.value = "";
      this.hand(files);
    });
    this.again = button("Read again with this bat", () => this.begin(), { primary: true });
    this.halt = button("Stop", () => (this.going ? this.going.abort() : this.work.stop()));
    this.on = button("Go on", () => this.work.goOn());
    this.anew = button("Hand them in again", () => this.hand(handed));
    this.bar = make("progress", { max: 1, ariaLabel: "Rows read" });
    this.words = make("p", { className: "note" });
    this.words.setAttribute("role", "status");
    this.fault = faultPlace(app, ["season", "uploads"]);
    this.unread = make("div", { className: "fault", hidden: true });
    this.first = [button("Choose tables", () => this.file.click(), { primary: true }), button("Look at a made-up season", () => this.begin({ uploads: [] }))];
    this.chooser = make("div", { className: "own" }, make("label", { htmlFor: "season-files", textContent: "Tables (CSV, .csv.gz, Parquet), or drop them anywhere" }), this.file,
      make("p", { className: "note", textContent: whereTo("A table") }));
    this.element = make("div", {}, make("div", { className: "row" }, ...this.first, this.again, this.halt, this.on, this.anew, this.bar), this.words, this.fault, this.unread);
    takeDrops(partOf(document, "#view", HTMLElement), TABLES, app.signal, (tables) => this.hand(tables));
    app.signal.addEventListener("abort", () => this.going?.abort());
    this.work.watch(app.signal, () => this.update());
  }

  /** @param {string} words */
  say(words) {
    showWords(this.fault, words);
  }

  // Files to the server, one after the other; then they are read together.
  /** @param {FileList | File[]} files */
  async hand(files) {
    this.say("");
    if (!files.length || this.going) return;
    if (files.length > MOST) {
      this.say(`${files.length} files; at most ${MOST} at a time. Put them together, or take the command season.`);
      return;
    }
    const empty = [...files].filter(({ size }) => !size).map(({ name }) => name);
    if (empty.length) {
      const [are, them] = empty.length === 1 ? ["is", "it"] : ["are", "them"];
      this.say(`${empty.join(", ")} ${are} empty; save ${them} anew, or leave ${them} out.`);
      return;
    }
    const going = new AbortController();
    this.going = going;
    handed = [...files];
    addEventListener("beforeunload", stay); // a reload would have to begin anew
    const uploads = [];
    try {
      for (const file of files) {
        uploads.push(await upload(file, (part) => this.handed(file.name, part), going.signal));
      }
    } catch (fault) {
      if (!this.app.signal.aborted) this.say(going.signal.aborted ? "Stopped; nothing was read." : fault.message);
    }
    this.going = null;
    removeEventListener("beforeunload", stay);
    if (this.app.signal.aborted) return;
    this.update();
    if (uploads.length === files.length) this.begin({ uploads });
  }

  /** @param {string} name @param {number} part */
  handed(name, part) {
    this.bar.value = part;
    this.words.textContent = `Handing in ${name}: ${Math.round(100 * part)} %`;
    this.update();
  }

  // What stands on the page stays until what is read now is there.
  begin({ uploads } = { uploads: /** @type {string[]} */ (this.app.state.uploads) }) {
    this.say("");
    this.work.start({ ...this.app.state, uploads, season: null }, { uploads });
  }

  // What the last answer says of a season, null where none was read.
  /** @param {SeasonSummary | null} season */
  draw(season) {
    this.season = season;
    const unread = season?.unread ?? [];
    paragraphs(this.unread, unread.map((words) => `Not read: ${words}`));
    this.unread.hidden = !unread.length;
    this.update();
  }

  update() {
    const { status, fault, found } = this.work;
    const runs = ["running", "starting"].includes(status);
    if (status === "done" && found?.season && !this.work.taken) {
      this.work.takenOver(); // once: who goes back finds what was before
      this.onSeason({ uploads: this.work.about?.uploads ?? [], season: found.season });
    }
    const idle = !runs && this.going === null;
    for (const one of this.first) one.hidden = !idle || this.season !== null;
    this.element.classList.toggle("dropped", idle && this.season === null);
    this.again.hidden = runs || this.going !== null || !this.season || this.season.same_bat;
    this.halt.hidden = !(this.going || status === "running");
    const begun = Boolean(found?.reached);
    this.on.hidden = !(status === "stopped" || (status === "failed" && this.work.key && begun)) || this.going !== null;
    this.anew.hidden = !(status === "failed" && !this.work.key && handed.length) || this.going !== null;
    this.bar.hidden = !(this.going || runs);
    const wrong = fault?.message ?? "";
    if (wrong || this.wrong) this.say(wrong);
    this.wrong = wrong;
    if (this.going) return;
    if (runs && found?.phase === "rows" && found.rows) this.bar.value = found.rows_read / found.rows;
    else this.bar.removeAttribute("value");
    this.words.textContent = this.progress(status, found);
  }

  /** @param {string} status @param {SeasonReading | null} found */
  progress(status, found) {
    if (status === "starting" || (status === "running" && !found)) return "The reading begins …";
    if (status === "running") return found?.words ?? "";
    if (status === "stopped") return `Stopped${found?.reached ? ` after ${found.reached}` : ""}. Go on, or hand in other tables.`;
    return this.season?.words ?? `Statcast and Trackman exports, plain CSV with units in the headings, Parquet; many files at once, of any size. ${whereTo("A table")}`;
  }
}
