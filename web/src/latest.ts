/** Runs one call at a time; of the arguments that arrive meanwhile only the newest is kept. */
export function latest<A>(run: (argument: A) => Promise<void>): (argument: A) => void {
  let running = false;
  let waiting: { argument: A } | undefined;
  const start = async (first: A): Promise<void> => {
    running = true;
    let next: { argument: A } | undefined = { argument: first };
    while (next) {
      await run(next.argument);
      next = waiting;
      waiting = undefined;
    }
    running = false;
  };
  return (argument) => {
    if (running) waiting = { argument };
    else void start(argument);
  };
}
