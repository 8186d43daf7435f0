// A plain static server of the built page, under a path of its own, which counts what is asked of it.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.svg': 'image/svg+xml', '.png': 'image/png', '.webmanifest': 'application/manifest+json', '.txt': 'text/plain' };

// As strict as a page may have to live with.
const strict = { 'content-security-policy': "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'" };

export async function serve(folder, under = '/some/where/', headers = strict) {
  const log = { requests: 0, gzipped: 0, missing: [] };
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, 'http://x').pathname;
    ++log.requests;
    try {
      if (!path.startsWith(under)) throw new Error('elsewhere');
      const body = await readFile(join(folder, normalize(path.slice(under.length) || 'index.html')));
      log.gzipped += gzipSync(body, { level: 9 }).length;
      response.writeHead(200, { 'content-type': types[extname(path)] ?? 'text/html', 'cache-control': 'no-store', ...headers });
      response.end(body);
    } catch {
      log.missing.push(path);
      response.writeHead(404).end();
    }
  });
  await new Promise(done => server.listen(0, '127.0.0.1', done));
  return { url: `http://127.0.0.1:${server.address().port}${under}`, log, close() { server.close(); server.closeAllConnections(); } };
}
