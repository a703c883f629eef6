import type { Client, Side } from './polylap.js';

export interface News {
  restarted: (reason: string, side: Side) => void;
  loading: (loading: boolean) => void;
}

const heard = new WeakMap<Client, Set<News>>();

/** Has everybody who shares a client hear what becomes of its workers. @returns the way to stop */
export function hear(client: Client, news: News): () => void {
  let all = heard.get(client);
  if (!all) {
    const everybody = new Set<News>();
    all = everybody;
    heard.set(client, all);
    client.onRestart = (reason, side) => {
      for (const each of everybody) each.restarted(reason, side);
    };
    client.onLoading = (loading) => {
      for (const each of everybody) each.loading(loading);
    };
  }
  all.add(news);
  return () => all.delete(news);
}
