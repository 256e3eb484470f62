// The page of a run in a real browser, from the disk. SOLITAIRE_PROGRAM names the program that writes it.
import assert from 'node:assert/strict';
import { readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { generated, launched, opened, ran, ready, workplace } from './browser.mjs';
import { areas, kColours, seen, share } from './pixels.mjs';
import { texturedModel } from './textured_model.mjs';

// A floor of 8 x 8 m with a wall at its front, five red boxes, two blue ones and a green one that a choice moves.
const kBlocks = `
param boxes = 5;
x = range(0, 6);
place("", at: [0, 0, 0], size: [8, 8, 0.1], color: [0.9, 0.9, 0.9], name: "floor");
place("", at: [0, 0, 0], size: [8, 0.2, 2.5], color: [0.9, 0.9, 0.9], name: "front wall");
for i in 0..boxes - 1: place("", at: [1.5 * i + 0.7, 1, 0.1], size: [0.6, 0.6, 0.6], color: [0.9, 0.05, 0.05], name: "red box");
for i in 0..1: place("", at: [3 * i + 2, 3, 0.1], size: [1, 1, 1], color: [0.05, 0.05, 0.9], name: "blue box");
place("", at: [x, 6, 0.1], size: [1, 1, 1], color: [0.05, 0.7, 0.05], name: "green box", purpose: "moves");
minimize(abs(x - 3));
return x, boxes;
`;

let browser, folder, blocks;

before(async () => {
  browser = await launched();
  folder = await workplace();
  blocks = await generated(folder.path, 'blocks', kBlocks, '--all', '--set', 'boxes=5');
});

after(async () => {
  await browser?.close();
  await folder?.remove();
});

/** Opens a page, does something with it, and sees that nothing went wrong in it. */
async function withPage(address, act, settings) {
  const { page, troubles, close } = await opened(browser, address, settings);
  try {
    await act(page);
    assert.deepEqual(troubles, []);
  } finally {
    await close();
  }
}

const shownNames = (page) => page.locator('article:visible h2').allTextContents();
const canvasOf = (page, at = 0) => page.locator('dialog canvas').nth(at);
const panelOf = (page) => page.locator('dialog aside');
const arranged = (page) => page.locator('.toolbar[aria-busy]').waitFor({ state: 'detached' });

async function openFirst(page) {
  await page.locator('article h2 a').first().click();
  await ready(page);
}

async function numberOf(page, colour, at) {
  return areas(await seen(page, canvasOf(page, at)), kColours[colour]).length;
}

async function clickOn(page, colour) {
  const [area] = areas(await seen(page, canvasOf(page)), kColours[colour]);
  await canvasOf(page).click({ position: { x: area.x, y: area.y } });
}

test('solutions are filtered and sorted by value, cost, param, choice, distance', async () => {
  await withPage(blocks, async (page) => {
    assert.equal((await shownNames(page)).length, 7);
    await page.getByLabel('Filter').fill('cost<2');
    await arranged(page);
    assert.deepEqual(await shownNames(page), ['blocks-0001', 'blocks-0002', 'blocks-0003']);
    assert.match(await page.locator('.toolbar [role=status]').textContent(), /3 of 7 solutions/);
    await page.getByLabel('Filter').fill('value[0] >= 5 boxes = 5 cost');
    await arranged(page);
    assert.equal((await shownNames(page)).length, 2);
    await page.getByLabel('Filter').fill('x=6');  // a choice
    await arranged(page);
    assert.match(await page.locator('article:visible .value').textContent(), /^\[6, 5\]/);
    await page.getByLabel('Filter').fill('height > 3');
    await arranged(page);
    assert.match(await page.locator('.toolbar [role=status]').textContent(), /0 of 7 solutions; no solution has “height”/);
    await page.getByLabel('Filter').fill('');
    await page.getByLabel('Sort by').selectOption('value[0]');
    await arranged(page);
    const values = async () => (await page.locator('article:visible .value').allTextContents()).map((text) => text[1]);
    assert.deepEqual(await values(), [...'0123456']);
    await page.getByRole('button', { name: 'Ascending' }).click();
    await arranged(page);
    assert.deepEqual(await values(), [...'6543210']);
    await page.getByRole('button', { name: 'Descending' }).click();
    await page.getByLabel('Sort by').selectOption('distance');
    await page.getByLabel('from').selectOption('5');
    await arranged(page);
    assert.equal((await shownNames(page))[0], 'blocks-0005');
    assert.deepEqual(await page.locator('.distance').allTextContents(), ['distance 0.00', ...Array(6).fill('distance 1.00')]);
  });
});

test('a scene opens in 3D: every object is seen, and turning and zooming change the view', async () => {
  await withPage(blocks, async (page) => {
    await openFirst(page);
    assert.equal(await numberOf(page, 'red'), 5);  // the wall before them is cut off low
    assert.equal(await numberOf(page, 'blue'), 2);
    assert.equal(await numberOf(page, 'green'), 1);
    const before = await seen(page, canvasOf(page));
    const largest = (picture) => areas(picture, kColours.green)[0].pixels;
    await page.keyboard.press('ArrowRight');
    const turned = await seen(page, canvasOf(page));
    assert.notDeepEqual(turned.data, before.data);
    for (let i = 0; i < 3; ++i) await page.keyboard.press('+');
    assert.ok(largest(await seen(page, canvasOf(page))) > 1.3 * largest(turned));
    await page.getByRole('button', { name: 'Reset view' }).click();
    assert.deepEqual((await seen(page, canvasOf(page))).data, before.data);
    const box = await canvasOf(page).boundingBox();
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 320, box.y + 180, { steps: 4 });
    await page.mouse.up();
    assert.notDeepEqual((await seen(page, canvasOf(page))).data, before.data);
  });
});

