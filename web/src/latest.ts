/**
 * Runs one call at a time; of the arguments that arrive meanwhile only the newest is kept.
 * @param onNewer called when one arrives while another is under way
 */
export function latest<A>(run: (argument: A) => Promise<void>, onNewer: () => void = () => {}): (argument: A) => void {
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
    if (running) {
      waiting = { argument };
      onNewer();
    } else void start(argument);
  };
}
