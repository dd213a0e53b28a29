// Reads and fits gyro logs with viewer/src/throw: JSON in on standard input, JSON out. `argv[2]` is the folder's address.
// Each case: {text, mapping: what is chosen of it, or null, fit: whether the least squares is asked for}.
import { readFileSync } from "node:fs";

const folder = process.argv[2];
const { mappingOf, openTable, readLog } = await import(`${folder}/gyro_log.js`);
const { startOf } = await import(`${folder}/linear_fit.js`);
const { fitLog, restBias, throwsOf } = await import(`${folder}/throw_fit.js`);
const { dataOf } = await import(`${folder}/page_data.js`);
const { Refusal } = await import(`${folder}/refusal.js`);

function answer({ text, mapping, fit }) {
  try {
    const table = openTable(text);
    const log = readLog(table, { ...mappingOf(table), ...mapping });
    const { limit, windows, throws } = throwsOf(log);
    const { moments, axes, singularValues, noise, degenerate } = startOf(throws);
    const found = fit && !degenerate ? fitLog(log) : null;
    return {
      dialect: log.dialect, rateUnit: log.rateUnit, notes: log.notes, times: [...log.times], rates: [...log.rates],
      limit, windows, samples: throws.map(({ times }) => times.length),
      start: { moments, axes, singularValues, noise, degenerate }, rest: restBias(log, windows),
      fit: found && { ...found.fit, residuals: undefined }, misfit: found?.misfit ?? null,
      page: found && (({ summary, story }) => ({ summary, story }))(dataOf(found, log, "log.csv")),
    };
  } catch (error) {
    if (error instanceof Refusal) return { refused: error.message };
    throw error;
  }
}

const cases = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(cases.map(answer)));
