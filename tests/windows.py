"""Windows of the browser, which tests take one after another: to open one costs as much as what is then looked at.

What a page could leave behind goes before the next one is opened: the page itself, and keys and buttons that are held.
Pages store nothing. A test that changes more, as permissions, takes a window of its own.
"""

from playwright.sync_api import Error

SETTLED = """after => new Promise((done) =>
  setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(() => done())), after))"""
IDLE = 4  # windows that wait for the next test; each is a process
SIZE = {"width": 1280, "height": 860}


class Window:
    """A window, offline, with what its page complained about and asked for."""

    def __init__(self, browser, options):
        self.options = options
        self.context = browser.new_context(offline=True, **options)
        self.tab = self.context.new_page()
        self.complaints, self.requests = [], []
        self.tab.on("console", lambda message: message.type == "error" and self.complaints.append(message.text))
        self.tab.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.tab.on("request", lambda request: self.requests.append(request.url))

    def furnish(self, viewport, color_scheme, reduced_motion):
        self.tab.set_viewport_size(viewport)
        self.tab.emulate_media(color_scheme=color_scheme, reduced_motion=reduced_motion)
        self.complaints.clear()
        self.requests.clear()

    def settle(self, after=0):
        """Wait until what the page itself does within so many ms is done and drawn.

        The page waits, not the test: its timers and frames keep their order on a machine under any load.
        """
        self.tab.evaluate(SETTLED, after)

    def empty(self):
        for page in self.context.pages:
            if page is not self.tab:
                page.close()
        self.tab.goto("about:blank")
        self.tab.mouse.up()
        self.tab.mouse.move(0, 0)
        for key in ("Shift", "Control", "Alt", "Meta"):
            self.tab.keyboard.up(key)


class Windows:
    """All windows of a worker."""

    def __init__(self, browser):
        self.browser, self.idle = browser, []

    def take(self, own=False, viewport=SIZE, color_scheme="light", reduced_motion="reduce", **options):
        """Return an empty window: one of its own for a test that changes more than a page."""
        found = next((one for one in self.idle if one.options == options), None) if not own else None
        if found:
            self.idle.remove(found)
        else:
            found = Window(self.browser, options)
        found.furnish(viewport, color_scheme, reduced_motion)
        found.own = own
        return found

    def give_back(self, window):
        try:
            window.empty()
        except Error:  # it has crashed, or its test closed it
            window.own = True
        if window.own:
            window.context.close()
            return
        self.idle.append(window)
        if len(self.idle) > IDLE:
            self.idle.pop(0).context.close()
