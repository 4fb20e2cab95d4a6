import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";

const { Line } = await import(`${process.env.PAGE}/shell/socket.js`);

class Socket { // one that a test opens, answers and closes by hand
  static OPEN = 1;
  static all = [];
  readyState = 0;
  sent = [];
  constructor(address) {
    this.address = address;
    Socket.all.push(this);
  }
  send(text) { this.sent.push(JSON.parse(text)); }
  opens() {
    this.readyState = Socket.OPEN;
    this.onopen();
  }
  says(message) { this.onmessage({ data: JSON.stringify(message) }); }
  closes() {
    this.readyState = 3;
    this.onclose();
  }
}

const heard = { answers: [], faults: [], statuses: [] };

function line(apart = false) {
  return new Line({
    apart,
    onAnswer: (view, answer, state) => heard.answers.push([view, answer, state]),
    onFault: (view, fault, state) => heard.faults.push([view, fault, state]),
    onStatus: (status) => heard.statuses.push(status),
  });
}

beforeEach(() => {
  mock.timers.reset();
  mock.timers.enable({ apis: ["setTimeout"] });
  Socket.all = [];
  for (const list of Object.values(heard)) list.length = 0;
  Object.assign(globalThis, { WebSocket: Socket, location: { protocol: "http:", host: "here" } });
});

test("of the questions that wait the latest is asked, one at a time", () => {
  const one = line(), [socket] = Socket.all;
  assert.equal(socket.address, "ws://here/ws");
  for (const x of [1, 2]) one.ask("flight", { x });
  socket.opens();
  for (const x of [3, 4]) one.ask("flight", { x });
  assert.deepEqual(socket.sent.map(({ state }) => state.x), [2]);
  socket.says({ id: socket.sent[0].id, answer: "of 2" });
  assert.deepEqual(socket.sent.map(({ state }) => state.x), [2, 4]);
  socket.says({ id: socket.sent[1].id, error: { field: "x", message: "no" } });
  assert.deepEqual(heard.answers, [["flight", "of 2", { x: 2 }]]);
  assert.deepEqual(heard.faults, [["flight", { field: "x", message: "no" }, { x: 4 }]]);
});

test("a lost line comes back by itself, each time a little later, and asks the last question again", () => {
  const one = line();
  Socket.all[0].opens();
  one.ask("hit", { x: 1 });
  Socket.all[0].closes();
  mock.timers.tick(250);
  assert.equal(Socket.all.length, 2);
  Socket.all[1].closes();
  mock.timers.tick(250);
  assert.equal(Socket.all.length, 2);
  mock.timers.tick(250);
  assert.equal(Socket.all.length, 3);
  Socket.all[2].opens();
  assert.deepEqual(Socket.all[2].sent.map(({ view, state }) => [view, state]), [["hit", { x: 1 }]]);
  assert.deepEqual(heard.statuses, ["open", "lost", "lost", "open"]);
});

test("an answer to a question that nobody asks any more, or that was lost, is not heard", () => {
  const one = line();
  Socket.all[0].opens();
  one.ask("hit", { x: 1 });
  const { id } = Socket.all[0].sent[0];
  Socket.all[0].says({ id: id + 1, answer: "of another" });
  assert.deepEqual(heard.answers, []);
});

test("a question that takes too long is asked again, unless another has come", () => {
  const one = line(), [socket] = Socket.all;
  socket.opens();
  one.ask("hit", { x: 1 });
  mock.timers.tick(4000);
  assert.equal(heard.statuses.at(-1), "slow");
  socket.says({ id: socket.sent[0].id, again: true, error: { field: "", message: "unfinished" } });
  mock.timers.tick(1000);
  assert.equal(socket.sent.length, 2);
  socket.says({ id: socket.sent[1].id, again: true, error: { field: "", message: "unfinished" } });
  one.ask("hit", { x: 2 });
  mock.timers.tick(1000);
  assert.deepEqual(socket.sent.map(({ state }) => state.x), [1, 1, 2]);
  assert.deepEqual(heard.faults, []);
});

test("the first question goes apart, and over the line where that fails", async () => {
  const asked = [];
  const settle = () => new Promise((done) => setImmediate(done));
  mock.method(AbortSignal, "timeout", () => undefined);
  globalThis.fetch = async (address, { body }) => {
    asked.push([address, JSON.parse(body)]);
    return { ok: true, status: 200, json: async () => "the first" };
  };
  line(true).ask("start", { x: 1 });
  await settle();
  assert.deepEqual(asked, [["/api/v1/start", { x: 1 }]]);
  assert.deepEqual(heard.answers, [["start", "the first", { x: 1 }]]);
  globalThis.fetch = async () => { throw new TypeError("no network"); };
  const other = line(true);
  other.ask("start", { x: 2 });
  await settle();
  Socket.all[1].opens();
  assert.deepEqual(Socket.all[1].sent.map(({ state }) => state), [{ x: 2 }]);
});