test('a picked object says what it is; the list and the drawings pick, too', async () => {
  await withPage(blocks, async (page) => {
    await openFirst(page);
    await clickOn(page, 'green');
    const details = panelOf(page).locator('.details');
    await details.getByRole('heading', { name: 'green box' }).waitFor();
    const text = await details.textContent();
    assert.match(text, /sourceblocks\.sol:8:1/);
    assert.match(text, /addressplace/);
    assert.match(text, /choicesx = 3/);
    assert.match(text, /purposemoves/);
    assert.match(text, /1 m wide, 1 m deep, 1 m high/);
    assert.match(text, /x 3, y 6, z 0\.1/);
    await panelOf(page).getByLabel('Objects').selectOption({ label: 'front wall' });
    await details.getByRole('heading', { name: 'front wall' }).waitFor();
    await page.getByLabel('View', { exact: true }).selectOption('Plan');
    await page.locator('.drawing [data-address]', { has: page.locator('title', { hasText: 'green box' }) }).click();
    await details.getByRole('heading', { name: 'green box' }).waitFor();
    assert.equal(await page.locator('.drawing .selected').count(), 1);
  });
});

test('one walks at eye height, and not through things', async () => {
  await withPage(blocks, async (page) => {
    await openFirst(page);
    const whole = await seen(page, canvasOf(page));
    await page.getByRole('button', { name: 'Walk', exact: true }).click();
    const start = await seen(page, canvasOf(page));
    assert.notDeepEqual(start.data, whole.data);
    await page.keyboard.down('w');
    await page.waitForTimeout(500);
    await page.keyboard.up('w');
    const further = await seen(page, canvasOf(page));
    assert.notDeepEqual(further.data, start.data);
    await page.keyboard.down('ArrowLeft');
    await page.waitForTimeout(300);
    await page.keyboard.up('ArrowLeft');
    assert.notDeepEqual((await seen(page, canvasOf(page))).data, further.data);
    const forward = page.getByRole('button', { name: 'Forward' });
    await forward.hover();
    await page.mouse.down();
    await page.waitForTimeout(300);
    await page.mouse.up();
    await page.getByRole('button', { name: 'Walk', exact: true }).click();
    assert.deepEqual((await seen(page, canvasOf(page))).data, whole.data);
  });
});

