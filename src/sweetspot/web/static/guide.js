// Three steps for the first visit.
export function guide() {
  return Object.assign(document.createElement("button"), { type: "button", id: "guide", textContent: "Guide" });
}
