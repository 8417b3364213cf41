// Drives a view of a motion in headless Chromium: node view.mjs VIEW.html [FOLDER for pictures]; with LIVE=1 its sliders as well, which it
// must have then.
//
// Needs Chromium (CHROMIUM says where, /usr/bin/chromium if it does not) and the package playwright-core, found from NODE_PATH or the
// folder that this is called in. Ends with status 0 and a line for each thing that held, or with the first that did not.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { DESKTOP, PHONE, done, opened, pictures, shot, wait } from './driver.mjs';

const time = (page) => page.evaluate(() => document.querySelector('figure.view').player.t);
const span = (page) => page.evaluate(() => document.querySelector('figure.view').player.span);
const said = (page) => page.locator('.view-said').innerText();
const picture = (page) => page.evaluate(() => {
  const { player } = document.querySelector('figure.view');
  player.draw();
  return document.querySelector('.view-solids').toDataURL();
});
const stop = (page) => page.evaluate(() => { const { player } = document.querySelector('figure.view'); player.pause(); player.seek(player.from); });
/** Waits, as long as a busy machine takes, for the view to have come farther than this from its start. */
const comes = (page, far) => page.waitForFunction((far) => {
  const { player } = document.querySelector('figure.view');
  return Math.abs(player.t - player.from) > far;
}, far, { timeout: 60000 });

async function desktop(page) {
  // Something is drawn: more than a few colours.
  const colours = await page.evaluate(() => {
    const { player } = document.querySelector('figure.view');
    player.draw();
    const { gl } = player.picture.painter;
    const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return new Set(new Uint32Array(data.buffer)).size;
  });
  assert(colours > 50, `${colours} colours`);

  await stop(page);
  await page.click('.view-play');
  await comes(page, 0);
  await page.click('.view-play');
  const paused = await time(page);
  await wait(200);
  assert.equal(await time(page), paused, 'it pauses');
  assert.match(await said(page), /^At t = /, 'it says where everything is');

  const whole = await span(page);
  const from = await page.evaluate(() => document.querySelector('figure.view').player.from);
  await page.locator('.view-scrub').fill('500');
  const middle = await time(page);
  assert(Math.abs(Math.abs(middle - from) - 0.5 * whole) < 0.01 * whole, `scrubbed to ${middle}`);
  const before = await picture(page);
  const words = await said(page);

  const box = await page.locator('.view-stage').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 120, y + 40, { steps: 5 });
  await page.mouse.up();
  const turned = await picture(page);
  assert.notEqual(turned, before, 'dragging turns the view');
  assert.equal(await time(page), middle, 'and not the time');
  await page.mouse.wheel(0, -300);
  await wait(50);
  assert.notEqual(await picture(page), turned, 'the wheel zooms');
  await page.click('.view-home');
  assert.equal(await picture(page), before, 'the first view comes back');

  await page.focus('.view-stage');
  await page.keyboard.press('Home');
  assert.equal(await time(page), from);
  await page.keyboard.press('ArrowRight');
  const step = Math.abs(await time(page) - from);
  assert(Math.abs(step - 0.01 * whole) < 1e-9 * whole, `a step of ${step}`);
  assert.notEqual(await said(page), words, 'the words follow');
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('+');
  await page.keyboard.press('0');
  await page.keyboard.press('n');
  assert(await page.isChecked('.view-names'), 'n shows names');
  await page.keyboard.press('n');
  if (await page.evaluate(() => document.querySelector('figure.view').player.data.arrows.list.length)) {
    const chosen = () => page.inputValue('.view-forces');
    while (await chosen() === '0') await page.keyboard.press('f');
    const [drawn, told] = [await picture(page), await said(page)];
    assert.match(told, /Forces: .* N/, 'forces are told');
    assert(await page.isVisible('.view-acts'), 'and which arrow is which');
    await page.keyboard.press('f');
    assert.equal(await chosen(), '0', 'f hides forces');
    assert.equal(await page.isVisible('.view-acts'), false, 'nothing is told of arrows that are not there');
    assert.notEqual(await picture(page), drawn, 'arrows are drawn');
    assert.doesNotMatch(await said(page), /Forces: /, 'and not told where they are not shown');
    await page.selectOption('.view-forces', { label: '3 × as long' });
    assert.notEqual(await picture(page), drawn, 'longer arrows are another picture');
    await page.focus('.view-stage');
  }
  await page.keyboard.press(' ');
  await comes(page, step);
  await page.keyboard.press(' ');
  await page.keyboard.press('End');
  const end = await time(page);
  assert(Math.abs(Math.abs(end - from) - whole) < 1e-9 * whole);
  const speed = await page.inputValue('.view-speed');
  await page.keyboard.press('ArrowUp');
  assert(Number(await page.inputValue('.view-speed')) > Number(speed), 'up plays faster');

  // Every control can be reached and has a name.
  const nameless = await page.evaluate(() => [...document.querySelectorAll('.view :is(button, select, input)')]
    .filter((each) => !each.closest('[hidden]') && !(each.ariaLabel || each.labels?.[0]?.textContent.trim() || each.textContent.trim())).length);
  assert.equal(nameless, 0, 'every control has a name');
  await page.locator('.view-scrub').fill('330');
  await shot(page, 'desktop');
}

