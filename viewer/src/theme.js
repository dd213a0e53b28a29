// Colours of both themes: Okabe and Ito's palette, as in the figures; on a dark ground the lighter blue takes blue's part.
const ORANGE = "#E69F00";
const GREEN = "#009E73";
const VERMILION = "#D55E00";
const PURPLE = "#CC79A7";

export const THEMES = {
  light: {
    name: "light",
    ground: "#ffffff",
    text: "#222222",
    motion: "#0072B2",
    border: VERMILION,
    stable: GREEN,
    family: "#8a8a8a",
    velocity: "#a8477c",
    rotor: VERMILION,
    momentum: "#222222",
    axes: ["#0072B2", "#c78500", GREEN],
    sphere: "#eef1f4",
    body: "#b9c6d3",
    edge: "#5a6672",
    plane: "#dfe4e8",
    ring: "#b4bcc4",
    lamp: 1.0,
  },
  dark: {
    name: "dark",
    ground: "#14171b",
    text: "#e6e6e6",
    motion: "#56B4E9",
    border: "#f0803c",
    stable: "#1fbf92",
    family: "#7d848c",
    velocity: PURPLE,
    rotor: "#f0803c",
    momentum: "#f2f2f2",
    axes: ["#56B4E9", ORANGE, "#1fbf92"],
    sphere: "#2a3038",
    body: "#66727f",
    edge: "#aab4be",
    plane: "#2a3038",
    ring: "#4c5660",
    lamp: 1.1,
  },
};
