
// A case in words. What has no words of its own is listed by its key, so that nothing of a case is left out.

const endings = {
  error_target: 'all error targets were met',
  goal_target: 'all goal targets were met',
  vertices: 'the size aimed at was reached',
  vertex_budget: 'a larger mesh would have exceeded the vertices allowed',
  time_budget: 'the time allowed was over',
  max_iterations: 'the iterations allowed were made',
  unchanged: 'the mesh no longer changed',
  floor: 'the error came down to round-off',
  stagnated: 'more vertices no longer reduced the error, or size limits forbade more',
  interrupted: 'the user interrupted it',
};

const longest = 1000;  // characters of one item; a union of polygons can have millions

function shortened(text) {
  return text.length > longest ? `${text.slice(0, longest)} … (${text.length} characters)` : text;
}

function plain(value) {
  if (Array.isArray(value)) return `(${value.map(plain).join(', ')})`;
  return value !== null && typeof value === 'object' ? `{ ${listed(value)} }` : String(value);
}

// The members of an object, without notes and those that are told elsewhere.
function listed(object, told = []) {
  return Object.entries(object).filter(([name]) => !name.startsWith('x-') && !told.includes(name))
    .map(([name, value]) => `${name} = ${plain(value)}`).join(', ');
}

function geometryInWords(geometry = {}) {
  const { rectangle, polygon, file } = geometry;
  const words = [];
  if (rectangle) words.push(`rectangle from ${plain(rectangle.min)} to ${plain(rectangle.max)}`);
  if (polygon) words.push(`polygon of ${polygon.length} corners`);
  if (file) words.push(`file ${plain(file)}`);
  return [...words, listed(geometry, ['rectangle', 'polygon', 'file'])].filter(Boolean).join('; ');
}

function conditionInWords(condition) {
  if (condition.dirichlet !== undefined) return `u = ${plain(condition.dirichlet)}`;
  if (condition.neumann !== undefined) return `n·K grad u = ${plain(condition.neumann)}`;
  if (condition.robin) return `n·K grad u + ${plain(condition.robin.coefficient)} u = ${plain(condition.robin.value)}`;
  return plain(condition);
}

function problemInWords(problem = {}) {
  if (problem.interpolate !== undefined) return [['Function', plain(problem.interpolate)]];
  const sources = problem.point_sources ?? [];
  const flows = problem.velocity && plain(problem.velocity) !== '(0, 0)';
  const left = ['−div(K grad u)', flows && 'b·grad u', problem.reaction && 'c u'].filter(Boolean).join(' + ');
  const words = [['Equation', `${left} = f${sources.length ? ' + point sources' : ''}`], ['K', plain(problem.diffusion ?? 1)]];
  if (flows) words.push(['b', plain(problem.velocity)]);
  if (problem.reaction) words.push(['c', plain(problem.reaction)]);
  if (problem.source !== undefined || problem.exact === undefined) words.push(['f', plain(problem.source ?? 0)]);
  else words.push(['f', 'derived from the exact solution']);
  if (sources.length) words.push(['Point sources', sources.map((s) => `${plain(s.strength)} at ${plain(s.at)}`).join('; ')]);
  if (problem.exact !== undefined) words.push(['Exact solution', plain(problem.exact)]);
  for (const [label, condition] of Object.entries(problem.boundary ?? {})) {
    words.push([label === '*' ? 'On the boundary' : `On ${label}`, conditionInWords(condition)]);
  }
  const told = ['diffusion', 'velocity', 'reaction', 'source', 'point_sources', 'exact', 'boundary'];
  words.push(['Method', listed(problem, told)]);
  if (problem.defect_correction) words.push(['Values', 'corrected for what Galerkin’s method adds to the error']);
  return words;
}

function mesherInWords({ particles = {}, ...options } = {}) {
  return [['Mesher', listed(options)], ['Particles', listed(particles)]];
}

function inCapitals(name) {
  return name.charAt(0).toUpperCase() + name.slice(1);
}

// Pairs of a term and what it is in this case. "expect" is for the table of what came of it.
function caseInWords(input) {
  const { $schema, name, title, expect, geometry, problem, parameters, targets, initial, metric, mesher, ...others } = input;
  const words = [['Domain', geometryInWords(geometry)], ...problemInWords(problem), ['Parameters', listed(parameters ?? {})],
    ['Targets', listed(targets ?? {}) || 'none'], ['Start', listed(initial ?? {})], ['Metric', listed(metric ?? {})],
    ...mesherInWords(mesher)];
  for (const [key, value] of Object.entries(others)) {
    if (!key.startsWith('x-')) words.push([inCapitals(key), value !== null && typeof value === 'object' ? listed(value) : plain(value)]);
  }
  return words.filter(([, text]) => text).map(([term, text]) => [term, shortened(text)]);
}
