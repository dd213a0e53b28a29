// Browsers let a page from a disk read no other page, so that a search there has to do without excerpts.
if (window.location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
