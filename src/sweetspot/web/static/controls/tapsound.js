// The tap as a sound: every motion at its frequency, dying away as it does, as strong as the tap excites it.

const LASTS = 1.2; // s
const AUDIBLE = 60; // Hz

/** @typedef {{ frequency_hz: number, decay_s: number | null, energy_share: number | null }} Tone */

/** @param {Tone[]} tones */
export function strike(tones) {
  const audio = new AudioContext();
  const rate = audio.sampleRate;
  const buffer = audio.createBuffer(1, LASTS * rate, rate);
  const sound = buffer.getChannelData(0);
  for (const { frequency_hz: hertz, decay_s: decay, energy_share: share } of tones) {
    if (hertz < AUDIBLE || !decay || !share) continue;
    const [omega, fade] = [(2 * Math.PI * hertz) / rate, Math.exp(-1 / (decay * rate))];
    let strength = Math.sqrt(share) * Math.min(1, hertz / 1000); // a narrow bat hardly radiates low notes
    for (let i = 0; i < sound.length && strength > 1e-5; i += 1, strength *= fade) sound[i] += strength * Math.sin(omega * i);
  }
  const most = sound.reduce((best, value) => Math.max(best, Math.abs(value)), 1e-9);
  for (let i = 0; i < sound.length; i += 1) sound[i] *= 0.5 / most;
  const source = audio.createBufferSource();
  source.buffer = buffer;
  source.connect(audio.destination);
  source.addEventListener("ended", () => audio.close());
  source.start();
}
