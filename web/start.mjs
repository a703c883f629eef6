// `npm start`: installs what is missing, builds what changed, serves the built page; `npm run dev` serves the sources and reloads.
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { build, buildGallery, buildSite, ensureModules, ensurePackages, root, runMain } from '../.ci/build.mjs';

await runMain(async () => {
  const { values } = parseArgs({
    options: { dev: { type: 'boolean' }, port: { type: 'string' }, host: { type: 'string' } },
  });
  const port = Number(values.port ?? process.env.PORT ?? 4173);
  if (!Number.isInteger(port) || port < 1 || port > 65535)
    throw new Error(`no port: ${values.port ?? process.env.PORT}`);
  const host = values.host ?? 'localhost';
  process.env.POLYLAP_SITE ??= `http://${host.includes(':') ? `[${host}]` : host}:${port}/`;
  await ensurePackages('wasm');
  await ensureModules();
  await build('wasm');
  await (values.dev ? buildGallery() : buildSite());

  const vite = await import('vite');
  const options = { port, host };
  const inline = {
    root: join(root, 'web'),
    configFile: join(root, 'web/vite.config.mjs'),
    server: options,
    preview: options,
  };
  const server = values.dev ? await (await vite.createServer(inline)).listen() : await vite.preview(inline);
  const { address, port: actual } = server.httpServer.address();
  const name = values.host ? (address.includes(':') ? `[${address}]` : address) : 'localhost';
  console.log(`\npolylap is at http://${name}:${actual}/   (Ctrl-C ends it)`);

  for (const signal of ['SIGINT', 'SIGTERM']) {
    process.once(signal, async () => {
      await server.close();
      process.exit(0);
    });
  }
});
