
// The page: what was run, how the error fell, the mesh, the times; one section per run or comparison.

const stages = ['mesh', 'solve', 'recover', 'measure'];

// The error a run is judged by: of the solution, of the interpolant, or estimated.
function leading(row, norm) {
  return row.solution_error?.[norm] ?? row.estimated_error?.[norm] ?? row.interpolation_error?.[norm] ?? null;
}

// Beside others a run shows only the error that it is judged by.
function runSeries(entry, norm, prefix) {
  const rows = entry.summary.iterations;
  const along = (name, of, dashed = false) => ({ name: prefix + name, dashed,
    points: rows.map((r) => [r.vertices, of(r)]).filter(([, y]) => y !== null && y !== undefined) });
  if (prefix) return [along('', (r) => leading(r, norm))];
  const series = [along('solution', (r) => r.solution_error?.[norm]), along('interpolant', (r) => r.interpolation_error?.[norm]),
    along('estimate', (r) => r.estimated_error?.[norm])];
  const limit = entry.summary.interpolation_limit;
  if (norm === 'l2' && limit) series.push(along('physical limit of the interpolant', (r) => limit / r.triangles, true));
  return series.filter((s) => s.points.length > 0);
}

function compareSeries(entry, norm, prefix, xOf = (r) => r.vertices) {
  const families = [...new Set(entry.summary.rows.map((r) => r.family))];
  const series = families.map((family) => ({ name: prefix + family, points: entry.summary.rows
    .filter((r) => r.family === family && leading(r, norm) !== null).map((r) => [xOf(r), leading(r, norm)]) }));
  return series.filter((s) => s.points.length > 0);
}

// The size of the goal's error, of each run or family of meshes that has a goal.
function goalPlot(parent, entries) {
  const sizes = (rows, of) => rows.map((r) => [r.vertices, of(r)]).filter(([, y]) => y).map(([x, y]) => [x, Math.abs(y)]);
  const series = entries.flatMap((entry) => {
    const prefix = entries.length > 1 ? `${entry.folder} ` : '';
    const rows = entry.summary.iterations ?? entry.summary.rows;
    const groups = entry.kind === 'run' ? [''] : [...new Set(rows.map((r) => r.family))];
    return groups.flatMap((family) => {
      const own = rows.filter((r) => r.goal && (!family || r.family === family));
      const name = `${prefix}${family} `.trimStart();
      return [{ name: `${name}error`, points: sizes(own, (r) => r.goal.error) },
        { name: `${name}estimate`, dashed: true, points: sizes(own, (r) => r.goal.estimate) }];
    });
  }).filter((s) => s.points.length > 0);
  if (series.length === 0) return;
  const levels = entries.filter((e) => e.kind === 'run' && e.case.targets?.goal_error)
    .map((e) => ({ name: `target ${shown(e.case.targets.goal_error)}`, y: e.case.targets.goal_error }));
  logLogPlot(parent, { title: 'Goal error against vertices', xName: 'vertices', yName: 'error of the goal', series, levels,
    slope: -1 });
}

function errorPlots(parent, entries) {
  const plots = element('div', { class: 'plots' });
  parent.append(plots);
  for (const [norm, name, target, slope] of [['l2', 'L2 error', 'l2_error', -1], ['h1', 'H1 error', 'h1_error', -0.5]]) {
    const prefix = (entry) => (entries.length > 1 ? `${entry.folder} ` : '');
    const series = entries.flatMap((e) => (e.kind === 'run' ? runSeries : compareSeries)(e, norm, prefix(e)));
    const levels = entries.filter((e) => e.kind === 'run' && e.case.targets?.[target])
      .map((e) => ({ name: `${prefix(e)}target ${shown(e.case.targets[target])}`, y: e.case.targets[target] }));
    logLogPlot(plots, { title: `${name} against vertices`, xName: 'vertices', yName: name, series, levels, slope });
  }
  goalPlot(plots, entries);
  const compared = entries.filter((e) => e.kind === 'compare');
  if (compared.length === 0) return;
  const series = compared.flatMap((e) => compareSeries(e, 'l2', compared.length > 1 ? `${e.folder} ` : '', (r) => r.cpu_seconds));
  logLogPlot(plots, { title: 'L2 error against processor time', xName: 'CPU seconds', yName: 'L2 error', series });
}

function definitions(pairs) {
  return element('dl', {}, ...pairs.flatMap(([term, text]) => [element('dt', {}, term), element('dd', {}, text)]));
}

