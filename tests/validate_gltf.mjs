// Asks the Khronos glTF validator about files: `node validate_gltf.mjs FILE...` prints every error and warning and ends
// with 1 if there was one, with 2 if a file or the validator itself is missing. The validator is the npm package
// `gltf-validator`, found in the node_modules folder that NODE_PATH names or in one beside or above this script.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { delimiter, dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const severityNames = ['error', 'warning'];

function loadValidator() {
  const here = dirname(fileURLToPath(import.meta.url));
  const folders = (process.env.NODE_PATH ?? '').split(delimiter).filter(Boolean).map((folder) => resolve(folder));
  const require = createRequire(import.meta.url);
  try {
    return require(require.resolve('gltf-validator', { paths: [...folders, here] }));
  } catch {
    console.error('the npm package gltf-validator is missing: npm install gltf-validator, then set NODE_PATH to its ' +
                  'node_modules folder');
    process.exit(2);
  }
}

async function validate(validator, file) {
  const bytes = new Uint8Array(await readFile(file));
  const report = await validator.validateBytes(bytes, {
    uri: file,
    maxIssues: 0,
    writeTimestamp: false,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(resolve(dirname(file), decodeURIComponent(uri)))),
  });
  const found = report.issues.messages.filter((message) => message.severity < severityNames.length);
  for (const { severity, code, pointer, offset, message } of found)
    console.log(`${file}: ${severityNames[severity]} ${code} at ${pointer ?? `byte ${offset}`}: ${message}`);
  return found.length;
}

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error('usage: node validate_gltf.mjs FILE...');
  process.exit(2);
}
const validator = loadValidator();
let messages = 0;
for (const file of files) {
  try {
    messages += await validate(validator, file);
  } catch (error) {
    console.error(`${file}: ${error.message ?? error}`);
    process.exit(2);
  }
}
console.log(`${files.length} files, ${messages} errors and warnings`);
process.exit(messages === 0 ? 0 : 1);
