/** The script of the article: figures come to life, the table is measured anew. */
import './article.css';
import { followLanguage } from '../figures/language.js';
import { hydrateAll } from '../figures/mount.js';
import { reachWide } from '../figures/wide.js';
import type { TableWords } from './measured.js';

followLanguage();
hydrateAll();

reachWide(document.querySelectorAll('.formula'));

for (const table of document.querySelectorAll<HTMLElement>('.measured')) measureIn(table);

function measureIn(table: HTMLElement): void {
  const words = JSON.parse(table.dataset.words ?? '{}') as TableWords;
  const form = table.querySelector('form') as HTMLFormElement;
  const select = table.querySelector('select') as HTMLSelectElement;
  const when = table.querySelector('.when') as HTMLElement;
  // A browser that comes back to a page may fill in what was there.
  form.reset();
  let turn = 0;
  const again = async () => {
    const own = ++turn;
    when.textContent = words.measuring;
    table.dataset.state = 'busy';
    try {
      const [{ foundOf, foundSign, foundText, measure, status }, { sharedClient }] = await Promise.all([
        import('./measured.js'),
        import('../src/start-client.js'),
      ]);
      const measured = await measure(await sharedClient(), select.value);
      if (own !== turn) return;
      for (const row of table.querySelectorAll<HTMLElement>('[data-operator]')) {
        for (const cell of row.querySelectorAll<HTMLElement>('[data-property]')) {
          const found = foundOf(measured, row.dataset.operator ?? '', cell.dataset.property as never);
          cell.dataset.verdict = found.verdict;
          (cell.querySelector('.sign') as HTMLElement).textContent = foundSign(found);
          (cell.querySelector('.word') as HTMLElement).textContent = foundText(found, words);
        }
      }
      when.textContent = status(measured, 'live', words);
      table.dataset.state = 'live';
    } catch (reason) {
      if (own !== turn) return;
      console.error(reason);
      when.textContent = words.failed;
      table.dataset.state = 'failed';
    }
  };
  select.addEventListener('change', again);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    void again();
  });
}
