
// Plots in SVG, drawn anew when their width changes so that letters keep their size.

const plotHeight = 300;
const margin = { left: 62, right: 14, top: 10, bottom: 42 };

function framed(parent, title, draw) {
  const figure = element('figure', {}, element('figcaption', {}, title));
  parent.append(figure);
  let width = 0;
  new ResizeObserver(() => {
    const now = Math.floor(figure.clientWidth);
    if (now === width || now < 50) return;
    width = now;
    figure.querySelector('svg')?.remove();
    const svg = svgElement('svg', { width, height: plotHeight, role: 'img', 'aria-label': title });
    figure.append(svg);
    draw(svg, { left: margin.left, right: width - margin.right, top: margin.top, bottom: plotHeight - margin.bottom });
  }).observe(figure);
  return figure;
}

function line(svg, x1, y1, x2, y2, kind) {
  svg.append(svgElement('line', { x1, y1, x2, y2, class: kind }));
}

function label(svg, x, y, text, anchor = 'middle', extra = {}) {
  svg.append(svgElement('text', { x, y, 'text-anchor': anchor, ...extra }, text));
}

function axisNames(svg, box, xName, yName) {
  label(svg, (box.left + box.right) / 2, plotHeight - 6, xName);
  const y = (box.top + box.bottom) / 2;
  label(svg, 13, y, yName, 'middle', { transform: `rotate(-90 13 ${y})` });
}

// From values to pixels on a logarithmic axis.
function logScale(low, high, from, to) {
  const a = Math.log10(low), b = Math.log10(high);
  return (x) => from + (to - from) * (Math.log10(x) - a) / (b - a);
}

// Powers of ten, with other round numbers between them where there are few.
function logTicks(low, high) {
  const decades = Math.log10(high / low);
  const factors = decades < 1 ? [1, 1.5, 2, 3, 4, 5, 6, 8] : decades < 2.5 ? [1, 2, 5] : [1];
  const step = Math.max(1, Math.round(decades / 7));
  const ticks = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); e += step) {
    for (const f of factors) {
      const x = Number(`${f}e${e}`);
      if (x >= low * 0.999 && x <= high * 1.001) ticks.push(x);
    }
  }
  return ticks;
}

function tickText(x) {
  if (x >= 1 && x < 1e4) return String(x);
  return Number(x.toPrecision(2)).toExponential().replace('e+', 'e').replace('-', '−');
}

function logAxes(svg, box, x, y, xTicks, yTicks) {
  for (const t of xTicks) {
    line(svg, x(t), box.top, x(t), box.bottom, 'grid');
    label(svg, x(t), box.bottom + 16, tickText(t));
  }
  for (const t of yTicks) {
    line(svg, box.left, y(t), box.right, y(t), 'grid');
    label(svg, box.left - 6, y(t) + 4, tickText(t), 'end');
  }
}

const marks = [
  (x, y) => `M${x - 4},${y}a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z`,
  (x, y) => `M${x - 4},${y - 4}h8v8h-8z`,
  (x, y) => `M${x},${y - 5}l5,9h-10z`,
  (x, y) => `M${x},${y - 5}l5,5l-5,5l-5,-5z`,
];

function drawSeries(svg, series, number, x, y) {
  const kind = `series${number % 6}${series.dashed ? ' dashed' : ''}`;
  const places = series.points.map(([a, b]) => `${x(a)},${y(b)}`).join(' ');
  svg.append(svgElement('polyline', { points: places, class: kind }));
  if (series.dashed) return;
  for (const [a, b] of series.points) {
    svg.append(svgElement('path', { d: marks[number % marks.length](x(a), y(b)), class: `mark ${kind}` },
      svgElement('title', {}, `${series.name}: ${shown(a)}, ${shown(b)}`)));
  }
}

// A triangle whose long side falls with this slope, below the curves.
function drawSlope(svg, box, x, y, slope, points) {
  const first = box.left + 0.42 * (box.right - box.left), last = box.left + 0.62 * (box.right - box.left);
  const perPixel = (y(0.1) - y(1)) / (x(10) - x(1));  // pixels down per pixel right at slope -1
  const drop = -slope * perPixel * (last - first);
  const near = points.filter(([a]) => x(a) >= first - 30 && x(a) <= last + 30).map(([, b]) => y(b));
  const top = Math.min(Math.max(box.top, ...near) + 16, box.bottom - drop - 18);
  const d = `M${first},${top}L${last},${top + drop}H${first}Z`;
  svg.append(svgElement('path', { d, class: 'slope' }));
  label(svg, (first + last) / 2, top + drop + 14, '1');
  label(svg, first - 5, top + drop / 2 + 4, shown(-slope), 'end');
}

function legend(figure, series, levels) {
  const items = series.map((s, k) => element('span', { class: `key key${k % 6}${s.dashed ? ' dashed' : ''}` }, s.name));
  for (const level of levels) items.push(element('span', { class: 'key level' }, level.name));
  figure.append(element('p', { class: 'legend' }, ...items));
}

