/** Messages that were composed in English, read by patterns and written again in another language. */

/** English and the other language, with the same placeholders: `{x}` stands for any text, `{*x}` for one that must have words of its own. */
type Pattern = readonly [string, string];

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
    for (const { form, names, other } of rules) {
      const found = form.exec(message);
      const values = found && names.map((name, k) => said(name, found[k + 1] ?? ''));
      if (values?.every((value) => value !== null))
        return names.reduce((text, name, k) => text.replaceAll(`{${name}}`, () => values[k] as string), other);
    }
    return null;
  };
  const said = (name: string, value: string) =>
    name.startsWith('*') ? read(value) : isNumber.test(value) ? number(value) : value;
  return read;
}

const isNumber = /^[-−+]?\d+(\.\d+)?(e[-−+]?\d+)?$/;

function rule(english: string, other: string) {
  const names: string[] = [];
  const pieces = english.split(/\{(\*?\w+)\}/).map((piece, k) => {
    if (k % 2 === 0) return piece.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
    names.push(piece);
    return '(.+?)';
  });
  return { form: new RegExp(`^${pieces.join('')}$`, 's'), names, other };
}
