// A real browser without a display, for pages on the disk. It tells of every error and of every request that would
// leave the machine.
import { execFile } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const kProgram = process.env.SOLITAIRE_PROGRAM;
const kBrowser = process.env.SOLITAIRE_BROWSER ?? '/usr/bin/chromium';
// WebGL by the processor: there is no other one on a test machine.
const kFlags = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

const kPatience = 120_000;  // milliseconds; a busy machine draws slowly

export async function launched() {
  return chromium.launch({ executablePath: kBrowser, args: kFlags });
}

/** A folder that is removed in the end. */
export async function workplace() {
  const path = await mkdtemp(join(tmpdir(), 'solitaire-page-'));
  return { path, remove: () => rm(path, { recursive: true }) };
}

/** Runs the program. */
export async function ran(...args) {
  await promisify(execFile)(kProgram, args);
}

/** Runs `solitaire generate` on a program's text, and returns the page's address. */
export async function generated(folder, name, text, ...options) {
  const script = join(folder, `${name}.sol`), output = join(folder, name);
  await writeFile(script, text);
  await ran('generate', script, '-o', output, ...options);
  return pathToFileURL(join(output, 'index.html')).href;
}

/** Opens a page of a browser. `troubles` lists what went wrong in it, which should be nothing. */
export async function opened(browser, address, settings = {}) {
  const context = await browser.newContext({ viewport: { width: 840, height: 520 }, ...settings });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  const troubles = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) troubles.push(`asked for ${request.url()}`);
  });
  await page.goto(address);
  return { page, troubles, close: () => context.close() };
}

/** Waits until what the viewer opened is shown. */
export async function ready(page) {
  await page.waitForSelector('dialog[open][data-ready="true"]');
}
