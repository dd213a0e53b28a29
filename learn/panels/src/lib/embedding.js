// What a teacher pastes into a page of their own.
// pixels: controls and picture are then in sight together in a column of text, and below each other on a phone
const HEIGHT = "calc(440px + max(0px, 580px - 100vw))";

/** Return the line of HTML that shows an address in a frame. */
export const snippet = (title, address) =>
  `<iframe src="${address.replaceAll("&", "&amp;").replaceAll('"', "%22")}" title="${title}" loading="lazy" ` +
  `style="width:100%;height:${HEIGHT};border:0"></iframe>`;

/** Let the button open a dialog with that line, taken from the address as it is. */
export function addEmbedding(title) {
  const [dialog, text, copy] = ["embedding", "snippet", "copy"].map((id) => document.getElementById(id));
  document.getElementById("embed").addEventListener("click", () => {
    text.value = snippet(title, location.href);
    copy.textContent = "copy";
    dialog.showModal();
    text.select();
  });
  copy.addEventListener("click", async () => {
    text.select();
    try {
      await navigator.clipboard.writeText(text.value);
      copy.textContent = "copied";
    } catch {
      copy.textContent = "press Ctrl+C"; // a frame may not reach the clipboard; the line is selected
    }
  });
}
