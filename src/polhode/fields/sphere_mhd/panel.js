// Vorticity and current of a conducting fluid, laid around globes, with lines of the field.
(globalThis.polhodePanels ??= {}).magnetic_vorticity = (motion, data, theme, tools) =>
  tools.mapGlobe(data, theme, {
    title: "Vorticity", words: "against the sphere, with lines of the field", legend: ["clockwise", "anticlockwise"],
  });
(globalThis.polhodePanels ??= {}).magnetic_current = (motion, data, theme, tools) =>
  tools.mapGlobe(data, theme, {
    title: "Current", words: "through the sphere, with lines of the field", legend: ["inward", "outward"],
  });
