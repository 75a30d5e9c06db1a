"""The server of `cognate studio` for its tests: how it is started, asked and ended."""

import http.client
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = sys.argv[1]

# Takes longer than any test waits: it has to be stopped.
ENDLESS = """kind = "path-generation"
[target]
points = [[0, 0], [1, 0.3], [2, 0.1], [3, 1], [2, 2], [1, 1.5], [0.5, 1]]
[constraints]
class = "crank-rocker"
peak_acceleration_max = 1
[solve]
starts = 10000
"""
SHORT = """kind = "quick-return"
[target]
time_ratio = 1.25
[mechanism]
rocker = 290
swing_deg = 34
"""


def listens_to_interrupts():
    signal.signal(signal.SIGINT, signal.default_int_handler)


class Studio:
    """The program as a server of `file`, which may be none."""

    def __init__(self, file=None, *options, cwd=None):
        arguments = [PROGRAM, "studio", *([file] if file else []), "--no-open", "--json", *options]
        self.process = subprocess.Popen([str(word) for word in arguments], cwd=cwd, text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        preexec_fn=listens_to_interrupts)
        document = ""
        while not document.rstrip().endswith("}"):
            line = self.process.stdout.readline()
            if not line:
                raise AssertionError(self.process.stderr.read())
            document += line
        self.address = json.loads(document)["address"]
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})", self.address)
        self.port, self.token = int(found[1]), found[2]

    def ask(self, path, body=None, method=None, timeout=60, raw=None, **headers):
        """Status, headers and text of an answer; `headers` by names with _ for -; None: not sent."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        sent = {"X-Cognate-Token": self.token}
        data = raw if raw is not None else None if body is None else json.dumps(body).encode()
        if data is not None:
            sent["Content-Type"] = "application/json"
        sent.update({name.replace("_", "-"): value for name, value in headers.items()})
        try:
            connection.request(method or ("GET" if data is None else "POST"), path, data,
                               {name: value for name, value in sent.items() if value is not None})
            answer = connection.getresponse()
            return answer.status, answer.headers, answer.read().decode()
        finally:
            connection.close()

    def status(self, *arguments, **options):
        return self.ask(*arguments, **options)[0]

    def document(self, *arguments, **options):
        return json.loads(self.ask(*arguments, **options)[2])

    def wait_until(self, holds, seconds=60):
        """The first state for which `holds`, by waiting for changes as the page does."""
        state = self.document("/state")
        ends = time.monotonic() + seconds
        while not holds(state):
            if time.monotonic() > ends:
                raise AssertionError(state)
            state = self.document(f"/state?after={state['change']}")
        return state

    def end(self, number=signal.SIGINT):
        self.process.send_signal(number)
        try:
            self.process.wait(timeout=20)
        finally:
            self.process.kill()
        self.process.stdout.close()
        self.errors = self.process.stderr.read()
        self.process.stderr.close()
        return self.process.returncode


class Studios(unittest.TestCase):
    """Tests with a studio each, and a folder for its file."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def serve(self, text=SHORT, *options):
        self.file = self.folder / "problem.toml"
        self.file.write_text(text)
        return self.started(Studio(self.file, *options))

    def started(self, studio):
        self.addCleanup(lambda: studio.process.poll() is None and studio.end())
        return studio

    def ends_well(self, studio):
        self.assertEqual(studio.status("/state"), 200)
        self.assertEqual(studio.end(), 0, studio.errors)
        self.assertEqual(studio.errors, "")