function verdict(summary, missed) {
  const reason = endings[summary.stop_reason] ?? summary.stop_reason;
  const met = summary.targets_met ? 'Targets met.' : 'Targets not met.';
  const expected = missed.length ? ` Other than expected: ${missed.join(', ')}.` : '';
  return element('p', { class: summary.targets_met && !missed.length ? 'verdict met' : 'verdict missed' },
    `${met} It stopped because ${reason} (${summary.stop_reason}), after ${summary.iterations.length} iterations.${expected}`);
}

// What the case expects, with what came of it: { name, value, min, max, kept }. As run --verify looks at it.
function expectationsOf({ case: { expect = {} }, summary }) {
  const last = summary.iterations.at(-1) ?? {};
  const valueOf = (path) => [last, summary].map((from) => path.reduce((at, step) => at?.[step], from)).find((v) => v !== undefined) ?? null;
  const judged = (name, path, limits) => {
    const value = valueOf(path);
    if (typeof limits === 'boolean') return { name, value, min: limits, max: limits, kept: value === limits };
    const { min = null, max = null } = limits;
    return { name, value, min, max, kept: value !== null && (min === null || value >= min) && (max === null || value <= max) };
  };
  return Object.entries(expect).filter(([name]) => !name.startsWith('x-')).flatMap(([name, limits]) => {
    if (name !== 'functionals' && name !== 'fluxes') return [judged(name, name.split('.'), limits)];
    return Object.entries(limits).filter(([of]) => !of.startsWith('x-')).map(([of, own]) => judged(`${name}: ${of}`, [name, of], own));
  });
}

function expectationTable(expectations) {
  const text = (x) => (typeof x === 'boolean' ? String(x) : shown(x, 8));
  return table('Expected of the last iteration', ['', '', 'value', 'min', 'max'], expectations.map((e) =>
    [e.name, e.kept ? 'kept' : 'missed', text(e.value), text(e.min), text(e.max)]));
}

// Numbers by name: at the last iteration, at the one before, and what else there is: a name -> a number for each name.
function namedNumbers(caption, rows, key, others = {}) {
  const columns = { value: rows.at(-1)[key], 'an iteration before': rows.at(-2)?.[key] ?? {}, ...others };
  return table(caption, ['', ...Object.keys(columns)], Object.keys(rows.at(-1)[key]).map((name) =>
    [name, ...Object.values(columns).map((numbers) => shown(numbers[name], 8))]));
}

function hasNumbers(rows, key) {
  return Object.keys(rows.at(-1)?.[key] ?? {}).length > 0;
}

function goalTable(rows) {
  return table('Goal', ['#', 'vertices', 'value', 'estimated error', 'error', 'effectivity', 'corrected'], rows.map((r) =>
    [r.iteration ?? r.family, r.vertices, shown(r.goal.value, 8), shown(r.goal.estimate), shown(r.goal.error),
      shown(r.goal.effectivity, 3), shown(r.goal.corrected, 8)].map(String)));
}

function iterationTable(rows) {
  const heads = ['#', 'vertices', 'triangles', 'L2', 'H1', 'estimate / H1', 'L2 interp.', 'efficiency', 'unit edges', 'quality', 'lowest', 'started from', 's', 'MB'];
  return table('Iterations', heads, rows.map((r) => [r.iteration, r.vertices, r.triangles, shown(leading(r, 'l2')),
    shown(leading(r, 'h1')), shown(r.effectivity?.h1, 3), shown(r.interpolation_error?.l2), shown(r.efficiency), `${shown(100 * r.unit_edges, 4)} %`,
    shown(r.quality?.mean, 3), shown(r.quality?.min, 2), (r.start ?? '').replaceAll('_', ' '), shown(r.seconds?.total, 3),
    shown(r.peak_memory_mb, 4)].map(String)));
}

function histograms(parent, all) {
  const plots = element('div', { class: 'plots three' });
  parent.append(plots);
  histogramPlot(plots, { title: 'Edge lengths in the metric (unit: 0.71 to 1.41)', xName: 'length', ...all.lengths,
    good: [Math.SQRT1_2, Math.SQRT2] });
  histogramPlot(plots, { title: 'Angles in the metric', xName: 'degrees', ...all.angles, good: [30, 90], parts: 6 });
  histogramPlot(plots, { title: 'Quality of the triangles (1: equilateral)', xName: 'mean ratio', ...all.qualities,
    good: [0.5, 1], parts: 5 });
}

