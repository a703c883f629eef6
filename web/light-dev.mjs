// The light pages in `npm run dev`: made when they are asked for, and anew after a change.
import { fileURLToPath } from 'node:url';
import { figureWords } from './figures/words.mjs';
import { nodeFiles } from './node-files.mjs';

export const lightPages = () => [
  figureWords(),
  nodeFiles(),
  {
    name: 'light-pages',
    apply: 'serve',
    configureServer(server) {
      const load = (path) => server.ssrLoadModule(fileURLToPath(new URL(path, import.meta.url)));
      const filesOf = (source) => ({ scripts: [source], styles: [] });
      let started;
      let made;
      const make = async () => {
        started ??= load('../wasm/src/node.ts').then(({ createClient }) => createClient());
        // It would load what only the build needs.
        const { lightFiles } = await import('./pages.mjs');
        return lightFiles({ load, client: await started, filesOf });
      };
      server.watcher.on('all', () => {
        made = undefined;
      });
      server.httpServer?.once('close', () => started?.then((client) => client.close()));
      server.middlewares.use(async (request, response, next) => {
        const path = new URL(request.url ?? '', 'http://localhost').pathname.slice(1).replace(/\/$/, '/index.html');
        if (!/\.(html|svg)$/.test(path) || path === 'index.html') return next();
        try {
          made ??= make();
          const text = (await made).get(path);
          if (text === undefined) return next();
          const isPage = path.endsWith('.html');
          response.setHeader('content-type', isPage ? 'text/html; charset=utf-8' : 'image/svg+xml');
          response.end(isPage ? await server.transformIndexHtml(`/${path}`, text) : text);
        } catch (error) {
          made = undefined;
          next(error);
        }
      });
    },
  },
];
