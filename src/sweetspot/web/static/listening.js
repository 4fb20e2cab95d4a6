// Listening for taps: the microphone until a sudden sound, which freezes it; the tap with its ringing as a sound file.
//
//   const ear = new Listening({ onLevel(part) {}, onTap(file) {}, onEnd() {} });
//   await ear.start();     // a refusal of the browser is thrown as { message }
//   ear.stop();

const BEFORE = 0.3, AFTER = 1.2; // s around the sudden sound
const LEAST = 0.02; // of full scale, below which nothing is a tap
const SUDDEN = 6; // times the loudness of the last while
const FORGETS = 0.95; // of that loudness per piece

export class Listening {
  /** @param {{ onLevel: (level: number) => void, onTap: (tap: File) => void, onEnd: (words?: string) => void }} given */
  constructor({ onLevel, onTap, onEnd }) {
    this.onLevel = onLevel;
    this.onTap = onTap;
    this.onEnd = onEnd;
    this.audio = null;
    this.stream = null;
    /** @type {Float32Array[]} */
    this.pieces = [];
    /** @type {number | null} */
    this.floor = null; // loudness of the last while
    this.left = 0; // samples until the ringing is whole
    this.taps = 0;
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
    await audio.audioWorklet.addModule("/static/recorder.js");
    if (this.audio !== audio) return; // stopped meanwhile
    const node = new AudioWorkletNode(audio, "recorder");
    audio.createMediaStreamSource(this.stream).connect(node).connect(audio.destination); // silence: only so that it runs
    Object.assign(this, { pieces: [], floor: null, left: 0 });
    node.port.onmessage = ({ data }) => this.take(data);
    this.stream.getTracks()[0].addEventListener("ended", () => this.stop());
  }

  stop() {
    for (const track of this.stream?.getTracks() ?? []) track.stop();
    this.audio?.close();
    const was = this.on;
    Object.assign(this, { audio: null, stream: null, pieces: [] });
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
    const sudden = this.floor !== null && most > Math.max(LEAST, SUDDEN * this.floor);
    this.floor = this.floor === null ? most : FORGETS * this.floor + (1 - FORGETS) * most;
    if (sudden) this.left = AFTER * rate;
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
/**
 * @param {Float32Array[]} pieces
 * @param {number} rate
 */
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
