// The vorticity of a fluid, laid around a globe.
(globalThis.polhodePanels ??= {}).vorticity = (motion, data, theme, tools) =>
  tools.mapGlobe(data, theme, {
    title: "Vorticity", words: "of the fluid against the sphere", legend: ["clockwise", "anticlockwise"],
  });
