"""A small client of the WebDriver protocol for headless Chromium: as much as the tests need."""

import json
import os
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"

# WebGL in software, so that pictures need no graphics processor and are alike everywhere. Not with
# --disable-gpu: the browser then reads each picture back, and complains on the console that this
# is slow. Nothing of the browser's own that would use the network.
BASE_FLAGS = [
    "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-extensions", "--force-device-scale-factor=1", "--hide-scrollbars",
]
WITH_WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
WITHOUT_WEBGL = ["--disable-gpu", "--disable-3d-apis"]


class WebDriverError(Exception):
    pass


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Driver:
    """A chromedriver process; makes sessions."""

    def __init__(self, program, browser):
        self.browser = browser
        self.url = f"http://127.0.0.1:{free_port()}"
        self.opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        self.process = subprocess.Popen([program, f"--port={self.url.rsplit(':', 1)[1]}"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self._wait_until_ready()

    def _wait_until_ready(self):
        for _ in range(200):
            try:
                if self.call("GET", "/status")["ready"]:
                    return
            except (OSError, WebDriverError):
                pass
            time.sleep(0.05)
        self.close()
        raise WebDriverError("chromedriver does not answer")

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.url + path, data=data, method=method,
                                         headers={"Content-Type": "application/json"})
        try:
            with self.opener.open(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            value = json.load(error)["value"]
            raise WebDriverError(f"{value['error']}: {value['message']}") from None

    def session(self, flags=(), graphics=WITH_WEBGL, size=(1280, 900)):
        return Session(self, [*BASE_FLAGS, *graphics, *flags, f"--window-size={size[0]},{size[1]}"])

    def close(self):
        self.process.terminate()
        self.process.wait(10)


class Session:
    """A browser with one window and a new profile."""

    def __init__(self, driver, flags):
        self.driver = driver
        self.profile = tempfile.TemporaryDirectory(prefix="page_test_", ignore_cleanup_errors=True)
        options = {
            "binary": driver.browser,
            "args": [*flags, f"--user-data-dir={self.profile.name}"],
            "prefs": {"download.default_directory": self.downloads},
        }
        value = driver.call("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome",
            "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
        }}})
        self.path = "/session/" + value["sessionId"]

    @property
    def downloads(self):
        return os.path.join(self.profile.name, "downloads")

    def call(self, method, path, body=None):
        return self.driver.call(method, self.path + path, body)

    def close(self):
        self.call("DELETE", "")
        self.profile.cleanup()

    def open(self, url):
        self.call("POST", "/url", {"url": url})

    def url(self):
        return self.call("GET", "/url")

    def run(self, script, *arguments):
        """The value that the body of a function returns in the page."""
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def run_async(self, script, *arguments):
        """As `run`, but the value is what the script gives to its last argument, a function."""
        return self.call("POST", "/execute/async", {"script": script, "args": list(arguments)})

    def devtools(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def wait(self, script, *arguments, seconds=60):
        """Until the script returns something true; that is returned."""
        end = time.monotonic() + seconds
        while True:
            value = self.run(script, *arguments)
            if value:
                return value
            if time.monotonic() > end:
                raise WebDriverError(f"waited in vain for: {script}")
            time.sleep(0.03)

    def find(self, selector):
        return self.call("POST", "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def click(self, selector, seconds=10):
        """As a person does, who waits until nothing lies over the element: the page may still arrange itself."""
        end = time.monotonic() + seconds
        while True:
            try:
                self.call("POST", f"/element/{self.find(selector)}/click", {})
                return
            except WebDriverError as error:
                if not str(error).startswith("element click intercepted") or time.monotonic() > end:
                    raise
            time.sleep(0.1)

    def text(self, selector):
        return self.call("GET", f"/element/{self.find(selector)}/text")

    def choose(self, selector, value):
        """Takes an option of a select as a person would: the page hears of it."""
        self.run("""const select = document.querySelector(arguments[0]);
                    select.value = arguments[1];
                    select.dispatchEvent(new Event('input', {bubbles: true}));
                    select.dispatchEvent(new Event('change', {bubbles: true}));""", selector, value)

    def click_at(self, selector, x, y):
        """Presses and releases the mouse at a place of an element, from its upper left corner."""
        place = self.run("""const element = document.querySelector(arguments[0]);
                            element.scrollIntoView({block: 'nearest'});
                            const frame = element.getBoundingClientRect();
                            return [frame.left, frame.top];""", selector)
        at = {"x": round(place[0] + x), "y": round(place[1] + y), "origin": "viewport"}
        self.call("POST", "/actions", {"actions": [{
            "type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
            "actions": [{"type": "pointerMove", "duration": 0, **at},
                        {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}],
        }]})

    def press(self, *keys):
        """Presses keys one after the other, at what has the focus."""
        actions = []
        for key in keys:
            actions += [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]
        self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": actions}]})

    def console(self):
        """What the console was told since the last call: entries with `level` and `message`."""
        return self.call("POST", "/se/log", {"type": "browser"})

    def requests(self):
        """The addresses asked for since the last call."""
        addresses = []
        for entry in self.call("POST", "/se/log", {"type": "performance"}):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                addresses.append(message["params"]["request"]["url"])
        return addresses