// A passage of 1.4 x 6 m with a wall across its middle, a step of 20 cm before that and a green box behind; in one of two
// solutions the wall has a door.
const kPassage = `
door = flip();
place("", at: [0, 0, 0], size: [1.4, 6, 0.1], color: [0.9, 0.9, 0.9], name: "floor");
for side in [0, 1.3]: place("", at: [side, 0, 0.1], size: [0.1, 6, 2.5], color: [0.9, 0.9, 0.9], name: "wall");
place("", at: [0.1, 2, 0.1], size: [1.2, 3.8, 0.2], color: [0.9, 0.9, 0.9], name: "step");
place("", at: [0.1, 3, 0.1], size: [1.2, 0.2, 2.5], color: [0.9, 0.9, 0.9], name: "wall");
if door then place("door", at: [0.25, 2.98, 0.3]);
place("", at: [0.2, 5.3, 0.3], size: [1, 0.5, 2], color: [0.05, 0.7, 0.05], name: "green box");
return door;
`;

/** Lets somebody walk for so many seconds: a frame that takes longer than a tenth of a second counts as one. */
async function walking(page, seconds) {
  await page.evaluate((wanted) => new Promise((done) => {
    let last = performance.now(), walked = 0;
    const tick = (now) => {
      walked += Math.min((now - last) / 1000, 0.1);
      last = now;
      if (walked < wanted) requestAnimationFrame(tick);
      else done();
    };
    requestAnimationFrame(tick);
  }), seconds);
}

