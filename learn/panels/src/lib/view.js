// From space to the picture: a parallel projection that a hand can turn.

/** Return the rows [right, up, towards the eye] of a camera; `turn` goes round z, `lift` above the plane of x and y [rad]. */
export function cameraRows(turn, lift) {
  const [c, s, p, q] = [Math.cos(turn), Math.sin(turn), Math.cos(lift), Math.sin(lift)];
  return [[-s, c, 0], [-q * c, -q * s, p], [p * c, p * s, q]]; // prettier-ignore
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** A view: `scale` [pixels per unit of length] and the pixel of the origin. */
export class View {
  constructor({ turn, lift, scale, x, y }) {
    this.rows = cameraRows(turn, lift);
    Object.assign(this, { scale, x, y });
  }

  /** Return [right, up, towards the eye] of a point or vector, in units of length. */
  turned(p) {
    return [dot(this.rows[0], p), dot(this.rows[1], p), dot(this.rows[2], p)];
  }

  /** Return the pixel of a point. */
  pixel(p) {
    return [this.x + this.scale * dot(this.rows[0], p), this.y - this.scale * dot(this.rows[1], p)];
  }

  /** Return how near to the eye a point is. */
  depth(p) {
    return dot(this.rows[2], p);
  }

  /** Return the vector in space that a way on the picture [pixels] stands for. */
  unproject(dx, dy) {
    const [right, up] = this.rows;
    return right.map((x, k) => (x * dx - up[k] * dy) / this.scale);
  }
}

/** Return R F Rᵀ for a symmetric form F, so that it measures vectors given in the camera's directions. */
export function formInView(view, form) {
  const half = view.rows.map((row) => form.map((line) => dot(line, row)));
  return view.rows.map((row) => half.map((column) => dot(row, column)));
}
