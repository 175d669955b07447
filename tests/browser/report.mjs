// Looks at report.html in Chromium: no console message, plots and mesh drawn, zoom works, hostile names stay text.
//   node report.mjs PROGRAM FOLDER [keep]    writes below FOLDER; screenshots stay there with keep
// Skipped, with 77, where playwright-core or Chromium is not found.
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { check, finish, launch, open as openPage } from './browser.mjs';

const [program, folder] = process.argv.slice(2, 4).map((path) => resolve(path));

rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });

const hostile = '</script><script>window.hacked=1</script><img src=x onerror="window.hacked=1"> & "quoted"';
const strange = '<img src=x onerror=window.hacked=1>';
const front = {
  name: 'front', title: hostile, 'x-note': '<!--<script>', [`x-${strange}`]: strange,
  geometry: { polygon: [[0, 0], [1, 0], [1, 1], [0, 1]], labels: [hostile, strange, '--><svg onload=window.hacked=1>', 'top'] },
  functionals: { [strange]: { integral: '*' }, [hostile]: { value: [0.5, 0.5] } },
  parameters: { a: 20 },
  problem: { exact: 'atan(a*(hypot(x + 0.05, y + 0.05) - 0.7))', boundary: { '*': { dirichlet: 'exact' } } },
  targets: { l2_error: 2e-3 },
};

const wells = {
  name: 'wells', 'x-note': 'not for the page',
  geometry: {
    rectangle: { min: [-1, -1], max: [1, 1] }, regions: { west: [-0.5, 0] }, segments: [{ from: [0, -1], to: [0, 1], label: 'wall' }],
    holes: [[[0.4, 0.4], [0.6, 0.4], [0.5, 0.6]]],
  },
  problem: {
    diffusion: { west: 3, '*': 1 }, point_sources: [{ at: [-0.5, 0.25], strength: 2e-50 }], discontinuity_capturing: true,
    boundary: { '*': { dirichlet: 0 } },
  },
  solver: { method: 'lu' },
  functionals: { 'mean.west': { integral: 'west', exact: 4e-51 } },
  targets: { vertices: 400, max_iterations: 3 },
  expect: { vertices: { min: 10 }, 'quality.min': { min: 0.99999 }, fluxes: { left: { max: 0 } } },
};

function parmesan(...words) {
  execFileSync(program, words, { cwd: folder, stdio: 'pipe', env: { ...process.env, OMP_NUM_THREADS: '1' } });
}

writeFileSync(join(folder, 'front.json'), JSON.stringify(front));
parmesan('run', 'front.json', '--out', 'front', '-q');
parmesan('run', 'front.json', '--out', strange, '-q', '--set', '/targets/l2_error=1e-2', '--set', '/problem/defect_correction=true',
  '--set', '/initial/continuation=4');
parmesan('compare', 'front.json', '--out', 'compared', '--sizes', '300,900', '-q');
writeFileSync(join(folder, 'wells.json'), JSON.stringify(wells));
parmesan('run', 'wells.json', '--out', 'wells', '-q');
mkdirSync(join(folder, 'cut'));
copyFileSync(join(folder, 'compared/case.json'), join(folder, 'cut/case.json'));
const compared = JSON.parse(readFileSync(join(folder, 'compared/summary.json')));
writeFileSync(join(folder, 'cut/summary.json'), JSON.stringify({ ...compared, interrupted: true }));
parmesan('report', 'cut', '-q', '-o', 'cut.html');
parmesan('report', 'front', strange, 'compared', '-o', 'all.html', '-q');

const browser = await launch();
const open = (name, options) => openPage(browser, join(folder, name), options);

const screenshot = (page, name, fullPage = true) => page.screenshot({ path: join(folder, `${name}.png`), fullPage });

// How many colours the canvas shows, so that an empty one is noticed; and a number for what it shows.
const looked = (page) => page.evaluate(() => {
  const canvas = document.querySelector('canvas');
  const copy = document.createElement('canvas');
  Object.assign(copy, { width: canvas.width, height: canvas.height });
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  const colours = new Set();
  let sum = 0;
  for (let i = 0; i < data.length; i += 4) {
    const colour = data[i] * 65536 + data[i + 1] * 256 + data[i + 2];
    colours.add(colour);
    sum = (sum * 31 + colour) % 1000000007;
  }
  return { colours: colours.size, sum };
});