test('one walks up steps and through doors, and walls stop: by keys and by touch', async () => {
  const address = await generated(folder.path, 'passage', kPassage, '--all');
  const walks = async (page, hasDoor) => {
    const card = page.locator('article', { has: page.locator('.value', { hasText: String(hasDoor) }) });
    await card.locator('h2 a').click();
    await ready(page);
    await page.getByRole('button', { name: 'Walk', exact: true }).focus();
    await page.keyboard.press('Enter');
    const green = async () => share(await seen(page, canvasOf(page)), kColours.green);
    assert.equal(await green(), 0, 'the wall or the closed door hides it');
    return green;
  };
  await withPage(address, async (page) => {
    const green = await walks(page, true);
    await page.keyboard.down('w');
    await walking(page, 3);
    await page.keyboard.up('w');
    assert.ok(await green() > 0.3, 'behind the door');
  });
  await withPage(address, async (page) => {
    const green = await walks(page, false);
    const forward = page.getByRole('button', { name: 'Forward' });
    await forward.dispatchEvent('pointerdown', { pointerType: 'touch' });
    await walking(page, 2);
    // A slow machine may not have come to the wall yet.
    let stopped, after = await seen(page, canvasOf(page));
    for (let i = 0; i < 10 && !stopped?.data.equals(after.data); ++i) {
      await walking(page, 0.5);
      stopped = after;
      after = await seen(page, canvasOf(page));
    }
    await forward.dispatchEvent('pointerup', { pointerType: 'touch' });
    assert.deepEqual(after.data, stopped.data);
    assert.equal(await green(), 0);
  }, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
});

test('two solutions side by side: what differs keeps its colour, what is the same fades', async () => {
  await withPage(blocks, async (page) => {
    await page.getByRole('button', { name: 'Compare blocks-0001' }).click();
    await page.getByRole('button', { name: 'Compare blocks-0006' }).click();
    await page.getByRole('link', { name: 'Open side by side' }).click();
    await ready(page);
    assert.equal(await canvasOf(page, 1).isVisible(), true);
    for (const side of [0, 1]) {
      assert.equal(await numberOf(page, 'red', side), 0);
      assert.equal(await numberOf(page, 'blue', side), 0);
      const picture = await seen(page, canvasOf(page, side));
      assert.equal(areas(picture, (pixel) => kColours.orange(pixel) || kColours.green(pixel)).length, 1);
    }
    const items = panelOf(page).locator('.differences li');
    assert.equal(await items.count(), 1);
    assert.match(await items.textContent(), /^green box: moved \d\.00 m$/);
    await items.getByRole('button').click();
    await panelOf(page).locator('.details').getByRole('heading', { name: 'green box' }).waitFor();
    assert.match(await panelOf(page).locator('table').textContent(), /x3\d/);
    const right = await seen(page, canvasOf(page, 1));
    await canvasOf(page, 0).focus();
    await page.keyboard.press('ArrowLeft');  // the other one turns with it
    assert.notDeepEqual((await seen(page, canvasOf(page, 1))).data, right.data);
  });
});

// Two tables of which one moves, two blue boxes of which one turns red, and a green one that is there or not.
const kChanges = `
x = range(0, 1);
place("", at: [0, 0, 0], size: [8, 8, 0.1], color: [0.9, 0.9, 0.9], name: "floor");
place("", at: [1 + 2 * x, 1, 0.1], size: [1, 1, 1], color: [0.05, 0.05, 0.9], name: "mover");
place("", at: [6, 5, 0.1], size: [1, 1, 1], color: if x == 0 then [0.9, 0.75, 0.5] else [0.9, 0.85, 0.6], name: "painted");
if x == 1 then place("", at: [2, 5, 0.1], size: [1, 1, 1], color: [0.9, 0.9, 0.9], name: "guest");
return x;
`;

test('what moved keeps its colour and stands on an orange mat, what looks otherwise is orange, what is new is blue', async () => {
  const address = await generated(folder.path, 'changes', kChanges, '--all', '--diversity', 'low');
  await withPage(address, async (page) => {
    await page.goto(`${address}#compare-1-2`);
    await ready(page);
    const [left, right] = [await seen(page, canvasOf(page, 0)), await seen(page, canvasOf(page, 1))];
    assert.equal(areas(left, kColours.blue).length, 1, 'the mover');
    assert.equal(areas(right, kColours.blue).length, 2, 'the mover and the guest');
    for (const side of [left, right]) assert.equal(areas(side, kColours.orange, 15).length, 2, 'the mat and the painted box');
    assert.equal(await panelOf(page).locator('.summary').textContent(),
                 '1 moved, 1 changed, 1 only in changes-0002, 1 the same.');
  });
});

// More than 300,000 triangles, so that what is small is drawn as boxes.
const kField = `
place("chair", at: [40, 100], color: [0.9, 0.02, 0.02], name: "red chair");
for i in 0..41: for j in 0..41: place("chair", at: [2 * i, 2 * j]);
return range(1, 2);
`;

test('of a large scene, what is so far away that it is drawn as a box can be picked', async () => {
  const address = await generated(folder.path, 'field', kField, '-n', '1');
  await withPage(address, async (page) => {
    await openFirst(page);
    await page.waitForTimeout(500);  // until the view is at rest
    const [area] = areas(await seen(page, canvasOf(page)), kColours.red, 2);
    assert.ok(area.pixels < 64, `${area.pixels} pixels`);
    await canvasOf(page).click({ position: { x: area.x, y: area.y } });
    await panelOf(page).locator('.details').getByRole('heading', { name: 'red chair' }).waitFor();
  });
});

const kHouse = `
place("", at: [0, 0, 0], size: [6, 5, 0.2], name: "ground");
place("", at: [0, 0, 2.8], size: [6, 5, 0.2], name: "upper floor");
place("", at: [0, 0, 5.6], size: [6, 5, 0.2], name: "roof");
place("", at: [range(1, 2), 2, 0.2], size: [2, 1, 0.75], name: "table");
place("", at: [3, 2, 3], size: [2, 1, 0.5], name: "bed");
for i in 0..30: place("", at: [0.19 * i, 0.1 * (i % 7), 3], size: [0.5, 0.4, 0.1 * i + 0.1], angle: 13 * i, name: "thing");
`;

test('drawings: no floor hides another one, and no label lies upon another', async () => {
  const address = await generated(folder.path, 'house', kHouse, '-n', '1');
  await withPage(address, async (page) => {
    await openFirst(page);
    const views = await page.getByLabel('View', { exact: true }).locator('option').allTextContents();
    assert.deepEqual(views, ['3D', 'Plan from 0 m', 'Plan from 2.8 m', 'From the front', 'From the right', 'Isometric']);
    const isOnTop = (name) => page.evaluate((wanted) => {
      const thing = [...document.querySelectorAll('.drawing [data-address]')]
        .find((each) => each.querySelector('title').textContent.startsWith(`${wanted}\n`));
      const { x, y, width, height } = thing.getBoundingClientRect();
      return thing.contains(document.elementFromPoint(x + width / 2, y + height / 2));
    }, name);
    for (const [view, thing] of [['Plan from 0 m', 'table'], ['Plan from 2.8 m', 'bed'], ['Isometric', 'roof']]) {
      await page.getByLabel('View', { exact: true }).selectOption(view);
      assert.equal(await isOnTop(thing), true, `${thing} in ${view}`);
    }
    for (const view of views.slice(1)) {
      await page.getByLabel('View', { exact: true }).selectOption(view);
      const clashes = await page.evaluate(() => {
        const texts = [...document.querySelectorAll('.drawing [data-address] text')];
        const boxes = texts.map((text) => text.getBoundingClientRect());
        const overlap = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
        return boxes.flatMap((box, at) => boxes.slice(at + 1).filter((other) => overlap(box, other))).length;
      });
      assert.equal(clashes, 0, view);
    }
  });
});

const kWishes = `
x = range(0, 9);
y = range(0, 9);
place("", at: [x, 0], size: [1, 1, 1], name: "wanderer");
place("", at: [y, 4], size: [1, 1, 1], name: "other");
assert(x > 7);
assert(x < 7, "not so far");
prefer(y == 3, 3);
minimize(5 * y);
`;

test('unmet wishes and broken asserts are listed, and marked where they are', async () => {
  const address = await generated(folder.path, 'wishes', kWishes, '-n', '1', '--relax');
  await withPage(address, async (page) => {
    await openFirst(page);
    const section = (title) => panelOf(page).locator('section', { has: page.getByRole('heading', { name: title }) });
    assert.match(await section('Broken asserts').textContent(), /x [<>] 7 \(wishes\.sol:[67]:8\)/);
    assert.match(await section('Unmet wishes').textContent(), /prefer\(y == 3, 3\) \(wishes\.sol:8:1\), cost 3$/);
    const list = await panelOf(page).getByLabel('Objects').locator('option').allTextContents();
    assert.deepEqual(list, ['⚠ wanderer', '△ other']);
    assert.equal(await numberOf(page, 'red'), 1);
    await panelOf(page).getByLabel('Objects').selectOption({ index: 0 });
    assert.match(await panelOf(page).locator('.details .broken').textContent(), /x [<>] 7/);
    await panelOf(page).getByLabel('Objects').selectOption({ index: 1 });
    assert.match(await panelOf(page).locator('.details .unmet').textContent(), /prefer\(y == 3, 3\)/);
  });
});

test('the textures of models are seen', async () => {
  await writeFile(join(folder.path, 'tile.glb'), texturedModel());
  const address = await generated(folder.path, 'textured', 'place("tile.glb", at: [range(0, 1), 0]);', '-n', '1');
  await withPage(address, async (page) => {
    await openFirst(page);
    assert.ok(share(await seen(page, canvasOf(page)), kColours.red) > 0.2);
  });
});

test('the keyboard alone does everything', async () => {
  await withPage(blocks, async (page) => {
    const focused = () => page.evaluate(() => document.activeElement.textContent);
    const tabTo = async (isThere) => {
      for (let i = 0; i < 60; ++i) {
        await page.keyboard.press('Tab');
        if (await page.evaluate(isThere)) return;
      }
      assert.fail(`no Tab leads to ${isThere}`);
    };
    await tabTo(() => document.activeElement.id === 'filter');
    await page.keyboard.type('cost=0');
    await arranged(page);
    await tabTo(() => document.activeElement.textContent === 'blocks-0001');
    await page.keyboard.press('Enter');
    await ready(page);
    assert.equal(await page.evaluate(() => document.activeElement.tagName), 'CANVAS');
    await tabTo(() => document.activeElement.getAttribute('aria-label') === 'Objects');
    await page.keyboard.press('ArrowDown');
    await panelOf(page).locator('.details h3').waitFor();
    await page.keyboard.press('Escape');
    await page.waitForURL(/#solution-1$/);
    assert.equal(await page.locator('dialog[open]').count(), 0);
    assert.equal(await focused(), 'blocks-0001');
  });
});

test('the way back closes, and an address opens', async () => {
  await withPage(`${blocks}#open-2`, async (page) => {
    await ready(page);
    await page.getByRole('button', { name: 'Next solution' }).click();
    await page.waitForFunction(() => document.querySelector('dialog h2').textContent === 'blocks-0003');
    await page.goBack();
    await page.waitForFunction(() => document.querySelector('dialog h2').textContent === 'blocks-0002');
    await ready(page);
    await page.getByRole('button', { name: 'Close' }).click();
    assert.equal(await page.locator('dialog[open]').count(), 0);
  });
});

const kMarkup = `
name = "<img src=x onerror=document.title='bad'>";
place("", at: [range(0, 1), 0, 0], size: [1, 1, 1], name: name, purpose: "</script><script>document.title='bad'</script>");
prefer(flip() == true, 3);
return name, "\\"><b>bold</b>";
`;

test('names, texts and values that try to be markup are shown as text', async () => {
  const address = await generated(folder.path, 'markup', kMarkup, '-n', '2');
  await withPage(address, async (page) => {
    assert.match(await page.locator('article .value').first().textContent(), /<img src=x onerror/);
    await openFirst(page);
    await panelOf(page).getByLabel('Objects').selectOption({ index: 0 });
    const text = await panelOf(page).textContent();
    assert.match(text, /<img src=x onerror=document\.title='bad'>/);
    assert.match(text, /<\/script><script>/);
    await page.getByLabel('View', { exact: true }).selectOption('Plan');
    assert.equal(await page.locator('.drawing svg').count(), 1);
    await page.goto(`${address}#compare-1-2`);
    await ready(page);
    assert.equal(await page.title(), 'markup: 2 solutions');
    assert.equal(await page.locator('b, img[src=x], main script').count(), 0);
  });
});

test('a program that places nothing shows values and choices', async () => {
  const address = await generated(folder.path, 'values', 'x = range(1, 3);\ny = flip();\nreturn [x, [y]];', '-n', '3');
  await withPage(address, async (page) => {
    await openFirst(page);
    assert.equal(await canvasOf(page).isVisible(), false);
    assert.match(await panelOf(page).locator('table').textContent(), /x\d/);
    await page.goto(`${address}#compare-1-2`);
    await ready(page);
    assert.match(await panelOf(page).textContent(), /The scenes look the same/);
  });
});

test('what is missing beside the page is said', async () => {
  const address = await generated(folder.path, 'gone', 'place("", at: [range(1, 2), 0]);', '-n', '2');
  await rm(join(folder.path, 'gone/page/gone-0001.js'));
  const { page, close } = await opened(browser, address);
  await openFirst(page);
  assert.equal(await page.locator('.message').textContent(), 'page/gone-0001.js is missing beside the page');
  await page.getByRole('button', { name: 'Next solution' }).click();
  await page.locator('canvas:visible').waitFor();
  await close();
});

const axe = readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

async function findings(page) {
  await page.evaluate(await axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { preload: false }));
  return violations.filter(({ impact }) => ['serious', 'critical'].includes(impact))
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`);
}

for (const colorScheme of ['light', 'dark']) {
  test(`axe finds nothing serious, ${colorScheme}`, async () => {
    await withPage(blocks, async (page) => {
      assert.deepEqual(await findings(page), []);
      await openFirst(page);
      await panelOf(page).getByLabel('Objects').selectOption({ index: 1 });
      assert.deepEqual(await findings(page), []);
      await page.goto(`${blocks}#compare-1-6`);
      await ready(page);
      assert.deepEqual(await findings(page), []);
    }, { colorScheme });
  });
}

