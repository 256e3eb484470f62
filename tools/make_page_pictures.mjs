// node tools/make_page_pictures.mjs PROGRAM: draws the pictures of docs/page.md anew, in the browser that the tests of
// the page use.
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { launched, opened, ready } from '../tests/page/browser.mjs';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const images = join(root, 'docs/images');
const folder = mkdtempSync(join(tmpdir(), 'solitaire-pictures-'));

/** Returns the address of the page of an example's run. */
function pageOf(example, ...options) {
  const output = join(folder, example);
  execFileSync(process.argv[2], ['generate', join(root, `examples/${example}.sol`), '-o', output, '--png', ...options]);
  return pathToFileURL(join(output, 'index.html')).href;
}

async function picture(browser, name, address, settings, prepare = async () => {}) {
  const { page, close } = await opened(browser, address, settings);
  if (address.includes('#')) await ready(page);
  await prepare(page);
  await page.waitForTimeout(1000);
  await page.screenshot({ path: join(images, `page-${name}.png`) });
  await close();
}

const kDesk = { viewport: { width: 1180, height: 720 } };
const kPhone = { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true };
const select = (text) => (page) =>
  page.getByLabel('Objects').selectOption({ label: text }).then(() => page.mouse.move(0, 0));
const walk = (page) => page.getByRole('button', { name: 'Walk', exact: true }).click();
const view = (title) => (page) => page.getByLabel('View', { exact: true }).selectOption(title);

const browser = await launched();
try {
  const workspace = pageOf('workspace', '-n', '6');
  await picture(browser, 'grid', workspace, kDesk);
  await picture(browser, 'scene', `${workspace}#open-1`, kDesk, async (page) => {
    const sofa = await page.getByLabel('Objects').locator('option', { hasText: 'sofa' }).first().textContent();
    await select(sofa)(page);
  });
  await picture(browser, 'walk', `${workspace}#open-1`, kDesk, walk);
  await picture(browser, 'plan', `${workspace}#open-1`, { ...kDesk, colorScheme: 'dark' }, view('Plan'));
  await picture(browser, 'phone', `${workspace}#open-2`, kPhone);
  copyFileSync(join(folder, 'workspace/workspace-0001.json'), join(folder, 'first.json'));
  const kept = pageOf('workspace', '-n', '2', '--pin-file', join(folder, 'first.json'), '--keep', 'room.w', '--keep', 'room.d',
                      '--keep', 'make_group[*]/make_table[*]/**');
  await picture(browser, 'compare', `${kept}#compare-1-2`, kDesk);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
