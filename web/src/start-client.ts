import { type Client, createClient } from './polylap.js';

/** The client that all of a document share: started when it is first wanted. */
let shared: Promise<Client> | undefined;

export function sharedClient(): Promise<Client> {
  shared ??= createClient().catch((reason) => {
    // What failed may work the next time.
    shared = undefined;
    throw reason;
  });
  return shared;
}