async function checkPage(page, name, numPlots) {
  check(page.messages.length === 0, `${name}: no console message ${page.messages.join(' | ')}`);
  check(page.requests.length === 1, `${name}: nothing is loaded but the page`);
  check(await page.evaluate(() => window.hacked) === undefined, `${name}: nothing hostile ran`);
  check(await page.locator('img').count() === 0, `${name}: names did not become elements`);
  const marks = await page.locator('figure svg').count();
  check(marks >= numPlots, `${name}: ${marks} plots, ${numPlots} expected`);
  check(!(await page.evaluate(() => /NaN|undefined|Infinity/.test(document.body.innerHTML.replace(/<script[^]*?<\/script>/g, '')))),
    `${name}: no NaN, Infinity or undefined`);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  check(wide <= 0, `${name}: the page does not scroll sideways (${wide} px)`);
}

{
  const page = await open('front/report.html');
  await checkPage(page, 'run', 6);
  check(await page.locator('h1').textContent() === hostile, 'run: the title is shown as it is');
  const rows = JSON.parse(readFileSync(join(folder, 'front/summary.json'))).iterations;
  check(await page.locator('figure').first().locator('path.mark').count() === 3 * rows.length,
    'run: the L2 plot marks solution, interpolant and estimate of every iteration');
  check(await page.locator('.verdict.met').count() === 1, 'run: it says that the targets are met');
  const start = await looked(page);
  check(start.colours > 100, `run: the mesh is drawn, ${start.colours} colours`);
  await screenshot(page, 'run-laptop');
  const canvas = page.locator('canvas');
  await canvas.scrollIntoViewIfNeeded();
  await canvas.focus();
  const scale = () => page.evaluate(() => views[0].scale);
  const before = await scale();
  await page.keyboard.press('+');
  await page.waitForTimeout(200);
  check(Math.abs(await scale() / before - 1.5) < 1e-9, 'run: + zooms by 1.5');
  check((await looked(page)).sum !== start.sum, 'run: zooming changes the picture');
  const box = await canvas.boundingBox();
  const [px, py] = [box.width / 3, box.height / 3];
  const placeThere = () => page.evaluate(([x, y]) => views[0].placeAt(x * views[0].ratio, y * views[0].ratio), [px, py]);
  const kept = await placeThere();
  await page.mouse.move(box.x + px, box.y + py);
  await page.mouse.wheel(0, -300);
  await page.waitForTimeout(200);
  const still = await placeThere();
  check(await scale() > 2 * before, 'run: the wheel zooms');
  check(Math.hypot(kept[0] - still[0], kept[1] - still[1]) < 1e-3, 'run: the place below the pointer stays');
  await page.mouse.down();
  await page.mouse.move(box.x + px + 50, box.y + py + 20);
  await page.mouse.up();
  const dragged = await page.evaluate(([x, y]) => views[0].placeAt(x * views[0].ratio, y * views[0].ratio), [px + 50, py + 20]);
  check(Math.hypot(kept[0] - dragged[0], kept[1] - dragged[1]) < 1e-3, 'run: dragging moves the mesh with the pointer');
  check(/solution .*error .*quality/.test(await page.locator('output').textContent()), 'run: values below the pointer are told');
  const farIn = async () => {
    for (let k = 0; k < 80; ++k) await page.mouse.wheel(0, -300);
    await page.waitForTimeout(300);
  };
  await farIn();
  const [limit, atLimit] = [await scale(), await placeThere()];
  await farIn();
  const beyond = await placeThere();
  check(await scale() === limit, 'run: zooming in has an end');
  check(Math.hypot(atLimit[0] - beyond[0], atLimit[1] - beyond[1]) * limit < 2, 'run: there the place below the pointer stays, too');
  await page.keyboard.press('0');
  await page.keyboard.press('w');
  await page.waitForTimeout(300);
  const worst = rows.at(-1).worst_element;
  const middle = await page.evaluate(() => [views[0].x, views[0].y]);
  check(Math.hypot(middle[0] - worst.x, middle[1] - worst.y) < 1e-9, 'run: w goes to the worst element of summary.json');
  await screenshot(page, 'worst', false);
  await page.keyboard.press('0');
  await page.waitForTimeout(300);
  check((await looked(page)).sum === start.sum, 'run: 0 shows the first picture again');
  for (const field of ['error', 'quality']) {
    await page.locator(`input[value=${field}]`).check();
    await page.waitForTimeout(200);
    check((await looked(page)).sum !== start.sum, `run: colours by ${field}`);
    await screenshot(page, `field-${field}`, false);
  }
}

