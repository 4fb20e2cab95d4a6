import assert from "node:assert/strict";
import { test } from "node:test";

const { addressOf, isPacked, shortAddressOf, stateIn, unknownIn } = await import(`${process.env.PAGE}/shell/address.js`);

const first = { a: 1, name: "x", list: [], on: false };
const schema = { a: { type: "number" }, name: { type: "string" }, list: { type: "array" }, on: { type: "boolean" } };
const search = (address) => (address.includes("?") ? address.slice(address.indexOf("?")) : "");

test("an address, long or short, holds a state and gives it back", async () => {
  const state = { a: 2.5, name: "å & ? #", list: [{ b: 1 }], on: true };
  for (const address of [addressOf("v", state, first), await shortAddressOf("v", state, first)]) {
    assert.deepEqual(await stateIn(search(address), schema, first), state);
    assert.deepEqual(unknownIn(search(address), schema), []);
  }
  assert.equal(isPacked(search(await shortAddressOf("v", state, first))), true);
});

test("what is as in the first picture is not in the address; the first page has that of the server", async () => {
  assert.equal(addressOf("v", first, first), "/v");
  assert.equal(await shortAddressOf("v", first, first), "/v");
  assert.equal(addressOf("start", first, first), "/");
  assert.equal(addressOf("start", first, first, true), "/embed/start");
});

test("an address cut off on its way gives what is left of it", async () => {
  assert.deepEqual(await stateIn("?s=cut-off&a=2&other=3", schema, first), { ...first, a: 2 });
});

test("a number that no JSON holds goes to the server as it was typed, and text stays text", async () => {
  assert.equal((await stateIn("?a=1e999", schema, first)).a, "1e999");
  assert.equal((await stateIn("?name=12", schema, first)).name, "12");
});

test("names of no field are told once, but not that of the units or of a packed state", () => {
  assert.deepEqual(unknownIn("?bats=left&a=2&bats=right&units=si&s=x&locked=7", schema), ["bats", "locked"]);
});
