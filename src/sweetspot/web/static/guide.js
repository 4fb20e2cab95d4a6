// Three steps for the first visit, and again whenever asked for.

const STEPS = [
  ["A bat, and where it hits best", "The bat is drawn to scale. Coloured marks are its sweet spots: there are several, " +
    "for each answers another question. The green zone is where a hit costs little speed and stings little."],
  ["Drag the ball", "Drag the ball along the bat, or anywhere on the curves. The curves say what a hit at each place " +
    "gives; the numbers below are those of the ball's place. With the keyboard: arrow keys on the picture."],
  ["Change everything", "Move a slider and all follows at once: pitch, swing, hands, ball. Choose another bat, drop a bat " +
    "file on the page, or drill, cork and cup this one. The address holds all of it: send it to someone, or go back."],
];

export function guide(app) {
  const button = Object.assign(document.createElement("button"), { type: "button", id: "guide", textContent: "Guide" });
  button.setAttribute("aria-haspopup", "dialog");
  button.addEventListener("click", () => open(app));
  if (!localStorage.getItem("guided")) setTimeout(() => open(app), 0);
  return button;
}

function open() {
  const dialog = document.createElement("dialog");
  dialog.className = "guide";
  dialog.setAttribute("aria-labelledby", "guide-title");
  dialog.innerHTML = "<p class=\"note\"></p><h2 id=\"guide-title\"></h2><p class=\"words\"></p>" +
    "<div class=\"row\"><button type=\"button\" class=\"back\">Back</button><button type=\"button\" class=\"primary next\"></button>" +
    "<button type=\"button\" class=\"end\">Close</button></div>";
  const part = (name) => dialog.querySelector(name);
  let step = 0;
  const show = () => {
    part(".note").textContent = `Step ${step + 1} of ${STEPS.length}`;
    [part("h2").textContent, part(".words").textContent] = STEPS[step];
    part(".back").disabled = step === 0;
    part(".next").textContent = step === STEPS.length - 1 ? "Start" : "Next";
  };
  part(".back").addEventListener("click", () => ((step -= 1), show()));
  part(".next").addEventListener("click", () => {
    step += 1;
    if (step === STEPS.length) dialog.close();
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
