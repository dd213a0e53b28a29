"""One self-contained page that shows a motion: written to a file, or shown inside a notebook."""

from polhode.viewer.page import NotebookPage, page_of_report, show, write_page

__all__ = ["NotebookPage", "page_of_report", "show", "write_page"]