function runSection(section, entry, number, colours) {
  const rows = entry.summary.iterations;
  const expectations = expectationsOf(entry);
  section.append(verdict(entry.summary, expectations.filter((e) => !e.kept).map((e) => e.name)));
  for (const warning of entry.summary.warnings ?? []) section.append(element('p', { class: 'warning' }, warning));
  section.append(element('h3', {}, 'The case'), definitions(caseInWords(entry.case)));
  if (entry.mesh) {
    section.append(element('h3', {}, `The last mesh: ${entry.mesh.vertices} vertices, ${entry.mesh.triangles} triangles`));
    if (entry.mesh.drawn) views.push(meshPanel(section, number, entry.mesh, colours));
    else section.append(element('p', {}, 'Too large to be drawn here; mesh.vtu can be opened in ParaView.'));
    histograms(section, entry.histograms);
  }
  section.append(iterationTable(rows));
  const withGoal = rows.filter((r) => r.goal);
  if (withGoal.length) section.append(goalTable(withGoal));
  const exact = Object.fromEntries(Object.entries(entry.case.functionals ?? {}).map(([name, f]) => [name, f.exact]));
  if (hasNumbers(rows, 'functionals')) section.append(namedNumbers('Functionals', rows, 'functionals', { exact }));
  if (hasNumbers(rows, 'fluxes')) section.append(namedNumbers('Fluxes n·K grad u through the sides', rows, 'fluxes'));
  if (expectations.length) section.append(expectationTable(expectations));
  columnPlot(section, { title: 'Wall time by stage', xName: 'iteration', yName: 'seconds', parts: stages,
    rows: rows.map((r) => ({ name: String(r.iteration), values: stages.map((s) => r.seconds?.[s] ?? 0) })) });
}

function compareSection(section, entry) {
  const { rows, orders, equal_error: equal, interrupted } = entry.summary;
  if (interrupted) section.append(element('p', { class: 'verdict missed' }, 'It was interrupted: meshes are missing.'));
  section.append(element('h3', {}, 'The case'), definitions(caseInWords(entry.case)),
    table('Meshes', ['mesh', 'vertices', 'triangles', 'L2', 'H1', 'L2 interp.', 'efficiency', 'CPU s'], rows.map((r) =>
      [r.family, String(r.vertices), String(r.triangles), shown(leading(r, 'l2')), shown(leading(r, 'h1')),
        shown(r.interpolation_error?.l2), shown(r.efficiency), shown(r.cpu_seconds, 3)])));
  const withGoal = rows.filter((r) => r.goal);
  if (withGoal.length) section.append(goalTable(withGoal));
  const order = (fit) => (fit ? shown(fit.order, 3) + (fit.points > 2 ? ` ± ${shown(fit.uncertainty, 1)}` : '') : '–');
  section.append(table('Orders fitted to error = c N^(−order)', ['mesh', 'L2', 'H1'],
    Object.entries(orders ?? {}).map(([family, fits]) => [family, order(fits.l2), order(fits.h1)])));
  section.append(table('Uniform vertices and time for the same L2 error',
    ['mesh', 'vertices', 'CPU s', 'L2', 'uniform vertices', 'ratio', 'uniform CPU s'],
    (equal ?? []).map((e) => [e.family, String(e.vertices), shown(e.cpu_seconds, 3), shown(e.l2), e.reached ? shown(e.uniform_vertices, 4) : 'not reached',
      shown(e.ratio, 3), shown(e.uniform_cpu_seconds, 3)])));
}

const views = [];  // of the meshes, for who looks into the page from outside

function buildPage() {
  const data = JSON.parse(document.getElementById('data').textContent);
  const { entries } = data;
  const title = entries.length === 1 ? entries[0].case.title || entries[0].case.name : `${entries.length} runs side by side`;
  document.title = `${title} – Parmesan`;
  const main = element('main', {}, element('h1', {}, title));
  document.body.append(main);
  errorPlots(main, entries);
  entries.forEach((entry, number) => {
    const section = element('section', {});
    main.append(section);
    section.append(element('h2', {}, entries.length === 1 ? entry.case.name : `${entry.folder}: ${entry.case.title || entry.case.name}`));
    if (entry.kind === 'run') runSection(section, entry, number, data.colours);
    else compareSection(section, entry);
  });
  main.append(element('footer', {}, `parmesan ${data.version}; seed ${entries.map((e) => e.summary.seed ?? '–').join(', ')}; ` +
    `folder ${entries.map((e) => e.folder).join(', ')}`));
}

buildPage();
