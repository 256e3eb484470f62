// What there is to say about an object.
import { definitions, element } from '../dom.js';

function number(value) {
  return String(Math.round(value * 100) / 100);
}

/** Returns a length in metres, or below one in centimetres. */
function length(metres) {
  return Math.abs(metres) >= 1 || metres === 0 ? `${number(metres)} m` : `${number(metres * 100)} cm`;
}

function sizeText({ size: [width, height, depth] }) {
  return `${length(width)} wide, ${length(depth)} deep, ${length(height)} high`;
}

/** Places are those of the program: x to the right, y into the depth, z up; the box's lowest corner. */
function placeText({ box: { min, max } }) {
  return `x ${number(min.x)}, y ${number(-max.z)}, z ${number(min.y)} (metres)`;
}

function valueText(value) {
  return typeof value === 'string' ? value : JSON.stringify(value);
}

function choiceList(choices) {
  return element('ul', {}, choices.map(({ at, value }) =>
    element('li', {}, element('code', {}, at), ` = ${valueText(value)}`)));
}

function textList(texts, className) {
  return element('ul', { className }, texts.map((text) => element('li', {}, text)));
}

/** Returns the heading and the facts of an object; `pair` says, in a comparison, how it differs. */
export function objectDetails(object, pair) {
  const facts = [
    ['address', element('code', {}, object.address)],
    ['source', element('code', {}, object.source)],
    ...(object.path.length > 1 ? [['within', object.path.slice(1).join(' / ')]] : []),
    ['size', sizeText(object)],
    ['place', placeText(object)],
    ...object.facts.map(([name, value]) => [name, valueText(value)]),
    ...(pair?.words?.length ? [['differs', pair.words.join(', ')]] : []),
    ...(object.broken.length > 0 ? [['broken', textList(object.broken, 'broken')]] : []),
    ...(object.unmet.length > 0 ? [['unmet', textList(object.unmet, 'unmet')]] : []),
    ...(object.choices.length > 0 ? [['choices', choiceList(object.choices)]] : []),
  ];
  return element('section', {}, element('h3', {}, object.name), definitions(facts));
}