async function phone(page) {
  await stop(page);
  const wide = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
  assert(wide[0] <= wide[1], `nothing is wider than the screen: ${wide}`);
  const small = await page.evaluate(() => [...document.querySelectorAll('.view :is(button, select)')]
    .map((each) => each.getBoundingClientRect()).filter((box) => box.height && box.height < 38).length);
  assert.equal(small, 0, 'a finger hits every control');
  const before = await picture(page);
  const client = await page.context().newCDPSession(page);
  const box = await page.locator('.view-stage').boundingBox();
  const at = (dx, dy = 0, id = 0) => ({ x: box.x + box.width / 2 + dx, y: box.y + box.height / 2 + dy, id });
  const touch = (type, touchPoints) => client.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', [at(0)]);
  for (const dx of [20, 50, 90]) await touch('touchMove', [at(dx)]);
  await touch('touchEnd', []);
  const turned = await picture(page);
  assert.notEqual(turned, before, 'a finger turns the view');
  const distance = () => page.evaluate(() => document.querySelector('figure.view').player.picture.camera.distance);
  const far = await distance();
  await touch('touchStart', [at(-30, 0, 0), at(30, 0, 1)]);
  for (const d of [40, 60, 80]) await touch('touchMove', [at(-d, 0, 0), at(d, 0, 1)]);
  await touch('touchEnd', []);
  assert(await distance() < far, 'two fingers zoom');
  await page.click('.view-home');
  await page.tap('.view-play');
  await comes(page, 0);
  await page.tap('.view-play');
  await page.evaluate(() => { const { player } = document.querySelector('figure.view'); player.seek(player.from + 0.4 * (player.to - player.from)); });
  await shot(page, 'phone');
}

/** Sliders run the equations again: motion, curve and words follow, and come back. */
async function live(page) {
  const ran = () => page.locator('.view-ran').innerText();
  const curve = () => page.evaluate(() => document.querySelector('.view-curve').toDataURL());
  const follow = async (act) => {
    const before = [await ran(), await curve(), await picture(page)];
    await act();
    await page.waitForFunction((text) => document.querySelector('.view-ran').innerText !== text, before[0], { timeout: 60000 });
    assert(await curve() !== before[1], 'the curve follows');
    return before;
  };
  await stop(page);
  // The curve of the first slider's own quantity: another may be the same wherever this one starts.
  await page.selectOption('.view-quantity', '0');
  await page.evaluate(() => { const { player } = document.querySelector('figure.view'); player.seek(player.from + 0.5 * player.span); });
  assert.match(await ran(), /It is the motion that the command computed/, 'the page runs what the command ran');
  const state = await page.evaluate(() => { const { end } = document.querySelector('figure.view').player.live.first; return [end.t, ...end.y]; });
  console.log(`state: ${JSON.stringify(state)}`);
  assert(await page.isDisabled('.view-reset'), 'there is nothing to reset');

  const slider = page.locator('.view-start input[type=range]').first();
  await slider.focus();
  const first = await follow(() => page.keyboard.press('ArrowRight'));
  assert(await picture(page) !== first[2], 'the motion follows');
  assert.match(await ran(), / in the file\)/, 'the words say what is changed');
  assert(await page.locator('.view-start .changed').count() === 1);
  const closing = (await ran()).match(/ Its loops are (closed by .*?)\. Run/);
  if (closing) {
    console.log(closing[1]);
    const open = await page.evaluate(() => {
      const { model, numbers } = document.querySelector('figure.view').player.live;
      return Math.max(...model.constraints(numbers.p, numbers.start, model.VARIABLES.map(() => 0)).slice(0, model.LOOPS).map(Math.abs));
    });
    assert(open < 1e-13, `closed to ${open}`);
  }
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction((text) => document.querySelector('.view-ran').innerText === text, first[0], { timeout: 60000 });
  assert(await picture(page) === first[2], 'back by the same key');

  // A number can be typed, a start without a motion is told, and all of it comes back.
  const number = page.locator('.view-parameters input[type=number]').last();
  await page.locator('.view-parameters').evaluate((list) => { list.closest('details').open = true; });
  const value = Number(await number.inputValue());
  const second = await follow(async () => { await number.fill(String(1.5 * value)); await number.press('Enter'); });
  assert.match(await ran(), new RegExp(`= ${String(1.5 * value).slice(0, 4)}`), await ran());
  await shot(page, 'live');
  await page.selectOption('.view-quantity', { label: 'T + V' });
  await page.click('.view-reset');
  await page.waitForFunction((text) => document.querySelector('.view-ran').innerText === text, second[0], { timeout: 60000 });
  assert(await picture(page) === second[2], 'the motion of the file comes back');
  assert.equal(Number(await number.inputValue()), value);
  assert(await page.isDisabled('.view-reset'));
  // The curve leads to an instant.
  const box = await page.locator('.view-curve').boundingBox();
  await page.mouse.click(box.x + 0.8 * box.width, box.y + box.height / 2);
  const share = (await time(page) - await page.evaluate(() => document.querySelector('figure.view').player.from)) / await span(page);
  assert(share > 0.7 && share < 0.85, `the curve leads to ${share}`);
}