{
  const page = await open('front/report.html', { viewport: { width: 390, height: 800 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true });
  await checkPage(page, 'phone', 6);
  await screenshot(page, 'run-phone');
}

{
  const page = await open('front/report.html', { colorScheme: 'dark' });
  await checkPage(page, 'dark', 6);
  await screenshot(page, 'run-dark');
}

{
  const page = await open('front/report.html');
  const light = await looked(page);
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForTimeout(300);
  const dark = await open('front/report.html', { colorScheme: 'dark' });
  check((await looked(page)).sum !== light.sum, 'scheme: the mesh is drawn again when the colour scheme changes');
  check((await looked(page)).sum === (await looked(dark)).sum, 'scheme: as a page that is opened in it');
}

{
  const page = await open('wells/report.html');
  await checkPage(page, 'wells', 4);
  const text = (selector) => page.locator(selector).allInnerTexts().then((all) => all.join('\n'));
  const words = await text('dl');
  for (const part of ['−div(K grad u) = f + point sources', '2e-50 at (-0.5, 0.25)', 'rectangle from (-1, -1) to (1, 1)', 'west = (-0.5, 0)', 'label = wall',
    '(0.4, 0.4)', 'west = 3, * = 1', 'discontinuity_capturing = true', 'method = lu', 'mean.west'])
    check(words.includes(part), `wells: the page says ${part}`);
  check(!words.includes('not for the page'), 'wells: notes are left out');
  const last = JSON.parse(readFileSync(join(folder, 'wells/summary.json'))).iterations.at(-1);
  const cells = async (caption) => page.locator('table', { has: page.locator('caption', { hasText: caption }) }).locator('tbody tr').allInnerTexts();
  const near = (shown, value, tolerance = 1e-6) => Math.abs(Number(shown.replaceAll('−', '-')) / value - 1) < tolerance;
  const [functional] = (await cells(/^Functionals/)).map((row) => row.split('\t'));
  check(functional[0] === 'mean.west' && near(functional[1], last.functionals['mean.west']) && near(functional[3], 4e-51),
    `wells: the functional is there, ${functional}`);
  const fluxes = (await cells(/^Fluxes/)).map((row) => row.split('\t'));
  check(fluxes.length === Object.keys(last.fluxes).length && fluxes.every(([name, value]) => near(value, last.fluxes[name])),
    `wells: the fluxes are there, ${fluxes}`);
  const expected = (await cells(/^Expected/)).map((row) => row.split('\t'));
  check(expected.map((row) => `${row[0]} ${row[1]}`).join() === 'vertices kept,quality.min missed,fluxes: left kept',
    `wells: the expectations are judged, ${expected}`);
  check((await text('.verdict.missed')).includes('Other than expected: quality.min.'), 'wells: a miss is said at the top');
  const bar = await page.locator('.colourbar text').allTextContents();
  check(near(bar.at(-1), last.bounds.maximum, 5e-3), `wells: the bar has tiny values, ${bar}`);
  check((await looked(page)).colours > 100, 'wells: and their picture');
  await screenshot(page, 'wells');
}

{
  const page = await open('compared/report.html');
  await checkPage(page, 'compare', 3);
  check(await page.locator('.key').filter({ hasText: 'isotropic' }).count() >= 4, 'compare: the families are named');
  check(await page.getByText('interrupted').count() === 0, 'compare: it went to its end');
  await screenshot(page, 'compare-laptop');
  check(await (await open('cut.html')).getByText('It was interrupted').count() === 1, 'compare: an interrupted one says so');
}

{
  const page = await open('all.html');
  await checkPage(page, 'several', 3 + 2 * 4);
  check(await page.locator('h2').nth(1).textContent() === `${strange}: ${hostile}`, 'several: a hostile folder stays text');
  check(await page.getByText('corrected for what Galerkin').count() === 1, 'several: the corrected run says that it is');
  check(await page.getByText('continuation = 4').count() === 1, 'several: and how it began');
  await screenshot(page, 'several');
}

await finish(browser);
