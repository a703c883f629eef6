import { expect, it } from 'vitest';
import { countJunit, countVitest, runSteps, summary } from '../steps.mjs';

it('counts what is skipped or disabled as failed', () => {
  const text =
    '<?xml version="1.0"?>\n<testsuite name="x" tests="10" failures="1" disabled="2" skipped="3" time="1">\n</testsuite>';
  expect(countJunit(text)).toEqual({ passed: 4, failed: 6 });
  expect(() => countJunit('nothing')).toThrow();
});

it('counts skipped tests and files that cannot be loaded as failed', () => {
  const report = { numTotalTests: 5, numPassedTests: 3, testResults: [{ status: 'passed', assertionResults: [{}] }] };
  expect(countVitest(JSON.stringify(report))).toEqual({ passed: 3, failed: 2 });
  report.testResults.push({ status: 'failed', assertionResults: [] });
  expect(countVitest(JSON.stringify(report))).toEqual({ passed: 3, failed: 3 });
});

it('goes on after a failure, but not with what needed it', async () => {
  const ran = [];
  const step = (id, result, needs) => {
    const work = () => {
      ran.push(id);
      return result();
    };
    return { id, title: id, needs, work };
  };
  const outcomes = await runSteps(
    [
      step('a', () => ({ passed: 2, failed: 1 })),
      step('b', () => ({ passed: 1, failed: 0 }), ['a']),
      step('c', () => Promise.reject(new Error('broke'))),
      step('d', () => undefined),
    ],
    () => {},
  );
  expect(ran).toEqual(['a', 'c', 'd']);
  expect(outcomes.map(({ passed, failed }) => [passed, failed])).toEqual([
    [2, 1],
    [0, 1],
    [0, 1],
    [0, 0],
  ]);
  expect(summary(outcomes).split('\n').at(-1)).toBe('2 passed, 3 failed');
});
