// How a picture and a graph share the canvas.

/** Return two boxes {left, top, width, height}: side by side where there is room, else one above the other. */
export function split(width, height, share = 0.55, gap = 8) {
  if (width > 1.45 * height) {
    const first = Math.round(width * share);
    return [{ left: 0, top: 0, width: first, height }, { left: first + gap, top: 0, width: width - first - gap, height }];
  }
  const first = Math.round(height * share);
  return [{ left: 0, top: 0, width, height: first }, { left: 0, top: first + gap, width, height: height - first - gap }];
}

/** Return the box of a graph inside a box, with room for what stands beside the axes. */
export const inset = ({ left, top, width, height }, before = 40, above = 24, after = 12, below = 38) => ({
  left: left + before, top: top + above, width: width - before - after, height: height - above - below,
}); // prettier-ignore
