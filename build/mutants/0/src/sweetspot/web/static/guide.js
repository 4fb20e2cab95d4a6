// Three steps for the first visit, and again whenever asked for; their words are those of the view one is on.

const STEPS = {
  explorer: [
    ["A bat, and where it hits best", "The bat is drawn to scale. Coloured marks are its sweet spots: there are several, " +
      "for each answers another question. The green zone is where a hit costs little speed and stings little."],
    ["Drag the ball", "Drag the ball along the bat, or anywhere on the curves. The curves say what a hit at each place " +
      "gives; the numbers below are those of the ball's place. With the keyboard: arrow keys on the picture."],
    ["Change everything", "Move a slider and all follows at once: pitch, swing, hands, ball. Choose another bat, drop a bat " +
      "file on the page, or drill, cork and cup this one. "],
  ],
  hit: [
    ["A hit, slowed down", "Ball and bat meet for about a thousandth of a second. Here it is a film: the ball is pressed in, " +
      "the bat bends, and a wave runs from the ball to the hands."],
    ["Move through time", "Play and pause, or drag anywhere on the curves to see that moment: the force on the ball, the bat " +
      "under the hands, and below them where the energy is."],
    ["Change the hit", "Meet the ball nearer to the tip or to the hands, choose another bat, make the film slower or the " +
      "bat's motion larger. "],
  ],
  modes: [
    ["How a bat rings", "A bat that is struck bends to and fro in several ways at once, its modes. One of them is shown, " +
      "slowed down and drawn larger than it is."],
    ["Tap it", "Press or drag along the bat to tap it there. A tap where a mode stands still does not excite it. " +
      "Listen to the tap, and choose the mode to look at from the table."],
    ["Change the tap", "A short, hard tap excites the high notes, a long, soft one only the low. Hold the bat with hands, or let " +
      "it hang free. "],
  ],
  compare: [
    ["Which bat hits harder", "Up to four bats in the same player's hands, or one bat against itself with a hole or another wall. " +
      "The verdict says what changes and how sure that is."],
    ["Read the curves", "One curve for each bat, tips aligned: how fast the ball leaves from each place. The table below " +
      "gives weight, swing weight, speeds, and the swing that would make up for the difference."],
    ["Change the question", "Choose the bats, the same effort or the same bat speed, and whose rules they are held against. "],
  ],
  paper: [
    ["A paper on the sweet spot", "It asks why the sweet spot is not at the end of the bat. One question after the other: " +
      "what the paper says, and its formulas."],
    ["Move its numbers", "Move a slider under a question and its formula follows, and so does the picture."],
    ["Hold it against the full model", "Below stands every statement three times: the paper's number, its formula worked out " +
      "here, and the full model with the bat and the swing of your choice. "],
  ],
  flight: [
    ["Where the ball goes", "The ball's path from the side and from above, through the air of a park, and over which fences it goes. " +
      "The dashed line is the path that it would take without air."],
    ["Launch it", "Move the sliders for speed, angle and spin, or drag on the field to turn the ball. Or let it start " +
      "from a pitch and a swing."],
    ["Change the weather", "Choose the park, turn the wind, heat the air. The table says what this ball does in every park. "],
  ],
};
const LAST = "The address holds all of it: send it to someone, or go back.";

export function guide(app) {
  const button = Object.assign(document.createElement("button"), { type: "button", id: "guide", textContent: "Guide" });
  button.setAttribute("aria-haspopup", "dialog");
  button.addEventListener("click", () => open(app));
  return button;
}

// On the first visit of this browser, once it is known which view that is.
export function welcome(app) {
  if (!localStorage.getItem("guided")) open(app);
}

function open({ name }) {
  const steps = STEPS[name];
  const dialog = document.createElement("dialog");
  dialog.className = "guide";
  dialog.setAttribute("aria-labelledby", "guide-title");
  dialog.innerHTML = "<p class=\"note\"></p><h2 id=\"guide-title\"></h2><p class=\"words\"></p>" +
    "<div class=\"row\"><button type=\"button\" class=\"back\">Back</button><button type=\"button\" class=\"primary next\"></button>" +
    "<button type=\"button\" class=\"end\">Close</button></div>";
  const part = (name) => dialog.querySelector(name);
  let step = 0;
  const show = () => {
    part(".note").textContent = `Step ${step + 1} of ${steps.length}`;
    const last = step === steps.length - 1;
    const [title, words] = steps[step];
    part("h2").textContent = title;
    part(".words").textContent = last ? words + LAST : words;
    part(".back").disabled = step === 0;
    part(".next").textContent = last ? "Start" : "Next";
  };
  part(".back").addEventListener("click", () => ((step -= 1), show()));
  part(".next").addEventListener("click", () => {
    step += 1;
    if (step === steps.length) dialog.close();
    else show();
  });
  part(".end").addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => {
    localStorage.setItem("guided", "yes");
    dialog.remove();
  });
  show();
  document.body.append(dialog);
  dialog.showModal();
  part(".next").focus();
}