test('the page follows the colours of the system, and the reader may choose others', async () => {
  await withPage(blocks, async (page) => {
    const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const dark = await background();
    await page.getByLabel('Colours').selectOption('light');
    const light = await background();
    assert.notEqual(light, dark);
    await page.reload();
    assert.equal(await background(), light);
  }, { colorScheme: 'dark' });
});

test('a phone shows everything without scrolling sideways, and touch turns and picks', async () => {
  await withPage(blocks, async (page) => {
    const fits = () => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
    assert.equal(await fits(), true);
    await page.locator('article h2 a').first().tap();
    await ready(page);
    assert.equal(await fits(), true);
    for (const control of await page.locator('dialog header button:visible, dialog header select:visible').all()) {
      const { x, width, height } = await control.boundingBox();
      assert.ok(x >= 0 && x + width <= 390 && height >= 32);
    }
    const [area] = areas(await seen(page, canvasOf(page)), kColours.green);
    await canvasOf(page).tap({ position: { x: area.x, y: area.y } });
    await panelOf(page).getByRole('heading', { name: 'green box' }).waitFor();
  }, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
});

/** Returns the milliseconds until a page shows something; they depend on how busy the machine is. */
async function paintOf(page) {
  await page.waitForFunction(() => performance.getEntriesByName('first-contentful-paint').length > 0);
  return page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);
}

