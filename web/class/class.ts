/** The script of "Use it in class": what is copied has the address where this page is. */
import './class.css';
import { followLanguage } from '../figures/language.js';

followLanguage();

const text = document.querySelector<HTMLElement>('[data-site]');
const here = new URL('../', location.href).href;
const atBuild = text?.dataset.site ?? here;

for (const snippet of document.querySelectorAll<HTMLElement>('.snippet')) {
  const code = snippet.querySelector('code') as HTMLElement;
  const button = snippet.querySelector('button') as HTMLButtonElement;
  // From a disk there is no address that others could use.
  if (location.protocol.startsWith('http')) code.textContent = (code.textContent ?? '').replaceAll(atBuild, here);
  const label = button.textContent ?? '';
  button.addEventListener('click', async () => {
    const copied = await navigator.clipboard?.writeText(code.textContent ?? '').then(
      () => true,
      () => false,
    );
    if (!copied) getSelection()?.selectAllChildren(code);
    button.textContent = (copied ? button.dataset.copied : button.dataset.selected) ?? label;
  });
  button.addEventListener('blur', () => {
    button.textContent = label;
  });
}
