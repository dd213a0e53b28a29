// One step of Dormand and Prince's method of order 8 with embedded errors of orders 5 and 3, DOP853.
// Coefficients: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I (1993), section II.5 and its code.

/** When the stages are, as parts of a step. */
export const TIMES = [
  0.0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 0.3333333333333333,
  0.25, 0.3076923076923077, 0.6512820512820513, 0.6, 0.8571428571428571, 1.0,
]; // prettier-ignore

/** For each stage, [an earlier stage, its weight]. */
export const STAGES = [
  [],
  [[0, 0.05260015195876773]],
  [[0, 0.0197250569845379], [1, 0.0591751709536137]],
  [[0, 0.02958758547680685], [2, 0.08876275643042054]],
  [[0, 0.2413651341592667], [2, -0.8845494793282861], [3, 0.924834003261792]],
  [[0, 0.037037037037037035], [3, 0.17082860872947386], [4, 0.12546768756682242]],
  [[0, 0.037109375], [3, 0.17025221101954405], [4, 0.06021653898045596], [5, -0.017578125]],
  [[0, 0.03709200011850479], [3, 0.17038392571223998], [4, 0.10726203044637328], [5, -0.015319437748624402],
    [6, 0.008273789163814023]],
  [[0, 0.6241109587160757], [3, -3.3608926294469414], [4, -0.868219346841726], [5, 27.59209969944671],
    [6, 20.154067550477894], [7, -43.48988418106996]],
  [[0, 0.47766253643826434], [3, -2.4881146199716677], [4, -0.590290826836843], [5, 21.230051448181193],
    [6, 15.279233632882423], [7, -33.28821096898486], [8, -0.020331201708508627]],
  [[0, -0.9371424300859873], [3, 5.186372428844064], [4, 1.0914373489967295], [5, -8.149787010746927],
    [6, -18.52006565999696], [7, 22.739487099350505], [8, 2.4936055526796523], [9, -3.0467644718982196]],
  [[0, 2.273310147516538], [3, -10.53449546673725], [4, -2.0008720582248625], [5, -17.9589318631188],
    [6, 27.94888452941996], [7, -2.8589982771350235], [8, -8.87285693353063], [9, 12.360567175794303],
    [10, 0.6433927460157636]],
]; // prettier-ignore

/** [stage, weight] of the step. */
export const WEIGHTS = [
  [0, 0.054293734116568765], [5, 4.450312892752409], [6, 1.8915178993145003], [7, -5.801203960010585],
    [8, 0.3111643669578199], [9, -0.1521609496625161], [10, 0.20136540080403034], [11, 0.04471061572777259],
]; // prettier-ignore

/** [stage, weight] of its difference from the embedded method of order 5, and below of order 3. */
export const ERROR_5 = [
  [0, 0.01312004499419488], [5, -1.2251564463762044], [6, -0.4957589496572502], [7, 1.6643771824549864],
    [8, -0.35032884874997366], [9, 0.3341791187130175], [10, 0.08192320648511571], [11, -0.022355307863886294],
]; // prettier-ignore

export const ERROR_3 = [
  [0, -0.18980075407240762], [5, 4.450312892752409], [6, 1.8915178993145003], [7, -5.801203960010585],
    [8, -0.4226823213237919], [9, -0.1521609496625161], [10, 0.20136540080403034], [11, 0.02265179219836082],
]; // prettier-ignore

const ERROR_3_SHARE = 0.01; // of its square in the norm, by which Hairer's code keeps the two estimates in one

/** The method on one system: it owns the room for its stages, so that a step makes no new arrays. */
export class DormandPrince {
  /**
   * @param rates function (t, state, out) that writes dy/dt into out
   * @param size numbers in a state
   */
  constructor(rates, size) {
    this.rates = rates;
    this.size = size;
    this.stages = STAGES.map(() => new Float64Array(size));
    this.inner = new Float64Array(size);
  }

  /**
   * Write the state after a step from (t, state) into `out`, which may not be `state`.
   *
   * With `begun` the first stage stands already, as after a step from the same place.
   */
  step(t, state, h, out, begun = false) {
    const { rates, size, stages, inner } = this;
    if (!begun) rates(t, state, stages[0]);
    for (let s = 1; s < stages.length; s++) {
      weigh(STAGES[s], stages, state, h, inner, size);
      rates(t + TIMES[s] * h, inner, stages[s]);
    }
    weigh(WEIGHTS, stages, state, h, out, size);
  }

  /**
   * Return the error of the step just taken over what is allowed: at most 1 for a step that holds.
   *
   * Allowed is the tolerance times a component's scale and its size.
   */
  error(h, before, after, scale, tolerance) {
    const { size, stages } = this;
    let [fifth, third] = [0, 0];
    for (let k = 0; k < size; k++) {
      const allowed = tolerance * (scale[k] + Math.max(Math.abs(before[k]), Math.abs(after[k])));
      fifth += (weighted(ERROR_5, stages, k) / allowed) ** 2;
      third += (weighted(ERROR_3, stages, k) / allowed) ** 2;
    }
    if (fifth === 0 && third === 0) return 0;
    return (Math.abs(h) * fifth) / Math.sqrt((fifth + ERROR_3_SHARE * third) * size);
  }
}

/** Return Σ weight · stage of one component. */
function weighted(row, stages, k) {
  let sum = 0;
  for (let j = 0; j < row.length; j++) sum += row[j][1] * stages[row[j][0]][k];
  return sum;
}

/** Write state + h Σ weight · stage into `out`. */
function weigh(row, stages, state, h, out, size) {
  for (let k = 0; k < size; k++) out[k] = state[k] + h * weighted(row, stages, k);
}
