// Drives the page of a model in headless Chromium: node page.mjs index.html [FOLDER for pictures]. SCREENS=N: it is no longer than N
// screens of 1280 × 800.
//
// Needs what view.mjs needs, and ends as it does.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { PHONE, WIDE, done, fits, height, opened, pictures, shot, still, wait } from './driver.mjs';

const folded = (page) => page.evaluate(() => [...document.querySelectorAll('main details:not([open])')].filter((each) => !each.closest('.view')).length);
const player = (page, act) => page.evaluate(`(() => { const { player } = document.querySelector('figure.view'); return (${act})(player); })()`);

async function desktop(page) {
  const high = await height(page);
  console.log(`${high} px, ${(high / 800).toFixed(1)} screens`);
  if (process.env.SCREENS) assert(high <= 800 * Number(process.env.SCREENS), `${high} px`);
  await fits(page);
  // The abstract is what one sees first: all of it.
  const end = await page.evaluate(() => document.getElementById('abstract').getBoundingClientRect().bottom);
  assert(end <= 800, `the abstract ends at ${end} px`);
  await shot(page, 'page', { fullPage: true });
  await shot(page, 'first screen');

  // Every link of the abstract leads to something that is seen.
  const links = await page.locator('#abstract a').evaluateAll((list) => list.map((link) => link.hash));
  assert(links.length > 3, 'the abstract has its evidence');
  for (const [at, hash] of links.entries()) {
    await page.locator('#abstract a').nth(at).click();
    const place = page.locator(`[id="${hash.slice(1)}"]`);
    assert(await place.isVisible(), `${hash} is seen`);
    await page.waitForFunction((id) => {
      const { top, bottom } = document.getElementById(id).getBoundingClientRect();
      return bottom > 0 && top < innerHeight;
    }, hash.slice(1), { timeout: 10000 });
  }
  // What is folded opens for a link into it, a second time as well.
  const inside = page.locator('a[href$="-steps"]').first();
  const target = (await inside.getAttribute('href')).slice(1);
  for (let twice = 0; twice < 2; twice += 1) {
    await inside.click();
    assert(await page.locator(`[id="${target}"]`).evaluate((each) => each.open), `${target} opens`);
    await page.locator(`[id="${target}"]`).evaluate((each) => { each.open = false; });
  }
}

/** The motion begins when it is looked at, stops, and follows a slider if it has some; then the curve does too. */
async function motion(page) {
  assert.equal(await player(page, '(p) => p.t - p.from'), 0, 'nothing moves before somebody has come to it');
  await page.locator('.view-stage').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => {
    const { player } = document.querySelector('figure.view');
    return Math.abs(player.t - player.from) > 0;
  }, undefined, { timeout: 60000 });
  await page.click('.view-play');
  const paused = await player(page, '(p) => p.t');
  await wait(200);
  assert.equal(await player(page, '(p) => p.t'), paused, 'it pauses');
  const slider = page.locator('.view-start input[type=range]').first();
  if (!(await page.locator('.view-live').count())) {
    assert.match(await page.locator('.view-rests').innerText(), /nothing of it can be changed here, since/);
    return;
  }
  const drawn = () => page.evaluate(() => {
    const { player } = document.querySelector('figure.view');
    player.draw();
    return ['.view-curve', '.view-solids'].map((name) => document.querySelector(name).toDataURL());
  });
  await player(page, '(p) => p.seek(p.from + 0.5 * p.span)');
  await page.locator('.view-start').evaluate((list) => { list.closest('details').open = true; });
  // The curve of the slider's own quantity: another may be the same wherever this one starts.
  await page.selectOption('.view-quantity', '0');
  const said = await page.locator('.view-ran').innerText();
  const before = await drawn();
  await slider.focus();
  for (let steps = 0; steps < 5; steps += 1) await page.keyboard.press('ArrowRight');
  await page.waitForFunction((text) => document.querySelector('.view-ran').innerText !== text, said, { timeout: 60000 });
  const after = await drawn();
  assert(after[0] !== before[0] && after[1] !== before[1], 'curve and motion follow the slider');
  await shot(page, 'motion');
  await page.click('.view-reset');
  await page.waitForFunction((text) => document.querySelector('.view-ran').innerText === text, said, { timeout: 60000 });
  assert.deepEqual(await drawn(), before, 'and come back');
}

async function phone(page) {
  await fits(page);
  console.log(`${await height(page)} px on a phone`);
  await shot(page, 'page on a phone', { fullPage: true });
}

async function dark(page) {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const before = await ground();
  await page.emulateMedia({ colorScheme: 'light' });
  assert.notEqual(await ground(), before, 'dark and light differ');
  await page.emulateMedia({ colorScheme: 'dark' });
  await wait(100);
  await shot(page, 'page in the dark', { fullPage: true });
}

/** On paper the open parts are seen; a button unfolds all. */
async function paper(page) {
  const before = await folded(page);
  assert(before > 3, `${before} parts are folded`);
  await page.emulateMedia({ media: 'print' });
  const short = await height(page);
  await page.emulateMedia({ media: 'screen' });
  await page.click('#unfold');
  assert.equal(await folded(page), 0, 'a button unfolds all parts');
  await page.emulateMedia({ media: 'print' });
  assert((await height(page)) > 1.5 * short, 'folded parts are not on paper');
  assert.equal(await page.isVisible('.view-bar'), false, 'paper has no buttons');
  if (pictures) await page.pdf({ path: join(pictures, 'page.pdf'), printBackground: true, format: 'A4' });
}

try {
  await opened('page', still(WIDE), desktop);
  await opened('motion in the page', WIDE, motion);
  await opened('page on a phone', still(PHONE), phone);
  await opened('page in the dark', { ...still(WIDE), colorScheme: 'dark' }, dark);
  await opened('page on paper', still(WIDE), paper);
} finally {
  done();
}
