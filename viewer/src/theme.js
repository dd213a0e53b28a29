// Colours of both themes by what they stand for, from the table that the figures take theirs from: Okabe and Ito's palette,
// darker where thin lines on white need it; on a dark ground the lighter blue takes blue's part.
import table from "../../src/polhode/figures/colours.json" with { type: "json" };

export const THEMES = {
  light: { ...table.light, name: "light", lamp: 1.0 },
  dark: { ...table.dark, name: "dark", lamp: 1.1 },
};

const DASHES = [[], [6, 3], [2, 2], [8, 3, 2, 3]]; // pixels on and off, in turn

/** Return colour and dashes of the k-th of many curves: colours repeat after six, never with the same dashes. */
export function seriesStyle(theme, k) {
  const colors = [theme.motion, theme.axes[1], theme.stable, theme.border, theme.bodyCone, theme.velocity];
  return { color: colors[k % colors.length], dash: DASHES[Math.floor(k / colors.length) % DASHES.length] };
}