// series: { name, points: [[x, y]...], dashed }; levels: { name, y }, horizontal lines; slope: of the mark.
function logLogPlot(parent, { title, xName, yName, series, levels = [], slope = null }) {
  const positive = series.map((s) => ({ ...s, points: s.points.filter(([a, b]) => a > 0 && b > 0) }))
    .filter((s) => s.points.length > 0);
  if (positive.length === 0) return;
  const points = positive.flatMap((s) => s.points);
  const xs = points.map((p) => p[0]), ys = [...points.map((p) => p[1]), ...levels.map((l) => l.y)];
  const [x0, x1] = [Math.min(...xs) / 1.15, Math.max(...xs) * 1.15];
  const [y0, y1] = [Math.min(...ys) / (slope ? 3 : 1.5), Math.max(...ys) * 1.5];
  const figure = framed(parent, title, (svg, box) => {
    const x = logScale(x0, x1, box.left, box.right), y = logScale(y0, y1, box.bottom, box.top);
    logAxes(svg, box, x, y, logTicks(x0, x1), logTicks(y0, y1));
    axisNames(svg, box, xName, yName);
    for (const level of levels) line(svg, box.left, y(level.y), box.right, y(level.y), 'level');
    if (slope) drawSlope(svg, box, x, y, slope, points);
    positive.forEach((s, k) => drawSeries(svg, s, k, x, y));
  });
  legend(figure, positive, levels);
}

// counts between bounds; good: between these bounds bars have the usual colour; parts: of the axis, 0 where it is
// logarithmic.
function histogramPlot(parent, { title, xName, bounds, counts, good, parts = 0 }) {
  const total = Math.max(1, counts.reduce((a, b) => a + b, 0));
  const largest = Math.max(...counts) / total;
  framed(parent, title, (svg, box) => {
    const low = bounds[0], high = bounds[bounds.length - 1];
    const linear = (v) => box.left + (box.right - box.left) * (v - low) / (high - low);
    const x = parts ? linear : logScale(low, high, box.left, box.right);
    const y = (share) => box.bottom - (box.bottom - box.top) * share / (1.05 * largest);
    for (let k = 0; k <= 4; ++k) {
      const share = largest * k / 4;
      line(svg, box.left, y(share), box.right, y(share), 'grid');
      label(svg, box.left - 6, y(share) + 4, `${shown(100 * share, 2)} %`, 'end');
    }
    counts.forEach((count, k) => {
      const inside = bounds[k] >= good[0] * 0.999 && bounds[k + 1] <= good[1] * 1.001;
      const bar = { x: x(bounds[k]) + 0.5, y: y(count / total), width: Math.max(0.5, x(bounds[k + 1]) - x(bounds[k]) - 1),
        height: box.bottom - y(count / total), class: inside ? 'bar' : 'bar outside' };
      const text = `${shown(bounds[k], 3)} to ${shown(bounds[k + 1], 3)}: ${count} (${shown(100 * count / total, 3)} %)`;
      svg.append(svgElement('rect', bar, svgElement('title', {}, text)));
    });
    const evenTicks = Array.from({ length: parts + 1 }, (_, k) => low + (high - low) * k / parts);
    const ticks = parts ? evenTicks : logTicks(low, high);
    for (const t of ticks) label(svg, x(t), box.bottom + 16, shown(t, 2));
    axisNames(svg, box, xName, 'share');
  });
}

// One column per row, of parts that add up. parts: names; rows: { name, values }.
function columnPlot(parent, { title, xName, yName, parts, rows }) {
  const largest = Math.max(1e-12, ...rows.map((r) => r.values.reduce((a, b) => a + b, 0)));
  const figure = framed(parent, title, (svg, box) => {
    const y = (v) => box.bottom - (box.bottom - box.top) * v / (1.05 * largest);
    const step = (box.right - box.left) / rows.length;
    for (let k = 0; k <= 4; ++k) {
      line(svg, box.left, y(largest * k / 4), box.right, y(largest * k / 4), 'grid');
      label(svg, box.left - 6, y(largest * k / 4) + 4, shown(largest * k / 4, 2), 'end');
    }
    rows.forEach((row, r) => {
      let below = 0;
      row.values.forEach((value, k) => {
        const bar = { x: box.left + step * (r + 0.1), y: y(below + value), width: 0.8 * step,
          height: y(below) - y(below + value), class: `part${k}` };
        svg.append(svgElement('rect', bar, svgElement('title', {}, `${row.name}, ${parts[k]}: ${shown(value, 3)}`)));
        below += value;
      });
      if (r % Math.ceil(rows.length / 12) === 0) label(svg, box.left + step * (r + 0.5), box.bottom + 16, row.name);
    });
    axisNames(svg, box, xName, yName);
  });
  figure.append(element('p', { class: 'legend' },
    ...parts.map((name, k) => element('span', { class: `key keypart${k}` }, name))));
}
