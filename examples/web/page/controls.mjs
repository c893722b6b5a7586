// The page's controls, made of plain inputs: groups of radio buttons, and sliders with a box that takes any number.

const element = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};

// Fills a group with radio buttons; `options` are { value, label, disabled }. Where the options are the same as before
// the buttons stay, and with them the keyboard's focus and how far the row is scrolled.
export function choices(fieldset, name, options, chosen, changed) {
  const key = JSON.stringify(options);
  if (fieldset.dataset.options === key) {
    for (const input of fieldset.querySelectorAll("input")) input.checked = input.value === chosen;
    return;
  }
  fieldset.dataset.options = key;
  const labels = options.map(({ value, label, disabled = false }) => {
    const input = element("input", { type: "radio", name, value, checked: value === chosen, disabled });
    input.addEventListener("change", () => changed(value));
    return element("label", {}, input, element("span", { textContent: label }));
  });
  fieldset.replaceChildren(fieldset.querySelector("legend"), ...labels);
}

// Parses typed text. NaN and infinities are numbers here, for the constructors to refuse.
function typed(text) {
  const plain = text.trim().toLowerCase().replace("−", "-").replace("∞", "inf");
  if (plain === "nan") return NaN;
  const infinite = /^([+-]?)inf(inity)?$/.exec(plain);
  if (infinite) return infinite[1] === "-" ? -Infinity : Infinity;
  return plain === "" || Number.isNaN(Number(plain)) ? null : Number(plain);
}

// Fills the group of parameters: each a slider, and a box in which any number may be typed.
export function parameters(fieldset, list, changed) {
  const values = list.map(({ value }) => value);
  const rows = list.map(({ label, value, min, max, step }, index) => {
    const id = `parameter-${index}`;
    const box = element("input", { type: "text", id, value: String(value), inputMode: "text", autocomplete: "off", spellcheck: false });
    const slider = element("input", { type: "range", min, max, step, value });
    slider.setAttribute("aria-label", `${label}, slider`);
    const take = (number) => {
      values[index] = number;
      changed([...values]);
    };
    slider.addEventListener("input", () => {
      box.value = String(Number(slider.value));
      box.removeAttribute("aria-invalid");
      take(Number(slider.value));
    });
    box.addEventListener("input", () => {
      const number = typed(box.value);
      if (number === null) return box.setAttribute("aria-invalid", "true");
      box.removeAttribute("aria-invalid");
      if (Number.isFinite(number)) slider.value = String(number);
      take(number);
    });
    return element("div", { className: "parameter" }, element("label", { htmlFor: id, textContent: label }), box, slider);
  });
  fieldset.replaceChildren(fieldset.querySelector("legend"), ...rows);
  fieldset.hidden = list.length === 0;
}

// A list of readings: { label, value, unit, note }.
export function readings(list, entries) {
  list.replaceChildren(...entries.map(({ label, value, unit = "", note = "" }) => {
    const figure = element("dd", {}, element("span", { className: "value" }, value, unit ? " " : "", element("small", { textContent: unit })));
    figure.append(element("span", { className: "note", textContent: note }));
    return element("div", {}, element("dt", { textContent: label }), figure);
  }));
}
