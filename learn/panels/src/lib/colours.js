// The page's colours, so that a vector has the same colour in a panel, on the page and in a figure.
import { THEMES } from "../../../../viewer/src/theme.js";

/** What only panels draw, and what the page's table may not name yet. */
const OWN = {
  light: { quiet: "#5a6068", line: "#d5dae0", momentumSphere: "#c3dcf0", energyEllipsoid: "#f5d58a", approximation: "#a4521c",
    change: "#00795a", wood: "#c9a071", metal: "#b9c3cd", brass: "#d3a64f", cover: "#2f5d8a", paper: "#f6f1e4",
    weight: "#6f6f6f", torque: "#6b4fc8", bodyCone: "#56B4E9", herpolhode: "#a8477c" },
  dark: { quiet: "#a2abb5", line: "#343b44", momentumSphere: "#3d6a90", energyEllipsoid: "#a08a38", approximation: "#e39a5f",
    change: "#1fbf92", wood: "#7a5c3c", metal: "#78838f", brass: "#b98d3c", cover: "#3f7ab5", paper: "#d9d3c3",
    weight: "#a0a7ae", torque: "#a692f0", bodyCone: "#9ad4f5", herpolhode: "#CC79A7" },
}; // prettier-ignore

/** Return the colours that the reader's system asks for; where the page has a colour, it is that. */
export function currentTheme() {
  const name = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  return { ...OWN[name], ...THEMES[name] };
}

/** Return [r, g, b] of "#rrggbb". */
export const channels = (colour) => [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));

/** Return a colour between two. */
export function mixed(one, other, share) {
  const [a, b] = [channels(one), channels(other)];
  return `#${a.map((x, k) => Math.round(x + share * (b[k] - x)).toString(16).padStart(2, "0")).join("")}`;
}

/** Return a colour as it looks in so much light, 1 being the colour itself. */
export function lit(colour, light) {
  return light <= 1 ? mixed("#000000", colour, Math.max(0, light)) : mixed(colour, "#ffffff", Math.min(1, light - 1));
}

/** Where the light comes from, in the camera's directions. */
export const LIGHT = [-0.43, 0.63, 0.645];

/** Return the light on a surface by its normal in the camera's directions. */
export const lightOn = (normal) =>
  0.72 + 0.34 * Math.max(0, normal[0] * LIGHT[0] + normal[1] * LIGHT[1] + normal[2] * LIGHT[2]);