test('maps of tiles: a grid of sharp pictures, which one comes closer to and compares', async () => {
  const exemplar = join(folder.path, 'checks.txt'), output = join(folder.path, 'checks');
  await writeFile(exemplar, 'aab\naba\nbaa\n');
  await ran('tiles', exemplar, '-W', '6', '-H', '4', '-n', '3', '--sampler', 'wfc', '--format', 'txt,glb', '-o', output);
  const address = pathToFileURL(join(output, 'index.html')).href;
  await withPage(address, async (page) => {
    assert.deepEqual(await shownNames(page), ['checks-0001', 'checks-0002', 'checks-0003']);
    const { width, rendering } = await page.locator('article img').first().evaluate(async (image) => {
      await image.decode();
      return { width: image.naturalWidth, rendering: getComputedStyle(image).imageRendering };
    });
    assert.deepEqual([width, rendering], [48, 'pixelated']);
    const [first] = (await readFile(join(output, 'checks-0001.txt'), 'utf8')).split('\n');
    await page.getByLabel('Filter').fill(`0,3=${first[0]}`);  // the tile at the top left
    await arranged(page);
    assert.ok((await shownNames(page)).includes('checks-0001'));
    await page.goto(`${address}#open-1`);
    await ready(page);
    assert.equal(await panelOf(page).getByLabel('Objects').locator('option').count(), 24);
    await page.getByLabel('View', { exact: true }).selectOption('Map');
    const shown = () => page.locator('.drawing svg').evaluate((svg) => svg.viewBox.baseVal.width);
    assert.equal(await shown(), 48);
    const drawing = page.locator('.drawing');
    await drawing.press('+');
    assert.equal((await shown()).toFixed(3), (48 / 1.25).toFixed(3));
    await drawing.hover();
    await page.mouse.wheel(0, -200);
    await page.waitForFunction(() => document.querySelector('.drawing svg').viewBox.baseVal.width < 30);
    await page.getByRole('button', { name: 'Reset view' }).click();
    assert.equal(await shown(), 48);
    assert.deepEqual(await findings(page), []);
  });
});

