// Light or dark: as the reader's system has it, unless the reader says otherwise.
const kKey = 'solitaire-theme';
const kNames = { auto: 'System', light: 'Light', dark: 'Dark' };

function stored() {
  try {
    return localStorage.getItem(kKey);
  } catch {
    return null;  // a browser may refuse to store anything for files
  }
}

function store(theme) {
  try {
    localStorage.setItem(kKey, theme);
  } catch {
    // Then the choice holds until the page is closed.
  }
}

export function applyStoredTheme() {
  const theme = stored();
  if (theme in kNames) document.documentElement.dataset.theme = theme;
}

/** Returns a control with which the reader chooses. */
export function themeChoice(element) {
  const options = Object.entries(kNames).map(([value, text]) => element('option', { value }, text));
  const select = element('select', { 'data-theme-choice': '' }, options);
  select.value = document.documentElement.dataset.theme ?? 'auto';
  select.onchange = () => {
    document.documentElement.dataset.theme = select.value;
    store(select.value);
    document.dispatchEvent(new Event('themechange'));
  };
  return select;
}

export function isDark() {
  const theme = document.documentElement.dataset.theme ?? 'auto';
  return theme === 'dark' || (theme === 'auto' && matchMedia('(prefers-color-scheme: dark)').matches);
}

/** Calls back whenever the colours change. Returns what ends that. */
export function onThemeChange(callback) {
  const system = matchMedia('(prefers-color-scheme: dark)');
  system.addEventListener('change', callback);
  document.addEventListener('themechange', callback);
  return () => {
    system.removeEventListener('change', callback);
    document.removeEventListener('themechange', callback);
  };
}
