/** What a file, or a choice about it, does not allow; the message says what is wrong and what to do. */
export class Refusal extends Error {}

/** Return a text in quotes, shortened. */
export const shown = (text) => `"${text.length > 60 ? `${text.slice(0, 57)}...` : text}"`;
