// What the browser tests share: Chromium by playwright-core, claims that are counted, and skipping with 77.
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

function playwright() {
  const places = [process.env.PARMESAN_PLAYWRIGHT, process.cwd(), '/usr/lib'].filter(Boolean);
  for (const place of places) {
    try {
      return createRequire(join(resolve(place), 'here.js'))('playwright-core');
    } catch {}
  }
  return skip('playwright-core is not installed (npm install playwright-core; PARMESAN_PLAYWRIGHT names the folder)');
}

const { chromium } = playwright();
const executablePath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
if (!executablePath) skip('there is no Chromium');

let failures = 0;
export function check(holds, claim) {
  if (!holds) ++failures;
  console.log(`${holds ? 'ok    ' : 'FAILED'} ${claim}`);
}

export const launch = () => chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu'] });

// A page of its own, with what it says on the console and what it asks for.
export async function open(browser, path, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.messages = [];
  page.requests = [];
  page.on('console', (message) => page.messages.push(message.text()));
  page.on('pageerror', (error) => page.messages.push(String(error)));
  page.on('request', (request) => page.requests.push(request.url()));
  await page.goto(pathToFileURL(path).href);
  await page.waitForTimeout(600);
  return page;
}

export async function finish(browser) {
  await browser.close();
  console.log(failures ? `${failures} FAILED` : 'all passed');
  process.exit(failures ? 1 : 0);
}
