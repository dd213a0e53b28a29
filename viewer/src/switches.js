// What of a picture is shown, as its legend's checkboxes say; a choice holds for every motion until it is taken back.
const chosen = new Map();

/** Whether a part of a picture is shown: as chosen, else as is usual for this motion. */
export const isOn = ({ key, usual = true }) => chosen.get(key) ?? usual;

export const turn = (key, on) => chosen.set(key, on);

/** Return a legend's entry whose checkbox shows or hides what it names. */
export const switched = (key, color, text, usual = true) => ({ key, color, text, usual });
