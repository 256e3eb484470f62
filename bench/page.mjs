// node bench/page.mjs PROGRAM [SCRIPT]: how large the page of a run is, how soon it is painted, how soon its end is
// seen after a jump there, and how long a scene takes to open, with 10, 100 and 1,000 solutions.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launched, opened, ready } from '../tests/page/browser.mjs';

// A furnished room with 4096 solutions, which are found in no time.
const kRoom = `
place("", at: [0, 0, 0], size: [8, 6, 0.05], name: "floor");
for wall in [[0, 0, 8, 0.1], [0, 6, 8, 0.1], [0, 0, 0.1, 6], [8, 0, 0.1, 6]]:
  place("", at: [wall[0], wall[1], 0], size: [wall[2], wall[3], 2.5], name: "wall");
for i in 0..5: place("chair", at: [i + 0.5, range(0, 3), 0]);
for i in 0..2: place("table", at: [2 * i + 1, 4, 0]);
for i in 0..2: place("bookcase", at: [2 * i + 1, 5.5, 0]);
place("sofa", at: [6.5, 2, 0], turn: 1);
place("plant", at: [7, 5, 0]);
`;

const [program, given] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'solitaire-page-bench-'));
const script = given ? resolve(given) : join(folder, 'room.sol');
if (!given) writeFileSync(script, kRoom);

const megabytes = (bytes) => (bytes / 1e6).toFixed(2);

/** Returns how many bytes the files of a folder take whose names pass. */
function sizeOf(path, passes = () => true) {
  return readdirSync(path).filter(passes).reduce((sum, name) => {
    const entry = statSync(join(path, name));
    return sum + (entry.isFile() ? entry.size : 0);
  }, 0);
}

async function times(browser, address) {
  const { page, close } = await opened(browser, address);
  await page.waitForFunction(() => performance.getEntriesByName('first-contentful-paint').length > 0);
  const { paint, loaded } = await page.evaluate(() => ({
    paint: performance.getEntriesByName('first-contentful-paint')[0].startTime,
    loaded: performance.getEntriesByType('navigation')[0].domContentLoadedEventEnd,
  }));
  const scrolls = await page.evaluate(async () => {
    const start = performance.now(), frame = () => new Promise(requestAnimationFrame);
    scrollTo(0, document.body.scrollHeight);
    await frame();
    await frame();
    return performance.now() - start;
  });
  await page.evaluate(() => scrollTo(0, 0));
  const start = Date.now();
  await page.locator('article h2 a').first().click();
  await ready(page);
  await close();
  return { paint, loaded, scrolls, opens: Date.now() - start };
}

const browser = await launched();
try {
  console.log('solutions  index.html  page/ (MB)  .glb (MB)  first paint  interactive  to the end  a scene opens (ms)');
  for (const count of [10, 100, 1000]) {
    const output = join(folder, String(count));
    execFileSync(program, ['generate', script, '-n', String(count), '-o', output, '--quiet']);
    const { paint, loaded, scrolls, opens } = await times(browser, pathToFileURL(join(output, 'index.html')).href);
    console.log([count, megabytes(statSync(join(output, 'index.html')).size), megabytes(sizeOf(join(output, 'page'))),
                 megabytes(sizeOf(output, (name) => name.endsWith('.glb'))), paint.toFixed(0), loaded.toFixed(0),
                 scrolls.toFixed(0), opens]
      .map((value) => String(value).padStart(11)).join(''));
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
