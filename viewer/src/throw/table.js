// Plain tables of any program: their separator, the line that names the columns, and the numbers of some of them.
import { ANGLE_UNITS, findUnit, RATE_UNITS, TIME_UNITS } from "./header_words.js";
import { say } from "../say.js";
import { Refusal, shown } from "./refusal.js";

export const DELIMITERS = [";", "\t", ",", " "]; // where a semicolon divides lines into equal numbers, commas are decimal ones
const HEAD = 60; // lines with cells that the form is found from
const MOST_COMMENTS = 2000;
const LONGEST_LINE = 1e6; // characters
const MISSING = new Set(["", "nan", "na", "n/a", "null", "none", "-"]);
const NUMBER = /^(?:[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?|[+-]?(?:nan|inf|infinity))$/i;
const TWO_NUMBERS = /^[+-]?[\d.]+(?:[eE][+-]?\d+)?\s+[+-]?[\d.]+(?:[eE][+-]?\d+)?$/;
const PLAIN_NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,6})?$/;
const DECIMAL_COMMA = /^[+-]?\d*,\d+(?:[eE][+-]?\d+)?$/;
const WORD = /"[^"]*"|[^\s[("]+(?:[ \t]*(?:\[[^\]]*\]|\([^)]*\)))?/g;

/** Return the lines of a text, {number from 1, text}; throws a Refusal for what is not text. */
export function linesOf(text) {
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\n|\r/);
  if (lines.at(-1) === "") lines.pop();
  return lines.map((line, k) => {
    if (line.includes("\0") || line.includes("\uFFFD")) throw new Refusal(say("line {line} is not UTF-8 text, so this is not a table. Choose the app's CSV file, unpacked from its archive.", { line: k + 1 }));
    if (line.length > LONGEST_LINE) throw new Refusal(say("line {line} has more than {most} characters. Choose a table with one sample in each line.", { line: k + 1, most: LONGEST_LINE }));
    return { number: k + 1, text: line };
  });
}

