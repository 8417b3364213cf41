// Headless Chromium for a file: what opens it in a browser of its own, and looks that nothing went wrong meanwhile.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const { chromium } = createRequire(join(process.cwd(), 'package.json'))('playwright-core');
const file = process.argv[2];
/** The folder for pictures, if there is one. */
export const pictures = process.argv[3];
const profile = mkdtempSync(join(tmpdir(), 'tripos-view-'));
const flags = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
  '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
];
export const DESKTOP = { viewport: { width: 1200, height: 800 } };
export const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };
/** The screen by which pages are measured. */
export const WIDE = { viewport: { width: 1280, height: 800 } };
export const still = (options) => ({ ...options, reducedMotion: 'reduce' });
export const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
export const shot = async (page, name, options = {}) => {
  if (pictures) await page.screenshot({ path: join(pictures, `${name}.png`), animations: 'disabled', ...options });
};
export const height = (page) => page.evaluate(() => document.documentElement.scrollHeight);
/** What is wider than the screen is in a box that scrolls by itself. */
export const fits = async (page) => {
  const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert(wide <= window, `nothing is wider than the screen: ${wide} on ${window}`);
};
/** Leaves nothing behind. */
export const done = () => rmSync(profile, { recursive: true, force: true });

/** Opens the file, or another, in a browser of its own, does something with it, and looks that nothing went wrong meanwhile. */
export async function opened(name, options, act, place = file) {
  const executablePath = process.env.CHROMIUM || '/usr/bin/chromium';
  const folder = join(profile, name);
  const context = await chromium.launchPersistentContext(folder, { executablePath, headless: true, args: flags, ...options });
  try {
    const page = context.pages()[0] ?? await context.newPage();
    const wrong = [];
    page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) wrong.push(message.text()); });
    page.on('pageerror', (error) => wrong.push(String(error)));
    page.on('request', (request) => { if (!/^(file|data):/.test(request.url())) wrong.push(`asked for ${request.url()}`); });
    await page.goto(pathToFileURL(resolve(place)).href);
    await page.waitForSelector('figure.view.ready', { timeout: 60000 });
    await act(page);
    // What the driver's own software does to be headless is none of the page's business.
    const own = wrong.filter((text) => !/GPU stall|WebGL-.*ReadPixels/.test(text));
    assert.deepEqual(own, [], 'nothing is complained of, nothing is fetched');
  } finally {
    await context.close();
  }
  console.log(`${name}: held`);
}

