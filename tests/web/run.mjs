// Runs the tests of the page against build/web/dist.
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const dist = process.env.TERRELLA_DIST ?? join(here, '../../build/web/dist');
if (!existsSync(join(dist, 'index.html'))) {
  console.error(`There is no page in ${dist}; build it first: make test does.`);
  process.exit(1);
}
// One file after the other: they share the processor that draws for them.
const tests = readdirSync(here).filter(name => name.endsWith('_test.mjs')).map(name => join(here, name));
const result = spawnSync(process.execPath, ['--test', '--test-concurrency=1', ...tests], { stdio: 'inherit', env: { ...process.env, TERRELLA_DIST: dist } });
process.exit(result.status ?? 1);
