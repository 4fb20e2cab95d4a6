// Listening for taps: the microphone until a sudden sound, which freezes it; the tap with its ringing as a sound file.
//
//   const ear = new Listening({ onLevel(part) {}, onTap(file) {}, onDoubt(words) {}, onEnd() {} });
//   await ear.start();     // a refusal of the browser is thrown as { message }
//   ear.spectrum(most)     what is heard now up to so many Hz: { frequency_hz, level_db } below its loudest; null: nothing
//   ear.stop();
//
// onDoubt hears why taps are not found: "" once nothing stands in their way.

const BEFORE = 0.3, AFTER = 1.2; // s around the sudden sound
const LEAST = 0.02; // of full scale, below which nothing is a tap
const SUDDEN = 6; // times the loudness of the last while
const FORGETS = 0.95; // of that loudness per piece
const FAINT = LEAST / 10; // of full scale, from which on a sudden sound was a tap that was too quiet
const WHILE = 3; // s of silence or of noise after which it is said
const BINS = 16384; // samples of what is heard now

export class Listening {
  /** @param {{ onLevel: (level: number) => void, onTap: (tap: File) => void, onDoubt: (words: string) => void, onEnd: (words?: string) => void }} given */
  constructor({ onLevel, onTap, onDoubt, onEnd }) {
    this.onLevel = onLevel;
    this.onTap = onTap;
    this.onDoubt = onDoubt;
    this.onEnd = onEnd;
    this.audio = null;
    /** @type {AnalyserNode | null} */
    this.now = null; // what is heard at this moment
    this.stream = null;
    /** @type {Float32Array[]} */
    this.pieces = [];
    /** @type {number | null} */
    this.floor = null; // loudness of the last while
    this.left = 0; // samples until the ringing is whole
    this.taps = 0;
    this.silent = 0; // s without any sound, and with noise above which no tap would stand out
    this.noisy = 0;
    this.doubt = "";
  }

  get on() { return this.audio !== null; }

  async start() {
    if (!navigator.mediaDevices?.getUserMedia) throw { message: "This browser gives no microphone to this address. Open the page as http://localhost, or record a file and drop it here." };
    try {
      this.stream = await navigator.mediaDevices.getUserMedia({ audio: { echoCancellation: false, noiseSuppression: false, autoGainControl: false } });
    } catch (fault) {
      throw { message: fault?.name === "NotFoundError" ? "No microphone was found; record a file and drop it here." : "The microphone was not allowed; allow it beside the address, or record a file and drop it here." };
    }
    const audio = new AudioContext();
    this.audio = audio;
    await audio.audioWorklet.addModule("/static/controls/recorder.js");
    if (this.audio !== audio) return; // stopped meanwhile
    const node = new AudioWorkletNode(audio, "recorder");
    const sound = audio.createMediaStreamSource(this.stream);
    sound.connect(node).connect(audio.destination); // silence: only so that it runs
    this.now = new AnalyserNode(audio, { fftSize: BINS, smoothingTimeConstant: 0.5 });
    sound.connect(this.now);
    Object.assign(this, { pieces: [], floor: null, left: 0, silent: 0, noisy: 0, doubt: "" });
    node.port.onmessage = ({ data }) => this.take(data);
    this.stream.getTracks()[0].addEventListener("ended", () => this.stop());
  }

  stop() {
    for (const track of this.stream?.getTracks() ?? []) track.stop();
    this.audio?.close();
    const was = this.on;
    Object.assign(this, { audio: null, stream: null, now: null, pieces: [] });
    if (was) this.onEnd();
  }

