
// Elements. Whatever comes from a case or a file name enters the page as text, never as markup.

function element(tag, attributes = {}, ...children) {
  const result = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

function svgElement(tag, attributes = {}, ...children) {
  const result = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

// A number with so many significant digits; '–' for what is absent.
function shown(x, digits = 4) {
  if (x === null || x === undefined || !Number.isFinite(x)) return '–';
  if (Number.isInteger(x) && Math.abs(x) < 1e9) return String(x);
  const size = Math.abs(x);
  const text = size >= 1e6 || size < 1e-3 ? x.toExponential(digits - 1) : x.toPrecision(digits);
  return text.replace(/(\.\d*?)0+(e|$)/, '$1$2').replace(/\.(e|$)/, '$1').replace('e+', 'e').replaceAll('-', '−');
}

// The numbers of an array that the page carries in base64, or null.
function carried(entry, name, Type) {
  const script = document.getElementById(`array-${entry}-${name}`);
  if (!script) return null;
  const text = atob(script.textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new Type(bytes.buffer);
}

// A table that scrolls sideways in itself on a narrow screen, also by keyboard.
function table(caption, heads, rows) {
  const line = (tag, cells) => element('tr', {}, ...cells.map((cell) => element(tag, {}, cell)));
  const content = element('table', {}, element('caption', {}, caption), element('thead', {}, line('th', heads)),
    element('tbody', {}, ...rows.map((cells) => line('td', cells))));
  return element('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': caption }, content);
}
