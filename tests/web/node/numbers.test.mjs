import assert from "node:assert/strict";
import { test } from "node:test";

Object.assign(globalThis, { addEventListener: () => {}, ResizeObserver: class { observe() {} } });

const { ticks } = await import(`${process.env.PAGE}/charts/surface.js`);
const { fromShown, text, toShown } = await import(`${process.env.PAGE}/controls/units.js`);

test("ticks are at round numbers, about as many as are wanted, inside the axis", () => {
  assert.deepEqual(ticks(0, 1, 5), [0, 0.2, 0.4, 0.6, 0.8, 1]);
  assert.deepEqual(ticks(3, 3, 5), [3]);
  for (const [least, most] of [[-7.3, 12.9], [0.00012, 0.00034], [1e5, 9e5]]) {
    for (const count of [4, 6, 9]) {
      const found = ticks(least, most, count), step = found[1] - found[0];
      assert.ok(found.length <= count + 1 && found[0] >= least && found.at(-1) <= most * (1 + 1e-9));
      assert.ok([1, 2, 5].includes(Number((step / 10 ** Math.floor(Math.log10(step * 1.0001))).toPrecision(3))), `step ${step}`);
    }
  }
});

test("a value is shown in either system and taken back", () => {
  assert.equal(text("exit_speed_m_s", 41.2, "us"), "92.2 mph");
  assert.equal(text("exit_speed_m_s", null, "us"), "–");
  for (const system of ["us", "si"]) assert.ok(Math.abs(fromShown("pitch_speed_mph", toShown("pitch_speed_mph", 87.5, system), system) - 87.5) < 1e-9);
});
