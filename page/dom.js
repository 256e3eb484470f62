// Makes elements. Text becomes text: nothing here reads markup.

/** Returns an element with these properties and children. Members whose name has a dash are attributes. */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes('-') || name === 'role' || name === 'for') made.setAttribute(name, value);
    else made[name] = value;
  }
  made.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return made;
}

/** Returns a button. */
export function button(text, onclick, properties = {}) {
  return element('button', { type: 'button', onclick, ...properties }, text);
}

/** Returns a label that holds the control after its text. The text alone is the control's name: what is chosen in it
 * would else be a part of that. */
export function labelled(text, control) {
  control.setAttribute('aria-label', text);
  return element('label', {}, element('span', {}, text), control);
}

/** Returns a list of terms and what they mean, as pairs; nothing for no pairs. */
export function definitions(pairs) {
  if (pairs.length === 0) return null;
  return element('dl', {}, pairs.map(([term, meaning]) =>
    element('div', {}, element('dt', {}, term), element('dd', {}, meaning))));
}