// A map of 4 x 3 tiles, all pinned: a tree at the lower right, a blue post, and grey ground.
const kWood = JSON.stringify({
  tiles: [{ name: 'tree', char: 'T', asset: 'tree' }, { name: 'ground', char: '.', color: '#a0a0a0', height: 0.1 },
    { name: 'post', char: 'P', color: '#1010e0' }],
  adjacencies: [{ left: ['tree', 'ground', 'post'], right: ['tree', 'ground', 'post'] },
    { top: ['tree', 'ground', 'post'], bottom: ['tree', 'ground', 'post'] }],
  size: [4, 3],
  pins: [{ at: [0, 0], size: [4, 1], tiles: ['ground'] }, { at: [0, 1], tiles: ['ground'] }, { at: [1, 1], tiles: ['post'] },
    { at: [2, 1], size: [2, 1], tiles: ['ground'] }, { at: [0, 2], size: [3, 1], tiles: ['ground'] },
    { at: [3, 2], tiles: ['tree'] }],
});

test('maps of tiles with models: a map to come closer to, and a scene in which a click names the tile', async () => {
  const problem = join(folder.path, 'wood.tiles.json'), output = join(folder.path, 'wood');
  await writeFile(problem, kWood);
  await ran('tiles', problem, '-n', '1', '-o', output);
  assert.deepEqual((await readdir(output)).filter((file) => file.endsWith('.glb')), []);  // nobody asked for one
  await withPage(pathToFileURL(join(output, 'index.html')).href, async (page) => {
    await openFirst(page);
    const views = page.getByLabel('View', { exact: true });
    assert.deepEqual((await views.locator('option').allTextContents()).slice(0, 2), ['3D', 'Map']);
    assert.equal(await numberOf(page, 'blue'), 1);
    assert.ok(await numberOf(page, 'green') > 0);
    await clickOn(page, 'blue');
    await panelOf(page).getByRole('heading', { name: 'post' }).waitFor();
    const names = await panelOf(page).getByLabel('Objects').locator('option').allTextContents();
    assert.equal(names.filter((name) => name.startsWith('tree')).length, 1);
    assert.equal(names.filter((name) => name.startsWith('ground')).length, 10);
    await views.selectOption('Map');
    const shown = () => page.locator('.drawing svg').evaluate((svg) => svg.viewBox.baseVal.width);
    const whole = await shown();
    await page.locator('.drawing').press('+');
    assert.ok(await shown() < whole);
    await views.selectOption('3D');
    assert.equal(await numberOf(page, 'blue'), 1);
    assert.deepEqual(await findings(page), []);
  });
});

