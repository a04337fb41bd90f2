// The links are right for an address at the top of the site. Deeper down the top is looked for, folder by folder: it is where the manifest lies.
(async () => {
  for (let top = new URL('./', location.href), more = true; more; top = new URL('../', top)) {
    more = top.pathname !== '/';
    const found = await fetch(new URL('manifest.webmanifest', top))
      .then((r) => (r.ok ? r.json() : null))
      .catch(() => null);
    if (found?.short_name !== 'Windgrove') continue;
    for (const link of document.links) link.href = new URL(link.getAttribute('href'), top).href;
    break;
  }
  document.documentElement.dataset.ready = 'true';
})();
