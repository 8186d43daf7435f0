// Runs the tests of the page against build/web/dist.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const dist = process.env.TERRELLA_DIST ?? join(here, '../../build/web/dist');
if (!existsSync(join(dist, 'index.html'))) {
  console.error(`There is no page in ${dist}; build it first: make test does.`);
  process.exit(1);
}
const result = spawnSync(process.execPath, ['--test', join(here, 'page_test.mjs')], { stdio: 'inherit', env: { ...process.env, TERRELLA_DIST: dist } });
process.exit(result.status ?? 1);
