// The microphone's samples on their way: an audio worklet that hands each few milliseconds to the page.

const SIZE = 1024; // samples of a piece

registerProcessor("recorder", class extends AudioWorkletProcessor {
  constructor() {
    super();
    this.piece = new Float32Array(SIZE);
    this.filled = 0;
  }

  /** @param {Float32Array[][]} inputs  channels of each */
  process([input]) {
    const samples = input?.[0];
    if (!samples) return true;
    let taken = 0;
    while (taken < samples.length) {
      const part = samples.subarray(taken, taken + SIZE - this.filled);
      this.piece.set(part, this.filled);
      this.filled += part.length;
      taken += part.length;
      if (this.filled < SIZE) continue;
      this.port.postMessage(this.piece.slice());
      this.filled = 0;
    }
    return true;
  }
});
