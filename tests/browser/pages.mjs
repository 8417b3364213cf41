// Looks at the pages of many models in headless Chromium: node pages.mjs FOLDER [FOLDER for pictures], where FOLDER/NAME/index.html is that of NAME.
//
// Needs what view.mjs needs. Ends with status 0 and a line for each look that held, or with all that did not hold.
import assert from 'node:assert/strict';
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { PHONE, WIDE, done, fits, height, opened, shot, still } from './driver.mjs';

const folder = process.argv[2];
const names = readdirSync(folder).filter((name) => existsSync(join(folder, name, 'index.html'))).sort();
/** Screens of 1280 × 800 that a page may have. */
const SCREENS = 12;
/** So many times as wide as a desktop may be what scrolls in a box: a product or a root that no line can break; a matrix of many unknowns. */
const WIDEST = { formula: 3, matrix: 8 };

/** Opens all that is folded: on screens, too, nothing of it may be wider than they are. */
const unfold = (page) => page.evaluate(() => document.querySelectorAll('main details').forEach((each) => { each.open = true; }));

/** Boxes that scroll are not endless and are reached by keyboard. */
async function boxes(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const wrong = await page.evaluate((widest) => [...document.querySelectorAll('main *')]
    .filter((each) => each.scrollWidth > each.clientWidth + 1 && ['auto', 'scroll'].includes(getComputedStyle(each).overflowX))
    .filter((each) => each.tabIndex < 0 || each.scrollWidth > 1280 * (each.querySelector('.matrix') ? widest.matrix : widest.formula))
    .map((each) => `${each.className} of ${each.closest('[id]').id}: ${each.scrollWidth} px, tabindex ${each.tabIndex}: ${each.textContent.trim().slice(0, 60)}`), WIDEST);
  assert.deepEqual(wrong, [], 'no formula is longer than somebody reads, and all can be reached');
}

/** What stands beside each other does not lie on one another, and of the sketch nothing is cut off. */
async function face(page) {
  const end = await page.evaluate(() => document.getElementById('abstract').getBoundingClientRect().bottom);
  assert(end <= 800, `the abstract ends at ${end} px`);
  const on = await page.evaluate(() => {
    const figure = document.querySelector('#abstract > figure')?.getBoundingClientRect();
    const lies = ({ left, top, right, bottom }) => figure && left < figure.right && right > figure.left && top < figure.bottom && bottom > figure.top;
    return [...document.querySelectorAll('nav, #motion h2, #motion figure')].filter((each) => lies(each.getBoundingClientRect())).map((each) => each.localName);
  });
  assert.deepEqual(on, [], 'nothing lies on the sketch');
  const cut = await page.evaluate(() => {
    const sketch = document.querySelector('svg.sketch');
    if (!sketch) return [];
    const { width, height } = sketch.viewBox.baseVal;
    const isOff = (each) => {
      const { x, y, width: wide, height: high } = each.getBBox();
      const line = each.localName === 'path' ? Number(each.getAttribute('stroke-width')) / 2 : 0;
      return x < line || y < line || x + wide + line > width || y + high + line > height;
    };
    return [...sketch.querySelectorAll('path, text')].filter(isOff).map((each) => each.outerHTML);
  });
  assert.deepEqual(cut, [], 'the sketch is whole');
}

async function desktop(page, name) {
  const high = await height(page);
  console.log(`${high} px, ${(high / 800).toFixed(1)} screens`);
  assert(high <= SCREENS * 800, `${high} px are more than ${SCREENS} screens`);
  await fits(page);
  await face(page);
  const [forces, acts] = [await page.inputValue('.view-forces'), page.locator('.view-acts')];
  if (await acts.count()) assert.equal(await acts.isVisible(), forces !== '0', 'what arrows are is told where there are some');
  await shot(page, `${name} first screen`);
  await shot(page, name, { fullPage: true });
  await unfold(page);
  await fits(page);
  await boxes(page);
}

async function phone(page, name) {
  await fits(page);
  await shot(page, `${name} on a phone`, { fullPage: true });
  await unfold(page);
  await fits(page);
  await boxes(page);
}

async function dark(page, name) {
  await fits(page);
  await shot(page, `${name} in the dark`);
}

const wrong = [];
try {
  assert(names.length > 0, `pages in ${folder}`);
  for (const [at, name] of names.entries()) {
    const place = join(folder, name, 'index.html');
    const look = async (how, options, act) => {
      try {
        await opened(`${name} ${how}`, still(options), (page) => act(page, name), place);
      } catch (error) {
        wrong.push(`${name} ${how}: ${error.message}`);
      }
    };
    await look('on a desktop', WIDE, desktop);
    await look('on a phone', PHONE, phone);
    // Colours are those of one style sheet.
    if (at % 5 === 0) await look('in the dark', { ...WIDE, colorScheme: 'dark' }, dark);
  }
} finally {
  done();
}
assert.deepEqual(wrong, [], 'all pages are as they should be');
