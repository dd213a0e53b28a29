// What slows a rolling disk: laws that state a power P at tilt α towards the table and rate Ω of the contact's way round.
import { positive } from "./turning.js";

const STOPPING = 30; // no couple brakes a rate faster than this many √(g/(a sin θ)), see `couples`

/** By the name that a spec gives them: the constant's name and unit, whether the couple is vertical, and P [W]. */
const LAWS = {
  // Moffatt, Nature 404 (2000) 833
  "air-layer": ["viscosity", "Pa s", false, (mu, { g, a }, tilt) => (Math.PI * mu * g * a * a) / (tilt * tilt)],
  // Bildsten, Phys. Rev. E 66 (2002) 056309
  "boundary-layer": ["coefficient", "W s^(5/2)", false, (k, disk, tilt, rate) => k * rate * rate * Math.sqrt(rate)],
  // these and the last: Leine, Arch. Appl. Mech. 79 (2009) 1063, section 4
  "viscous-contour-friction": ["coefficient", "W s²", false, (k, disk, tilt, rate) => k * rate * rate],
  "dry-contour-friction": ["coefficient", "1", false, (k, { m, g, a }, tilt, rate) => k * m * g * a * rate],
  "rolling-couple": ["arm", "m", false, (k, { m, g }, tilt, rate) => k * m * g * rate * Math.sin(tilt)],
  "drilling-friction": ["arm", "m", true, (k, { m, g }, tilt, rate) => k * m * g * rate * tilt * tilt],
};

/** Return laws [{vertical, power(disk, tilt, rate)}] from [{law, and its constant}]. */
export function checkedLaws(dissipation) {
  if (!Array.isArray(dissipation)) {
    throw new RangeError("`dissipation` must be a list of laws, like [{law: \"air-layer\", viscosity: 1.8e-5}].");
  }
  return dissipation.map((given, n) => {
    const found = given !== null && typeof given === "object" && Object.hasOwn(LAWS, given.law) && LAWS[given.law];
    if (!found) {
      const names = Object.keys(LAWS).join(", ");
      throw new RangeError(`\`dissipation[${n}].law\` must be one of ${names}; got ${JSON.stringify(given?.law)}.`);
    }
    const [key, unit, vertical, power] = found;
    const constant = positive(`dissipation[${n}].${key}`, given[key], unit);
    return { vertical, power: (disk, tilt, rate) => power(constant, disk, tilt, rate) };
  });
}

/**
 * Return [τ2, τ3] [N m], the couples of all laws along e2 and e3.
 *
 * A horizontal couple Q (e3 − c/s e2) works on the rate ψ̇ = ω3 − ω2 c/s, a vertical one on ω·z, and Q = −P/rate. Where the
 * rate vanishes that does not exist; there the couple is capped so that it brakes the rate no faster than by e in a thirtieth
 * of the time √(a sin θ/g). A disk that still precesses loses exactly P.
 */
export function couples(disk, laws, theta, w2, w3) {
  let [tau2, tau3] = [0, 0];
  const [s, c] = [Math.sin(theta), Math.cos(theta)];
  const size = Math.abs(s); // a step may try θ < 0 before the end there is found
  const [tilt, precession] = [Math.min(theta, Math.PI - theta), Math.abs(w2) / size];
  for (const law of laws) {
    const [n2, n3] = law.vertical ? [s, c] : [-c / s, 1];
    const rate = n2 * w2 + n3 * w3;
    const response = disk.accelerations(n2, n3);
    const cap = (STOPPING * Math.sqrt(disk.g / (disk.a * size))) / (n2 * response[0] + n3 * response[1]);
    const power = law.power(disk, tilt, precession);
    const Q = power >= cap * rate * rate ? -rate * cap : -power / rate;
    tau2 += n2 * Q;
    tau3 += n3 * Q;
  }
  return [tau2, tau3];
}