  // One piece of sound: loud and sudden, or one of those after it until the ringing is whole.
  /** @param {Float32Array} piece */
  take(piece) {
    if (!this.on) return;
    const most = piece.reduce((best, one) => Math.max(best, Math.abs(one)), 0);
    const rate = this.audio?.sampleRate ?? 48000;
    this.pieces.push(piece);
    this.onLevel(most);
    if (this.left > 0) {
      this.left -= piece.length;
      if (this.left <= 0) this.freeze(rate);
      return;
    }
    while (this.pieces.length * piece.length > (BEFORE + 0.05) * rate) this.pieces.shift();
    const stands = this.floor !== null && most > SUDDEN * this.floor;
    this.judge(most, stands, piece.length / rate);
    this.floor = this.floor === null ? most : FORGETS * this.floor + (1 - FORGETS) * most;
    if (stands && most > LEAST) this.left = AFTER * rate;
  }

  // Whether something stands in the way of taps: silence, noise, or that they are too quiet.
  /** @param {number} most @param {boolean} stands @param {number} lasts */
  judge(most, stands, lasts) {
    this.silent = most === 0 ? this.silent + lasts : 0;
    this.noisy = SUDDEN * (this.floor ?? 0) > 1 ? this.noisy + lasts : 0;
    if (this.silent > WHILE) this.doubts("The microphone gives nothing but silence. Is it muted, or is another one chosen?");
    else if (this.noisy > WHILE) this.doubts("It is too loud here: no tap would stand out. Find a quieter place, or lower the microphone's level.");
    else if (stands && most > LEAST) this.doubts("");
    else if (stands && most > FAINT) this.doubts("Something like a tap was heard, but too quiet. Tap harder, or nearer the microphone.");
    else if ((this.silent === 0 && this.doubt.startsWith("The")) || (this.noisy === 0 && this.doubt.startsWith("It"))) this.doubts("");
  }

  /** @param {string} words */
  doubts(words) {
    if (words === this.doubt) return;
    this.doubt = words;
    this.onDoubt(words);
  }

  /** @param {number} most */
  spectrum(most) {
    const { now, audio } = this;
    if (!now || !audio) return null;
    const levels = new Float32Array(now.frequencyBinCount);
    now.getFloatFrequencyData(levels);
    const step = audio.sampleRate / now.fftSize;
    const shown = levels.subarray(0, Math.min(levels.length, Math.ceil(most / step)));
    const loudest = shown.reduce((best, one) => Math.max(best, one), -Infinity);
    if (!Number.isFinite(loudest)) return null;
    return { frequency_hz: Array.from(shown, (_, i) => i * step), level_db: Array.from(shown, (one) => one - loudest) };
  }

  /** @param {number} rate */
  freeze(rate) {
    this.taps += 1;
    const file = new File([wavOf(this.pieces, rate)], `tap ${this.taps}.wav`, { type: "audio/wav" });
    Object.assign(this, { pieces: [], left: 0 });
    this.onTap(file);
  }
}

// A sound file of 32-bit numbers, as they came.
/** @param {Float32Array[]} pieces @param {number} rate */
export function wavOf(pieces, rate) {
  const count = pieces.reduce((sum, piece) => sum + piece.length, 0);
  const bytes = new DataView(new ArrayBuffer(44 + 4 * count));
  const letters = (/** @type {number} */ at, /** @type {string} */ text) => [...text].forEach((letter, i) => bytes.setUint8(at + i, letter.charCodeAt(0)));
  letters(0, "RIFF");
  bytes.setUint32(4, 36 + 4 * count, true);
  letters(8, "WAVEfmt ");
  bytes.setUint32(16, 16, true);
  bytes.setUint16(20, 3, true); // floating point
  bytes.setUint16(22, 1, true);
  bytes.setUint32(24, rate, true);
  bytes.setUint32(28, 4 * rate, true);
  bytes.setUint16(32, 4, true);
  bytes.setUint16(34, 32, true);
  letters(36, "data");
  bytes.setUint32(40, 4 * count, true);
  let at = 44;
  for (const piece of pieces) for (const sample of piece) {
    bytes.setFloat32(at, sample, true);
    at += 4;
  }
  return bytes.buffer;
}
