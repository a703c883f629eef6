/** `?lang=de` leads to the page in that language, at the same place, with whatever else is asked for. */
export function followLanguage(): void {
  const wanted = new URLSearchParams(location.search).get('lang');
  const other = document.querySelector<HTMLLinkElement>(`link[hreflang="${CSS.escape(wanted ?? '')}"]`);
  if (wanted && wanted !== document.documentElement.lang && other)
    location.replace(other.href + location.search + location.hash);
}
