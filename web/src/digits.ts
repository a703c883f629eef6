/** How digits are written. Groups are set off by thin spaces in every language, as the SI has it. */

const thinSpace = '\u202f';

/** 2048 → "2 048" */
export function count(value: number): string {
  return minus(
    Math.round(value)
      .toString()
      .replace(/\B(?=(\d{3})+$)/g, thinSpace),
  );
}

/** With true minus signs before numbers and between terms; hyphens stay. */
export function minus(text: string): string {
  return text.replace(/-(?=[\d ])/g, '−');
}

/** With the decimal mark of a language. */
export function decimals(text: string, language: string): string {
  return language === 'de' ? text.replace(/(\d)\.(?=\d)/g, '$1,') : text;
}
