// The steps of `npm test`: their order, their time, and how many tests passed.

/** Counts the cases of a JUnit file as ctest writes it. Skipped and disabled ones have failed. */
export function countJunit(text) {
  const suite = text.match(/<testsuite\b[^>]*>/)?.[0];
  if (!suite) throw new Error('no JUnit file');
  const number = (name) => Number(suite.match(new RegExp(`\\b${name}="(\\d+)"`))?.[1] ?? 0);
  const failed = number('failures') + number('errors') + number('skipped') + number('disabled');
  return { passed: number('tests') - failed, failed };
}

/** Counts the tests of a vitest JSON report. Skipped and pending ones have failed, and so has a file that cannot be loaded. */
export function countVitest(text) {
  const report = JSON.parse(text);
  const unloaded = report.testResults.filter((file) => file.status === 'failed' && file.assertionResults.length === 0);
  return { passed: report.numPassedTests, failed: report.numTotalTests - report.numPassedTests + unloaded.length };
}

const seconds = (since) => `${((performance.now() - since) / 1000).toFixed(1)} s`;

/**
 * Runs the steps one after the other; one whose needs failed is not run and counts as failed, the others go on.
 * @param steps `{ id, title, needs?, work }`; `work` returns `{ passed, failed }` or, for a step without tests of its own, nothing
 * @returns per step `{ title, passed, failed, time, note }`
 */
export async function runSteps(steps, log = console.log) {
  const good = new Set();
  const outcomes = [];
  for (const { id, title, needs = [], work } of steps) {
    const missing = needs.filter((need) => !good.has(need));
    if (missing.length > 0) {
      outcomes.push({ title, passed: 0, failed: 1, time: '', note: `not run, because of: ${missing.join(', ')}` });
      continue;
    }
    log(`\n=== ${title}`);
    const start = performance.now();
    let outcome;
    try {
      outcome = { note: '', ...((await work()) ?? { passed: 0, failed: 0, note: 'done' }) };
    } catch (error) {
      outcome = { passed: 0, failed: 1, note: error.message };
      log(error.message);
    }
    if (outcome.failed === 0) good.add(id);
    outcomes.push({ title, ...outcome, time: seconds(start) });
    log(`=== ${title}: ${outcome.failed === 0 ? 'ok' : 'FAILED'}, ${seconds(start)}`);
  }
  return outcomes;
}

/** A table of the steps, and the closing line. */
export function summary(outcomes) {
  const lines = outcomes.map(({ title, passed, failed, time, note }) => {
    const result = note && failed === 0 ? note : `${passed} passed, ${failed} failed${note ? ` (${note})` : ''}`;
    return `${title.padEnd(36)} ${time.padStart(8)}  ${result}`;
  });
  const total = (key) => outcomes.reduce((sum, outcome) => sum + outcome[key], 0);
  return [...lines, `${total('passed')} passed, ${total('failed')} failed`].join('\n');
}
