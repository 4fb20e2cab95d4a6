// Checks of a page, each a function whose value is the list of what is wrong; used by test_page_access.py.

({
names: () => {
  const faults = [];
  const say = (element, words) => faults.push(`${words}: ${element.outerHTML.slice(0, 120)}`);
  const ids = [...document.querySelectorAll('[id]')].map((element) => element.id);
  ids.filter((id, place) => ids.indexOf(id) !== place).forEach((id) => faults.push(`id twice: ${id}`));
  const named = (element) => element.getAttribute('aria-label')?.trim() || element.title?.trim() ||
    element.getAttribute('aria-labelledby')?.split(' ').map((id) => document.getElementById(id)?.textContent).join('').trim() ||
    [...(element.labels ?? [])].map((label) => label.textContent).join('').trim();
  for (const element of document.querySelectorAll('input, select, textarea')) if (!named(element)) say(element, 'no label');
  for (const element of document.querySelectorAll('button, a[href], summary'))
    if (!named(element) && !element.textContent.trim()) say(element, 'no name');
  for (const element of document.querySelectorAll('canvas, svg, img'))
    if (!element.getAttribute('aria-hidden') && !named(element) && !element.alt) say(element, 'picture without words');
  for (const element of document.querySelectorAll('canvas')) if (!element.getAttribute('role')) say(element, 'canvas without role');
  for (const element of document.querySelectorAll('[role=slider]'))
    if (!element.hasAttribute('aria-valuenow')) say(element, 'slider without value');
  for (const element of document.querySelectorAll('[aria-describedby], [aria-labelledby], [aria-controls]'))
    for (const name of ['aria-describedby', 'aria-labelledby', 'aria-controls'])
      for (const id of (element.getAttribute(name) ?? '').split(' ').filter(Boolean))
        if (!document.getElementById(id)) say(element, `${name} names nothing`);
  for (const element of document.querySelectorAll('[tabindex]')) if (element.tabIndex > 0) say(element, 'tabindex above 0');
  for (const element of document.querySelectorAll('[aria-hidden=true] a, [aria-hidden=true] button, [aria-hidden=true] input'))
    say(element, 'hidden but reachable');
  for (const table of document.querySelectorAll('table')) if (!table.querySelector('th')) say(table, 'table without heads');
  if (!document.documentElement.lang) faults.push('no language');
  for (const tag of ['main', 'header']) if (document.querySelectorAll(tag).length !== 1) faults.push(`not one ${tag}`);
  for (const nav of document.querySelectorAll('nav')) if (!named(nav)) say(nav, 'nav without name');
  return faults;
},

contrast: () => {
  const parts = (text) => (text.match(/[\d.]+/g) ?? []).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((v) => v / 255).map((v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const color = parts(getComputedStyle(at).backgroundColor);
      if (color.length === 3 || color[3] === 1) return color;
    }
    return [255, 255, 255];
  };
  const ratio = (one, other) => {
    const [a, b] = [light(one), light(other)].sort((x, y) => y - x);
    return (a + 0.05) / (b + 0.05);
  };
  const faults = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (!walker.currentNode.textContent.trim() || !element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    if (element.closest('.unseen, [disabled], option, script, style, .skip')) continue;
    const style = getComputedStyle(element);
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    const found = ratio(parts(style.color), ground(element));
    if (found < (large ? 3 : 4.5)) faults.push(`${found.toFixed(2)}: ${element.textContent.trim().slice(0, 40)}`);
  }
  for (const element of document.querySelectorAll('input:not([type=radio]):not([type=range]):not([type=checkbox]):not([type=file]), select, button, textarea')) {
    if (!element.checkVisibility() || element.disabled) continue;
    const style = getComputedStyle(element);
    const around = ground(element.parentElement);
    const best = Math.max(ratio(parts(style.borderTopColor), around), ratio(parts(style.backgroundColor), around));
    if (best < 3) faults.push(`edge ${best.toFixed(2)}: ${element.outerHTML.slice(0, 80)}`);
  }
  return faults;
},

palette: () => {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(['ink', 'muted', 'zone-ink', 'panel', 'zone', 'red', 'blue', 'green', 'purple', 'orange']
    .map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
},

stop: () => {
  const at = document.activeElement;
  const around = [at, at.parentElement, at.closest('.switch')].filter(Boolean);
  const seen = around.map((element) => getComputedStyle(element))
    .some((style) => style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2);
  return [window.stops.indexOf(at), seen];
},
})
