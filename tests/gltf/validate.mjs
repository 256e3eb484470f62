// node validate.mjs FILE...: Khronos' glTF validator over the files. Prints every error and warning (with --infos
// every remark) and exits 1 if there is an error or warning, 2 if there is nothing to check.
import { readFile } from 'node:fs/promises';
import { dirname, resolve } from 'node:path';
import validator from 'gltf-validator';

const kSeverities = ['error', 'warning', 'info', 'hint'];

async function validate(file, least) {
  const bytes = new Uint8Array(await readFile(file));
  const report = await validator.validateBytes(bytes, {
    uri: file,
    maxIssues: 0,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(resolve(dirname(file), decodeURIComponent(uri)))),
  });
  for (const message of report.issues.messages) {
    if (message.severity > least) continue;
    console.log(`${file}: ${kSeverities[message.severity]}: ${message.code} at ${message.pointer ?? message.offset}: ${message.message}`);
  }
  return report.issues.numErrors + report.issues.numWarnings;
}

const files = process.argv.slice(2).filter((argument) => argument !== '--infos');
if (files.length === 0) {
  console.error('usage: node validate.mjs [--infos] FILE...');
  process.exit(2);
}
const least = process.argv.includes('--infos') ? 3 : 1;
let issues = 0;
for (const file of files) issues += await validate(file, least);
console.log(`${files.length} files, ${issues} errors and warnings`);
process.exit(issues === 0 ? 0 : 1);
