// The line to the server: the latest question of each view wins, and a lost connection is shown and comes back.

const SLOW = 4000; // ms after which a missing answer is said to be slow
const AGAIN = 1000; // ms until a question that took too long is asked again
const FIRST_WAIT = 250, LONGEST_WAIT = 4000;
const PATIENCE = 1500; // ms that the first answer may take apart; then the line asks, and hears how far it is

/** @import { Answer, Fault, State } from "./main.js" */
/** @typedef {{ id: number | null, status?: string, again?: boolean, error?: Fault, answer?: Answer }} Message */
/**
 * @typedef {object} Handlers
 * @property {(view: string, answer: Answer, state: State) => void} onAnswer
 * @property {(view: string, fault: Fault, state: State) => void} onFault
 * @property {(status: string) => void} onStatus  "open", "lost", "slow" or "preparing"
 */

export class Line {
  // apart: whether the first question is a request of its own, whose answer comes packed
  /** @param {Handlers & { apart?: boolean }} look */
  constructor({ onAnswer, onFault, onStatus, apart = false }) {
    this.apart = apart;
    this.handlers = { onAnswer, onFault, onStatus };
    /** @type {Map<string, { id: number, state: State }>} */
    this.asked = new Map(); // view -> {id, state} under way
    /** @type {Map<string, State>} */
    this.next = new Map(); // view -> state to ask when that one is answered
    /** @type {{ view: string, state: State } | null} */
    this.last = null; // {view, state} to ask again after a loss
    this.id = 0;
    this.wait = FIRST_WAIT;
    this.back = false; // whether this line was lost before
    this.open();
  }

  /** @param {string} view @param {State} state */
  ask(view, state) {
    this.last = { view, state };
    this.next.set(view, state);
    if (this.apart && this.id === 0) this.askApart(view, state);
    else this.flush();
  }

  /** @param {string} view @param {State} state */
  async askApart(view, state) {
    this.id += 1;
    const asked = { id: this.id, state };
    this.next.delete(view);
    this.asked.set(view, asked);
    try {
      const response = await fetch(`/api/v1/${view}`, {
        method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(state),
        signal: AbortSignal.timeout(PATIENCE),
      });
      const table = await response.json();
      if (!response.ok && response.status !== 422) throw new Error(`status ${response.status}`);
      this.take({ id: asked.id, ...(response.ok ? { answer: table } : table) });
    } catch { // the line is asked then
      if (this.asked.get(view) !== asked) return;
      this.asked.delete(view);
      if (!this.next.has(view)) this.next.set(view, state);
      this.flush();
    }
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    this.socket = new WebSocket(`${scheme}//${location.host}/ws`);
    this.socket.onopen = () => {
      this.wait = FIRST_WAIT;
      this.handlers.onStatus("open");
      if (this.back && this.last && !this.next.has(this.last.view)) this.next.set(this.last.view, this.last.state);
      this.flush();
    };
    this.socket.onmessage = (event) => this.take(JSON.parse(event.data));
    this.socket.onclose = () => this.lost();
  }

  lost() {
    clearTimeout(this.slow);
    this.asked.clear();
    this.back = true;
    this.handlers.onStatus("lost");
    setTimeout(() => this.open(), this.wait);
    this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
  }

  flush() {
    if (this.socket?.readyState !== WebSocket.OPEN) return;
    for (const [view, state] of this.next) {
      if (this.asked.has(view)) continue; // one question at a time; the latest waits
      this.next.delete(view);
      this.id += 1;
      this.asked.set(view, { id: this.id, state });
      this.socket?.send(JSON.stringify({ id: this.id, view, state }));
      clearTimeout(this.slow);
      this.slow = setTimeout(() => this.handlers.onStatus("slow"), SLOW);
    }
  }

  /** @param {Message} message */
  take(message) {
    const found = [...this.asked].find(([, asked]) => message.id === null || asked.id === message.id);
    if (!found) return;
    const [view, { state }] = found;
    if (message.status) {
      this.handlers.onStatus(message.status);
      clearTimeout(this.slow);
      return;
    }
    this.asked.delete(view);
    clearTimeout(this.slow);
    this.handlers.onStatus("open");
    if (message.again) { // it is still being worked out, and there when asked for again
      this.handlers.onStatus("slow");
      setTimeout(() => this.last?.state === state && this.ask(view, state), AGAIN);
    } else if (message.error) this.handlers.onFault(view, message.error, state);
    else if (message.answer) this.handlers.onAnswer(view, message.answer, state);
    this.flush();
  }
}
