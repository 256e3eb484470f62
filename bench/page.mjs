// node bench/page.mjs PROGRAM [EXAMPLE]: how large the page of a run is, how soon it is painted, and how long a scene
// takes to open, with 10, 100 and 1,000 solutions.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launched, opened, ready } from '../tests/page/browser.mjs';

const [program, example = 'examples/workspace.sol'] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'solitaire-page-bench-'));

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
  const start = Date.now();
  await page.locator('article h2 a').first().click();
  await ready(page);
  await close();
  return { paint, loaded, opens: Date.now() - start };
}

const browser = await launched();
try {
  console.log('solutions  index.html  page/ (MB)  .glb (MB)  first paint  interactive  a scene opens (ms)');
  for (const count of [10, 100, 1000]) {
    const output = join(folder, String(count));
    execFileSync(program, ['generate', resolve(example), '-n', String(count), '-o', output, '--quiet']);
    const { paint, loaded, opens } = await times(browser, pathToFileURL(join(output, 'index.html')).href);
    console.log([count, megabytes(statSync(join(output, 'index.html')).size), megabytes(sizeOf(join(output, 'page'))),
                 megabytes(sizeOf(output, (name) => name.endsWith('.glb'))), paint.toFixed(0), loaded.toFixed(0), opens]
      .map((value) => String(value).padStart(11)).join(''));
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
