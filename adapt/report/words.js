
// A case in words.

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

function plain(value) {
  return typeof value === 'string' ? value : JSON.stringify(value);
}

function listed(object) {
  return Object.entries(object).filter(([name]) => !name.startsWith('x-'))
    .map(([name, value]) => `${name} = ${plain(value)}`).join(', ');
}

function geometryInWords(geometry = {}) {
  if (geometry.rectangle) return `rectangle from (${geometry.rectangle.min}) to (${geometry.rectangle.max})`;
  if (geometry.polygon) {
    const holes = geometry.holes?.length ? ` with ${geometry.holes.length} holes` : '';
    return `polygon of ${geometry.polygon.length} corners${holes}`;
  }
  if (geometry.file) return `file ${plain(geometry.file)}`;
  return listed(geometry);
}

function conditionInWords(condition) {
  if (condition.dirichlet !== undefined) return `u = ${plain(condition.dirichlet)}`;
  if (condition.neumann !== undefined) return `n·K grad u = ${plain(condition.neumann)}`;
  if (condition.robin) return `n·K grad u + ${plain(condition.robin.coefficient)} u = ${plain(condition.robin.value)}`;
  return plain(condition);
}

function problemInWords(problem = {}) {
  if (problem.interpolate !== undefined) return [['Function', plain(problem.interpolate)]];
  const words = [['Equation', '−div(K grad u) + b·grad u + c u = f'], ['K', plain(problem.diffusion ?? 1)]];
  if (problem.velocity && plain(problem.velocity) !== '[0,0]') words.push(['b', plain(problem.velocity)]);
  if (problem.reaction) words.push(['c', plain(problem.reaction)]);
  if (problem.source !== undefined || problem.exact === undefined) words.push(['f', plain(problem.source ?? 0)]);
  else words.push(['f', 'derived from the exact solution']);
  if (problem.exact !== undefined) words.push(['Exact solution', plain(problem.exact)]);
  for (const [label, condition] of Object.entries(problem.boundary ?? {})) {
    words.push([label === '*' ? 'On the boundary' : `On ${label}`, conditionInWords(condition)]);
  }
  if (problem.defect_correction) words.push(['Values', 'corrected for what Galerkin’s method adds to the error']);
  return words;
}

function mesherInWords({particles = {}, ...options} = {}) {
  return [['Mesher', listed(options)], ['Particles', listed(particles)]];
}

// Pairs of a term and what it is in this case.
function caseInWords(input) {
  const words = [['Domain', geometryInWords(input.geometry)], ...problemInWords(input.problem)];
  if (input.parameters && Object.keys(input.parameters).length) words.push(['Parameters', listed(input.parameters)]);
  words.push(['Targets', listed(input.targets ?? {}) || 'none'], ['Start', listed(input.initial ?? {})],
    ['Metric', listed(input.metric ?? {})], ...mesherInWords(input.mesher));
  return words;
}