/** Whether a line holds no cells: it is blank, or begins with # or %. */
const isComment = (text) => /^\s*(?:[#%]|$)/.test(text);

/** Return the cells of a line, without the blanks around them and the quotes; null for quotes that do not close. */
export function splitCells(text, delimiter) {
  if (!text.includes('"')) {
    const trimmed = text.trim();
    if (delimiter === " ") return trimmed ? trimmed.split(/\s+/) : [];
    return text.split(delimiter).map((cell) => cell.trim());
  }
  const line = delimiter === " " ? text.trim().split(/\s+/).join(" ") : text;
  const cells = [];
  let at = 0;
  for (;;) {
    while (line[at] === " " && delimiter !== " ") at += 1;
    let cell = "";
    if (line[at] === '"') {
      for (at += 1; line[at] !== '"' || line[at + 1] === '"'; at++) {
        if (at >= line.length) return null;
        if (line[at] === '"') at += 1;
        cell += line[at];
      }
      at += 1;
      if (at < line.length && line[at] !== delimiter) return null;
    } else {
      const end = line.indexOf(delimiter, at);
      cell = end < 0 ? line.slice(at) : line.slice(at, end);
      at = end < 0 ? line.length : end;
    }
    cells.push(cell.trim());
    if (at >= line.length) return cells;
    at += 1;
  }
}

/**
 * Return {delimiter, width, names, first} of a table from its first lines: `names` of the columns, none where no line names
 * them, and `first` the number of the first line with numbers.
 */
export function detectForm(lines) {
  const head = lines.slice(0, MOST_COMMENTS + HEAD);
  const content = head.filter(({ text }) => !isComment(text)).slice(0, HEAD);
  const tried = DELIMITERS.map((delimiter) => ({ delimiter, ...countAgreeing(content, delimiter) }));
  const best = tried.reduce((one, other) => (other.count > one.count ? other : one));
  if (!best.count) {
    const first = content.length ? say("its first line is {text}", { text: shown(content[0].text) }) : say("it is empty");
    throw new Refusal(say("it has no line of numbers in two columns or more, between commas, semicolons, tabs or blanks; {first}. Choose a table with one sample in each line.", { first }));
  }
  const { delimiter, begin } = best;
  const cells = splitCells(content[begin].text, delimiter);
  const first = content[begin].number;
  const form = (names) => ({ delimiter, width: cells.length, names, first });
  const above = head.filter(({ number, text }) => isComment(text) && text.trim() && number < content[0].number).slice(-1);
  if (begin > 1) {
    const named = withUnits(content[begin - 2].text, content[begin - 1].text, delimiter, cells);
    if (named.length) return form(named);
  }
  const candidates = begin ? [content[begin - 1]] : above;
  for (const { text } of candidates) {
    const names = namesIn(text, delimiter, cells);
    if (names.length) return form(names);
  }
  if (begin) {
    const { number, text } = candidates[0];
    throw new Refusal(say("line {line} must name the {columns} columns that line {first} has; got {names} names. Name each, or delete the line.", { line: number, columns: cells.length, first, names: headerCells(text, delimiter).length }));
  }
  return form([]);
}

/** Return how many lines have as many cells as the first line of numbers, and the index of that. */
function countAgreeing(content, delimiter) {
  let begin = null;
  const widths = [];
  content.forEach(({ text }, k) => {
    const cells = splitCells(text, delimiter) ?? [];
    if (begin === null && hasNumbers(cells)) begin = k;
    if (begin !== null) widths.push(cells.length);
  });
  return begin === null ? { count: 0, begin: 0 } : { count: widths.filter((width) => width === widths[0]).length, begin };
}

function hasNumbers(cells) {
  const filled = cells.filter(Boolean);
  const numbers = filled.filter((cell) => NUMBER.test(cell));
  return cells.length > 1 && 2 * numbers.length > filled.length && !filled.some((cell) => TWO_NUMBERS.test(cell));
}

const uncommented = (text) => text.trimStart().replace(/^[#%]+/, "");
const headerCells = (text, delimiter) => splitCells(uncommented(text), delimiter) ?? [];

/** Return the names in a line for the columns of a row; none where it does not name them. */
function namesIn(text, delimiter, cells) {
  let names = headerCells(text, delimiter);
  if (delimiter === " " && names.length !== cells.length) names = (uncommented(text).match(WORD) ?? []).map((word) => word.replace(/^"+|"+$/g, ""));
  if (names.length === cells.length - 1 && !cells.at(-1)) names = [...names, ""]; // lines of numbers alone end in a delimiter
  const fits = names.length === cells.length && names.some(Boolean) && !names.some((name) => NUMBER.test(name));
  return fits ? names : [];
}

const isUnit = (word) => [TIME_UNITS, ANGLE_UNITS, RATE_UNITS].some((units) => findUnit(word, units));

/** Return names with the units of the line below them in brackets; none where that line is not one of units. */
function withUnits(text, units, delimiter, cells) {
  const names = namesIn(text, delimiter, cells);
  const below = namesIn(units, delimiter, cells).map((cell) => cell.replace(/^[[\]()]+|[[\]()]+$/g, ""));
  if (!names.length || !below.some(isUnit) || names.some(isUnit)) return [];
  return names.map((name, k) => (below[k] ? `${name} [${below[k]}]` : name));
}

/** Return "comma" where the first numbers have commas and no points, else "point". */
export function detectDecimal(lines, form) {
  if (form.delimiter === ",") return "point";
  const texts = lines.slice(0, MOST_COMMENTS + HEAD).filter(({ number, text }) => number >= form.first && !isComment(text));
  const cells = texts.slice(0, HEAD).flatMap(({ text }) => text.split(form.delimiter).map((cell) => cell.replace(/^[ "]+|[ "]+$/g, "")));
  return cells.some((cell) => DECIMAL_COMMA.test(cell)) && !cells.some((cell) => cell.includes(".")) ? "comma" : "point";
}

/** Return {numbers: a Float64Array of each column, NaN where a cell is blank, texts: the cells of the first as they stand}. */
export function readCells(lines, form, columns, decimal) {
  const numbers = columns.map(() => []);
  const texts = [];
  for (const { number, text } of lines) {
    if (number < form.first || isComment(text)) continue;
    const cells = splitCells(text, form.delimiter);
    if (!cells) throw new Refusal(say("line {line} has quotes that do not close. Check the line.", { line: number }));
    while (cells.length > form.width && !cells.at(-1)) cells.pop();
    if (cells.length !== form.width) {
      const said = form.delimiter === ","
        ? "line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it. Is the comma a decimal one? Then save it with semicolons."
        : "line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it.";
      throw new Refusal(say(said, { line: number, cells: cells.length, first: form.first, width: form.width }));
    }
    columns.forEach((column, k) => numbers[k].push(readNumber(cells[column], decimal, () => say("line {line}, {column}", { line: number, column: nameColumn(form, column) }))));
    texts.push(decimal === "comma" ? cells[columns[0]].replaceAll(",", ".") : cells[columns[0]]);
  }
  return { numbers: numbers.map((each) => Float64Array.from(each)), texts };
}

function readNumber(cell, decimal, where) {
  if (MISSING.has(cell.toLowerCase())) return NaN;
  if (decimal === "comma" && cell.includes(".")) throw new Refusal(say("{where}: {cell} has a point, and the other numbers have decimal commas. Choose one of them.", { where: where(), cell: shown(cell) }));
  const text = decimal === "comma" && DECIMAL_COMMA.test(cell) ? cell.replace(",", ".") : cell;
  const value = PLAIN_NUMBER.test(text) ? Number(text) : NaN;
  if (Number.isFinite(value) && !(value === 0 && /^[+-]?[0.]*[1-9]/.test(text))) return value;
  const why = Number.isNaN(value) ? "must be a number in decimal digits" : value === 0 ? "is so small that nothing is left of it" : "is too large for a number";
  const remedy = text.includes(":") ? "Dates and times of day are not read: give times as plain numbers, like seconds from the start." : "Correct it, or leave the cell blank.";
  throw new Refusal(`${where()}: ${shown(cell)} ${say(why)}. ${say(remedy)}`);
}

export const counted = (column) => say("column {column}", { column: column + 1 });

/** Return a column's name for messages; columns count from 0. */
export const nameColumn = (form, column) => (form.names[column] ? `${counted(column)} ${shown(form.names[column])}` : counted(column));
