
// The picture of a mesh with what belongs to it: choice of the colours, colour bar, buttons, keys, readout.

// So many significant digits tell a hundredth of the range apart; 3 to 16.
function digitsFor(low, high) {
  const size = Math.max(Math.abs(low), Math.abs(high));
  return high > low ? Math.max(3, Math.min(16, Math.ceil(Math.log10(size / (high - low))) + 2)) : 3;
}

// What triangles are coloured by. values: per vertex, or per triangle; valueOf: at a triangle.
// shareOf: where on the colour map, 0 to 1, a triangle is at its corner v.
function makeField(name, values, valueOf, { perVertex = false, logarithmic = false } = {}) {
  let low = Infinity, high = -Infinity;
  for (const v of values) {
    if (!Number.isFinite(v) || (logarithmic && v <= 0)) continue;
    if (v < low) low = v;
    if (v > high) high = v;
  }
  if (low > high) [low, high] = logarithmic ? [1e-16, 1] : [0, 1];
  if (logarithmic) low = Math.max(low, high * 1e-6);
  const share = (v) => {
    if (high === low) return 0.5;
    return logarithmic ? Math.log(Math.max(v, low) / low) / Math.log(high / low) : (v - low) / (high - low);
  };
  const shares = Float32Array.from(values, share);
  const digits = logarithmic ? 3 : digitsFor(low, high);
  return { name, low, high, digits, logarithmic, valueOf, shareOf: perVertex ? (t, v) => shares[v] : (t) => shares[t] };
}

function fieldsOf(entry, { triangles }) {
  const solution = carried(entry, 'solution', Float64Array);
  const quality = carried(entry, 'quality', Float32Array);
  const error = carried(entry, 'error', Float64Array);
  const mean = (t) => (solution[triangles[3 * t]] + solution[triangles[3 * t + 1]] + solution[triangles[3 * t + 2]]) / 3;
  const fields = [makeField('solution', solution, mean, { perVertex: true })];
  if (error) fields.push(makeField('error', error, (t) => error[t], { logarithmic: true }));
  fields.push(makeField('quality', quality, (t) => quality[t]));
  return fields;
}

function colourBar(field, colours) {
  const side = Math.max(32, 4 * field.digits), length = Math.max(216, 16 * field.digits);  // for the letters
  const [width, height] = [length + 2 * side, 36];
  const svg = svgElement('svg', { viewBox: `0 0 ${width} ${height}`, width, height, role: 'img',
    'aria-label': `${field.name} from ${shown(field.low, field.digits)} to ${shown(field.high, field.digits)}` });
  const x = (share) => side + length * share;
  colours.forEach((colour, k) => svg.append(svgElement('rect',
    { x: x(k / colours.length), y: 2, width: length / colours.length + 0.5, height: 12, fill: colour })));
  for (const share of [0, 0.5, 1]) {
    const value = field.logarithmic ? field.low * (field.high / field.low) ** share
      : field.low + (field.high - field.low) * share;
    label(svg, x(share), 29, shown(value, field.digits));
  }
  return svg;
}

const keysHelp = 'arrows pan, + and − zoom, 0 shows the whole mesh, w the worst element';

function onKey(view, goToWorst, event) {
  const step = 60 * view.ratio;
  const actions = {
    ArrowLeft: () => view.pan(step, 0), ArrowRight: () => view.pan(-step, 0), ArrowUp: () => view.pan(0, step),
    ArrowDown: () => view.pan(0, -step), '+': () => view.zoom(1.5), '=': () => view.zoom(1.5),
    '-': () => view.zoom(1 / 1.5), 0: () => view.reset(), w: goToWorst,
  };
  if (!actions[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  actions[event.key]();
}

// One pointer pans, two zoom. The wheel zooms where the picture has the focus, so that the page can be scrolled past it.
function followPointers(view) {
  const { canvas } = view;
  const pointers = new Map();
  const place = (event) => [event.offsetX * view.ratio, event.offsetY * view.ratio];
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, size: Math.hypot(a[0] - b[0], a[1] - b[1]) };
  };
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const was = pointers.size === 2 ? spread() : null;
    pointers.set(event.pointerId, place(event));
    if (was) {
      const is = spread();
      view.pan(is.x - was.x, is.y - was.y);
      view.zoom(is.size / Math.max(1, was.size), is.x, is.y);
    } else if (pointers.size === 1) {
      const now = place(event);
      view.pan(now[0] - before[0], now[1] - before[1]);
    }
  });
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, (e) => pointers.delete(e.pointerId));
  canvas.addEventListener('dblclick', (event) => view.zoom(2, ...place(event)));
  canvas.addEventListener('wheel', (event) => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    view.zoom(Math.exp(-Math.max(-200, Math.min(200, event.deltaY)) / 300), ...place(event));
  }, { passive: false });
}

function readout(view, fields, output) {
  view.canvas.addEventListener('pointermove', (event) => {
    const [x, y] = view.placeAt(event.offsetX * view.ratio, event.offsetY * view.ratio);
    const t = view.triangleAt(x, y);
    const values = t < 0 ? ['outside the mesh'] : fields.map((f) => `${f.name} ${shown(f.valueOf(t), f.digits + 1)}`);
    output.textContent = `(${shown(x, 6)}, ${shown(y, 6)})  ${values.join(', ')}`;
  });
}

function meshPanel(parent, entry, about, colours) {
  const mesh = { points: carried(entry, 'points', Float64Array), triangles: carried(entry, 'triangles', Int32Array),
    edges: carried(entry, 'edges', Int32Array), worst: about.worst };
  const fields = fieldsOf(entry, mesh);
  const canvas = element('canvas', { tabindex: '0', role: 'application', 'aria-label': `Picture of the mesh: ${keysHelp}` });
  const view = new MeshView(canvas, mesh, colours);
  const bar = element('div', { class: 'colourbar' });
  const output = element('output', {}, `Keys: ${keysHelp}. The wheel zooms after a click on the picture.`);
  const choose = (field) => {
    view.setField(field);
    bar.replaceChildren(colourBar(field, colours));
  };
  const goToWorst = () => view.goTo(mesh.worst.x, mesh.worst.y, Math.max(view.scale, 40 * view.scaleOfAll()));
  const button = (text, act) => {
    const result = element('button', { type: 'button' }, text);
    result.addEventListener('click', act);
    return result;
  };
  const choices = fields.map((field, k) => {
    const input = element('input', { type: 'radio', name: `field-${entry}`, value: field.name });
    input.checked = k === 0;
    input.addEventListener('change', () => choose(field));
    return element('label', {}, input, ` ${field.name}`);
  });
  const edges = element('input', { type: 'checkbox' });
  edges.checked = true;
  edges.addEventListener('change', () => {
    view.showEdges = edges.checked;
    view.requestDraw();
  });
  parent.append(element('div', { class: 'controls' }, element('fieldset', {}, element('legend', {}, 'Colours'), ...choices),
    element('label', {}, edges, ' edges'), button('+', () => view.zoom(1.5)), button('−', () => view.zoom(1 / 1.5)),
    button('Whole mesh', () => view.reset()), button('Worst element', goToWorst)), canvas, bar, output);
  canvas.addEventListener('keydown', (event) => onKey(view, goToWorst, event));
  followPointers(view);
  readout(view, fields, output);
  choose(fields[0]);
  return view;
}
