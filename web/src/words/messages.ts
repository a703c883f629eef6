/** Messages that were composed in English, read by patterns and written again in another language. */

/**
 * English and the other language. `{x}` stands for any text, `{#x}` for a number, there `{x}` again, and `{*x}` for a part that must have words of its
 * own.
 */
export type Pattern = readonly [string, string];

/**
 * The first pattern that fits counts. A message whose parts cannot all be said stays whole as it is: no sentence is in two languages.
 * @param number writes a number as the language does
 * @returns null where there are no words
 */
export function reader(
  patterns: readonly Pattern[],
  texts: Readonly<Record<string, string>>,
  number: (digits: string) => string,
): (message: string) => string | null {
  const rules = patterns.map(([english, other]) => rule(english, other));

  const read = (message: string): string | null => {
    const whole = texts[message];
    if (whole !== undefined) return whole;
    for (const { form, kinds, other } of rules) {
      const found = form.exec(message);
      const values = found && kinds.map((kind, k) => said(kind, found[k + 1] ?? ''));
      if (!values?.every((value) => value !== null)) continue;
      return kinds.reduce(
        (text, kind, k) => text.replaceAll(`{${kind.replace('#', '')}}`, () => `${values[k]}`),
        other,
      );
    }
    return null;
  };
  const said = (kind: string, value: string) => {
    if (kind.startsWith('*')) return read(value);
    return kind.startsWith('#') ? number(value) : value;
  };
  return read;
}

const aNumber = '([-+−]?(?:\\d[\\d.]*(?:e[-+]?\\d+)?|inf|nan))';

function rule(english: string, other: string) {
  const kinds: string[] = [];
  const pieces = english.split(/\{([*#]?\w+)\}/).map((piece, k) => {
    if (k % 2 === 0) return piece.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
    kinds.push(piece);
    return piece.startsWith('#') ? aNumber : '(.+?)';
  });
  return { form: new RegExp(`^${pieces.join('')}$`, 's'), kinds, other };
}
