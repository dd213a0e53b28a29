// The words of the page in the reader's language, found by their English text; what has no translation stays English.
const ENGLISH = "en";
const spoken = { language: ENGLISH, mark: ".", languages: [], table: {} };

/** Take what `viewer/words` holds: the languages, and of each English text its translations in their order. */
export const learn = ({ languages, table }) => Object.assign(spoken, { languages, table });

/** The words of those who bring a picture of their own: {de: {English: German}}. */
const brought = (language) => globalThis.polhodeWords?.[language];

/** Return what the page can speak, English first. */
export const languages = () => [...new Set([ENGLISH, ...spoken.languages, ...Object.keys(globalThis.polhodeWords ?? {})])];

/** Return the first of the wanted languages that the page can speak, "de" for "de-CH" as well; English for none of them. */
export function knownOf(wanted) {
  const found = wanted.map((name) => String(name).toLowerCase().split("-")[0]);
  return found.find((name) => languages().includes(name)) ?? ENGLISH;
}

/** Speak a language from now on. */
export function speak(language) {
  const mark = new Intl.NumberFormat(language).formatToParts(1.5).find(({ type }) => type === "decimal").value;
  Object.assign(spoken, { language, mark });
}

export const language = () => spoken.language;

/**
 * Return a text in the language that is spoken.
 *
 * @param text in English, with {names} where values go; or a pair of such a text and its values
 * @param values by name
 */
export function say(text, values = null) {
  if (Array.isArray(text)) return say(...text);
  const found = translated(text, spoken.language) ?? text;
  return values ? found.replace(/\{(\w+)\}/g, (whole, name) => (Object.hasOwn(values, name) ? numbered(values[name]) : whole)) : found;
}

/** Return the translation of a text, undefined where there is none. */
function translated(text, into) {
  const own = brought(into);
  if (own && Object.hasOwn(own, text)) return own[text];
  if (!Object.hasOwn(spoken.table, text)) return undefined;
  return spoken.table[text][spoken.languages.indexOf(into)] || undefined;
}

const numbered = (value) => (typeof value === "number" ? decimal(String(value)) : value);

/** Return a text with its decimal points as the language writes them. */
export const decimal = (text) => (spoken.mark === "." ? text : text.replace(/(\d)\.(?=\d)/g, `$1${spoken.mark}`));

/** Return numbers as texts, one after the other: semicolons divide those with decimal commas. */
export const listed = (texts) => texts.map(decimal).join(spoken.mark === "," ? "; " : ", ");

/** Return what a function returns while English is spoken, as for what programs read. */
export function inEnglish(act) {
  const { language: before, mark } = spoken;
  Object.assign(spoken, { language: ENGLISH, mark: "." });
  try {
    return act();
  } finally {
    Object.assign(spoken, { language: before, mark });
  }
}
