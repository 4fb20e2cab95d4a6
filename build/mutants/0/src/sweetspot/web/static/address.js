// A view's state as an address and back: /explorer?pitch_speed_mph=85; only what differs from the first picture.

export function addressOf(name, state, defaults) {
  const query = new URLSearchParams();
  for (const [field, value] of Object.entries(state)) {
    if (JSON.stringify(value) === JSON.stringify(defaults[field])) continue;
    query.set(field, typeof value === "string" ? value : JSON.stringify(value));
  }
  const text = query.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
  return `/${name}${text ? `?${text}` : ""}`;
}

// Unknown names are left out; values are read by the schema's type and checked by the server.
export function stateIn(search, schema, defaults) {
  const state = { ...defaults };
  for (const [field, text] of new URLSearchParams(search)) {
    if (!Object.hasOwn(schema, field)) continue;
    state[field] = isText(schema[field]) ? text : parsed(text);
  }
  return state;
}

function isText(property) {
  const choices = property.anyOf ?? [property];
  return choices.some((choice) => choice.type === "string" || choice.enum?.every((item) => typeof item === "string"));
}

function parsed(text) {
  try {
    return JSON.parse(text);
  } catch {
    return text; // the server says what is wrong with it
  }
}
