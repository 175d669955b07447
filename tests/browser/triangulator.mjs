// Plays with the triangulator of tools/thesis in Chromium: sites come, move and go, and the triangulation stays Delaunay.
//   node triangulator.mjs PAGE FOLDER    a screenshot is left in FOLDER
// Skipped, with 77, where playwright-core or Chromium is not found.
import { mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { check, finish, launch, open } from './browser.mjs';

const [file, folder] = process.argv.slice(2, 4).map((path) => resolve(path));
mkdirSync(folder, { recursive: true });
const browser = await launch();
const page = await open(browser, file);
const box = await page.locator('canvas').boundingBox();
const say = () => page.locator('#text').textContent();

// Laws: 2n - 2 - h triangles for h sites on the hull, no site in the circle of a triangle, areas that sum to the hull's.
const problems = () => page.evaluate(() => {
  if (!mesh) return ['no mesh'];
  const { points, triangles } = mesh;
  const inside = triangles.filter((t) => t[2] !== INFINITE);
  const hull = triangles.length - inside.length;
  const found = [];
  if (inside.length !== 2 * points.length - 2 - hull) found.push('Euler');
  if (inside.some((t) => area(...t.map((v) => points[v])) <= 0)) found.push('orientation');
  const next = new Map(triangles.filter((t) => t[2] === INFINITE).map(([a, b]) => [b, a]));
  let enclosed = 0;
  for (const [a, b] of next) enclosed += 0.5 * (points[a].x * points[b].y - points[b].x * points[a].y);
  const sum = inside.reduce((total, t) => total + 0.5 * area(...t.map((v) => points[v])), 0);
  if (Math.abs(sum - enclosed) > 1e-6 * sum) found.push(`area ${sum} ${enclosed}`);
  for (const t of inside)
    points.forEach((p, v) => { if (!t.includes(v) && inCircle(...t.map((w) => points[w]), p)) found.push(`site ${v}`); });
  return found;
});
async function expectDelaunay(when) {
  const found = await problems();
  check(found.length === 0, `${when}: Delaunay ${found.slice(0, 5).join(', ')}`);
}
const click = (x, y) => page.mouse.click(box.x + x, box.y + y);

for (const [x, y] of [[200, 150], [600, 160], [400, 500], [420, 300]]) await click(x, y);
check((await say()).startsWith('4 sites, 3 triangles'), 'four clicks make three triangles');
await expectDelaunay('four sites');
await click(420, 300);
check((await say()).startsWith('3 sites, 1 triangles'), 'a click on a site removes it');
for (let i = 0; i < 5; ++i) for (let j = 0; j < 5; ++j) await click(100 + 50 * i, 100 + 50 * j);
await expectDelaunay('a grid, cocircular');
await page.locator('#random').click();
await expectDelaunay('many sites');
await page.mouse.move(box.x + 400, box.y + 500);
await page.mouse.down();
await page.mouse.move(box.x + 700, box.y + 450, { steps: 5 });
await page.mouse.up();
check(await page.evaluate(() => nearest({ x: 700, y: 450 }, 2)) >= 0, 'a dragged site comes along');
await expectDelaunay('after a drag');
for (const id of ['voronoi', 'circle']) await page.locator(`#${id}`).check();
await page.locator('#stretch').fill('4');
await expectDelaunay('stretched');
const centres = await page.evaluate(() => voronoiEdges().flat().every((p) => Number.isFinite(p.x) && Number.isFinite(p.y)));
check(centres, 'the Voronoi diagram is finite where it is drawn');
await page.mouse.move(box.x + 300, box.y + 250);
await page.screenshot({ path: join(folder, 'triangulator.png') });
const before = await page.evaluate(() => sites.length);
await page.locator('canvas').focus();
for (const key of ['ArrowLeft', 'ArrowDown', 'Enter']) await page.keyboard.press(key);
check(await page.evaluate(() => sites.length) === before + 1, 'Enter adds a site at the cross');
await page.keyboard.press('Delete');
check(await page.evaluate(() => sites.length) === before, 'Delete removes the nearest');
await page.locator('#clear').click();
check(await say() === 'Click to add sites.', 'Clear clears');
check(page.messages.length === 0, `no console message ${page.messages.join(' | ')}`);
check(page.requests.length === 1, 'nothing is loaded but the page');
await finish(browser);
