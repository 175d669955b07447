
// The mesh on a canvas, with pan and zoom. In double precision, not by WebGL: one can zoom into layers of a millionth,
// and it works in every browser.

const chunkSize = 256;  // triangles that are skipped together; the mesher numbers near ones near

class MeshView {
  constructor(canvas, mesh, colours) {
    Object.assign(this, { canvas, mesh, showEdges: true, field: null, frame: 0 });
    this.palette = makePalette(colours);
    this.context = canvas.getContext('2d');
    this.chunks = boundingBoxes(mesh);
    this.bounds = union(this.chunks);
    new ResizeObserver(() => this.resize()).observe(canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.requestDraw());
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(this.canvas.clientWidth * ratio), Math.round(this.canvas.clientHeight * ratio)];
    if (width === 0 || height === 0) return;
    const isFirst = !this.scale;
    const factor = isFirst ? 1 : width / this.canvas.width;
    Object.assign(this.canvas, { width, height });
    this.ratio = ratio;
    if (isFirst) this.reset();
    else this.look({ scale: this.scale * factor });
  }

  // The whole mesh in view.
  reset() {
    const [x0, y0, x1, y1] = this.bounds;
    this.look({ x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale: this.scaleOfAll() });
  }

  scaleOfAll() {
    const [x0, y0, x1, y1] = this.bounds;
    return 0.94 * Math.min(this.canvas.width / (x1 - x0 || 1), this.canvas.height / (y1 - y0 || 1));
  }

  // x, y: the place in the middle; scale: pixels per unit.
  look(view) {
    Object.assign(this, view);
    this.requestDraw();
  }

  // The largest scale at a place: beyond, doubles do not tell the pixels apart, or corners are too far away to draw by.
  limitAt(x, y) {
    const [x0, y0, x1, y1] = this.bounds;
    return 1e13 / Math.max(Math.abs(x), Math.abs(y), 0.01 * Math.max(x1 - x0, y1 - y0));
  }

  goTo(x, y, scale) { this.look({ x, y, scale: Math.min(scale, this.limitAt(x, y)) }); }

  pan(dx, dy) { this.look({ x: this.x - dx / this.scale, y: this.y + dy / this.scale }); }

  // Keeps the place below the pixel where it is, also where the scale comes to its limit.
  zoom(factor, px = this.canvas.width / 2, py = this.canvas.height / 2) {
    const [x, y] = this.placeAt(px, py);
    const scale = Math.min(this.scale * factor, Math.max(this.scale, this.limitAt(x, y)));
    this.look({ scale, x: x - (px - this.canvas.width / 2) / scale, y: y + (py - this.canvas.height / 2) / scale });
  }

  placeAt(px, py) {
    return [this.x + (px - this.canvas.width / 2) / this.scale, this.y - (py - this.canvas.height / 2) / this.scale];
  }

  pixelOf(x, y) {
    return [this.canvas.width / 2 + (x - this.x) * this.scale, this.canvas.height / 2 - (y - this.y) * this.scale];
  }

  setField(field) {
    this.field = field;
    this.requestDraw();
  }

  requestDraw() {
    if (!this.scale) return;  // it has no size yet
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.draw());
  }

  draw() {
    const { context, canvas } = this;
    const image = context.createImageData(canvas.width, canvas.height);
    const target = { pixels: new Uint32Array(image.data.buffer), width: canvas.width, height: canvas.height };
    const colours = getComputedStyle(canvas);  // of the scheme that is on now
    target.pixels.fill(pixelOfColour(colours.getPropertyValue('--page')));
    this.drawTriangles(target);
    context.putImageData(image, 0, 0);
    this.drawBoundary(colours.getPropertyValue('--ink'));
    this.drawWorst();
  }

  drawTriangles(target) {
    const { points, triangles } = this.mesh;
    const [cx, cy] = [this.canvas.width / 2, this.canvas.height / 2];
    const x = [0, 0, 0], y = [0, 0, 0], share = [0, 0, 0];
    const side = this.showEdges ? 0.7 * this.ratio : 0;
    for (const [begin, end] of this.visibleRanges()) {
      for (let t = begin; t < end; ++t) {
        for (let k = 0; k < 3; ++k) {
          const v = triangles[3 * t + k];
          x[k] = cx + (points[2 * v] - this.x) * this.scale;
          y[k] = cy - (points[2 * v + 1] - this.y) * this.scale;
          share[k] = this.field.shareOf(t, v);
        }
        drawTriangle(target, x, y, share, this.palette, side);
      }
    }
  }

  // First and last triangle of each chunk that may be seen.
  visibleRanges() {
    const [x0, y1] = this.placeAt(0, 0), [x1, y0] = this.placeAt(this.canvas.width, this.canvas.height);
    const ranges = [];
    this.chunks.forEach((box, chunk) => {
      if (box[0] > x1 || box[2] < x0 || box[1] > y1 || box[3] < y0) return;
      ranges.push([chunk * chunkSize, Math.min((chunk + 1) * chunkSize, this.mesh.triangles.length / 3)]);
    });
    return ranges;
  }

  drawBoundary(ink) {
    const { points, edges } = this.mesh;
    const context = this.context;
    context.strokeStyle = ink;
    context.lineWidth = 1.2 * this.ratio;
    const atOnce = 256;  // long paths take more than their share of time
    for (let begin = 0; begin < edges.length; begin += 2 * atOnce) {
      context.beginPath();
      for (let e = begin; e < Math.min(begin + 2 * atOnce, edges.length); e += 2) {
        context.moveTo(...this.pixelOf(points[2 * edges[e]], points[2 * edges[e] + 1]));
        context.lineTo(...this.pixelOf(points[2 * edges[e + 1]], points[2 * edges[e + 1] + 1]));
      }
      context.stroke();
    }
  }

  drawWorst() {
    const [px, py] = this.pixelOf(this.mesh.worst.x, this.mesh.worst.y);
    const context = this.context;
    for (const [colour, width] of [['#ffffff', 5], ['#d81b60', 2.5]]) {
      context.beginPath();
      context.arc(px, py, 9 * this.ratio, 0, 2 * Math.PI);
      context.strokeStyle = colour;
      context.lineWidth = width * this.ratio;
      context.stroke();
    }
  }

  // The triangle that holds the place, or -1.
  triangleAt(x, y) {
    const { points, triangles } = this.mesh;
    const side = (a, b) => (points[2 * b] - points[2 * a]) * (y - points[2 * a + 1]) -
      (points[2 * b + 1] - points[2 * a + 1]) * (x - points[2 * a]);
    for (let chunk = 0; chunk < this.chunks.length; ++chunk) {
      const box = this.chunks[chunk];
      if (x < box[0] || x > box[2] || y < box[1] || y > box[3]) continue;
      const end = Math.min((chunk + 1) * chunkSize, triangles.length / 3);
      for (let t = chunk * chunkSize; t < end; ++t) {
        const [a, b, c] = triangles.subarray(3 * t, 3 * t + 3);
        if (side(a, b) >= 0 && side(b, c) >= 0 && side(c, a) >= 0) return t;
      }
    }
    return -1;
  }
}

// [x0, y0, x1, y1] of each chunk.
function boundingBoxes({ points, triangles }) {
  const boxes = [];
  for (let begin = 0; begin < triangles.length; begin += 3 * chunkSize) {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = begin; k < Math.min(begin + 3 * chunkSize, triangles.length); ++k) {
      const x = points[2 * triangles[k]], y = points[2 * triangles[k] + 1];
      if (x < box[0]) box[0] = x;
      if (y < box[1]) box[1] = y;
      if (x > box[2]) box[2] = x;
      if (y > box[3]) box[3] = y;
    }
    boxes.push(box);
  }
  return boxes;
}

function union(boxes) {
  const all = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x0, y0, x1, y1] of boxes) {
    all[0] = Math.min(all[0], x0);
    all[1] = Math.min(all[1], y0);
    all[2] = Math.max(all[2], x1);
    all[3] = Math.max(all[3], y1);
  }
  return all;
}