/** On a phone the picture stays in sight while a slider is moved. */
async function liveOnPhone(page) {
  await stop(page);
  const slider = page.locator('.view-parameters input[type=range]').last();
  await page.locator('.view-parameters').evaluate((list) => { list.closest('details').open = true; });
  await slider.scrollIntoViewIfNeeded();
  const [stage, box] = [await page.locator('.view-stage').boundingBox(), await slider.boundingBox()];
  assert(stage.y > -1 && stage.y + stage.height <= box.y + 1, `picture ${JSON.stringify(stage)}, slider ${JSON.stringify(box)}`);
  const before = await page.locator('.view-ran').innerText();
  await page.touchscreen.tap(box.x + 0.8 * box.width, box.y + box.height / 2);
  await page.waitForFunction((text) => document.querySelector('.view-ran').innerText !== text, before, { timeout: 60000 });
  const wide = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
  assert(wide[0] <= wide[1], `nothing is wider than the screen: ${wide}`);
  await shot(page, 'live on a phone');
}

async function dark(page) {
  await page.evaluate(() => { const { player } = document.querySelector('figure.view'); player.pause(); player.seek(player.from + 0.33 * (player.to - player.from)); });
  const ink = () => page.evaluate(() => getComputedStyle(document.querySelector('.view-said')).color);
  const light = await ink();
  await page.emulateMedia({ colorScheme: 'light' });
  assert.notEqual(await ink(), light, 'dark and light differ');
  await page.emulateMedia({ colorScheme: 'dark' });
  await wait(100);
  await shot(page, 'dark');
}

async function printed(page) {
  await page.emulateMedia({ media: 'print' });
  await wait(200);
  assert.equal(await page.isVisible('.view-bar'), false, 'paper has no buttons');
  assert(await page.isVisible('.view-solids') && await page.isVisible('figcaption'), 'but the picture and its words');
  await shot(page, 'print');
  if (pictures) await page.pdf({ path: join(pictures, 'print.pdf'), printBackground: true }).catch(() => {});
}

async function calm(page) {
  assert.equal(await time(page), await page.evaluate(() => document.querySelector('figure.view').player.from), 'nothing moves by itself');
}

try {
  await opened('desktop', DESKTOP, desktop);
  await opened('phone', PHONE, phone);
  if (process.env.LIVE) {
    await opened('live', DESKTOP, live);
    await opened('live on a phone', PHONE, liveOnPhone);
  }
  await opened('dark', { ...DESKTOP, colorScheme: 'dark' }, dark);
  await opened('print', { ...DESKTOP, reducedMotion: 'reduce' }, printed);
  await opened('reduced motion', { ...DESKTOP, reducedMotion: 'reduce' }, calm);
} finally {
  done();
}