test('a thousand solutions: the page is quick, and loads a scene only when it is opened', async () => {
  const address = await generated(folder.path, 'many', 'x = range(1, 1000);\nplace("", at: [x, 0], size: [1, 1, 1]);\nreturn x;',
                                  '--all', '--diversity', 'low');
  const files = await readdir(join(folder.path, 'many/page'));
  assert.equal(files.filter((file) => /^many-\d+\.js$/.test(file)).length, 1000);
  const asked = [];
  let few;
  await withPage(blocks, async (page) => (few = await paintOf(page)));
  await withPage('about:blank', async (page) => {
    page.on('request', (request) => asked.push(request.url()));
    await page.goto(address);
    const paint = await paintOf(page);
    assert.ok(paint < 4 * few + 1500, `painted after ${paint} ms, a page of seven after ${few} ms`);
    assert.equal((await shownNames(page)).length, 1000);
    assert.equal(asked.filter((url) => /many-\d+\.js|stage\.js|choices\.js/.test(url)).length, 0);
    assert.ok(asked.length < 100, `${asked.length} files were asked for`);
    const start = await page.evaluate(() => performance.now());
    await page.getByLabel('Sort by').selectOption('value');
    await page.waitForFunction(() => document.querySelector('article .value').textContent === '1');
    const end = await page.evaluate(() => performance.now());
    assert.ok(end - start < 4 * few + 3000, `sorted in ${end - start} ms`);
    await openFirst(page);
    assert.equal(asked.filter((url) => /many-\d+\.js/.test(url)).length, 1);
  });
});
