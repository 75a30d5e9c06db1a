"""The server of `cognate studio` from outside: what it does, and what it refuses.

Run as: studio_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import http.client
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
LIBRARY = pathlib.Path()

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


class StudioTest(unittest.TestCase):
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

    # What it does

    def test_a_text_is_checked_as_the_program_checks_a_file(self):
        studio = self.serve()
        for text in (SHORT, "kind = \"cam\"\nfoot = 1\n", "", "kind = ", "\0", "kind = \"cam\"\n\x07",
                     (LIBRARY / "path" / "ten-point-ellipse.toml").read_text()):
            with self.subTest(text[:30]):
                told = studio.document("/check", {"text": text})
                self.file.write_text(text)
                ran = subprocess.run([PROGRAM, "check", "--json", self.file], capture_output=True,
                                     text=True)
                expected = json.loads(ran.stdout)
                self.assertEqual(told["valid"], ran.returncode == 0)
                self.assertEqual(told["faults"], expected["faults"])
        self.ends_well(studio)

    def test_every_kind_is_solved_and_shown(self):
        studio = self.serve()
        names = [each for each in json.loads(re.search(
            r'id="data">(.*?)</script>', studio.ask("/")[2])[1])["templates"]]
        kinds = [each["name"] for each in names if each["name"].startswith("new/")]
        self.assertEqual(len(kinds), 11)
        self.assertGreater(len(names), 60)
        for name in kinds:
            with self.subTest(name):
                text = studio.document(f"/template?name={name}")["text"]
                run = studio.document("/solve", {"text": text})["run"]
                state = studio.wait_until(lambda state: state["phase"] != "solving")
                self.assertEqual((state["run"], state["phase"]), (run, "done"), state)
                self.assertIn(state["status"], ("solved", "done"))
                self.assertEqual(state["report"], run)
                page = studio.ask("/report")[2]
                title = re.search(r'^title = "(.*?)"', text, re.M)
                self.assertIn(title[1] if title else "cognate-result/1", page)
        self.ends_well(studio)

    def test_the_result_is_that_of_solve(self):
        text = (LIBRARY / "path" / "ten-point-ellipse.toml").read_text()
        studio = self.serve(text, "--seed", "7", "--threads", "1")
        studio.document("/solve", {"text": text})
        studio.wait_until(lambda state: state["phase"] == "done")
        page = studio.ask("/report")[2]
        shown = json.loads(re.search(r'id="data">(.*?)</script>', page)[1])["result"]
        ran = subprocess.run([PROGRAM, "solve", "--json", "--seed", "7", self.file],
                             capture_output=True, text=True)
        expected = json.loads(ran.stdout)
        for document in (shown, expected):
            for name in ("seconds", "threads"):
                document["work"].pop(name)
        self.assertEqual(shown["seed"], 7)
        self.assertEqual(shown, expected)

    def test_a_fault_begins_nothing(self):
        studio = self.serve()
        status, _, text = studio.ask("/solve", {"text": "kind = \"cam\"\n"})
        self.assertEqual(status, 200)
        self.assertIn("follower.type is missing", text)
        self.assertNotIn("run", json.loads(text))
        status, _, text = studio.ask("/solve", {"text": 'kind = "study"\nbase = "problem.toml"\n'})
        self.assertEqual(status, 200)
        self.assertIn("cognate sweep", text)
        self.assertEqual(studio.document("/state")["phase"], "idle")
        self.assertEqual(studio.status("/report"), 404)

    def test_a_stopped_run_reports_what_it_found(self):
        studio = self.serve(ENDLESS)
        studio.document("/solve", {"text": ENDLESS})
        state = studio.wait_until(lambda state: state["best"] is not None)
        self.assertEqual(state["phase"], "solving")
        begun = time.monotonic()
        self.assertEqual(studio.status("/stop", {}), 200)
        state = studio.wait_until(lambda state: state["phase"] != "solving")
        self.assertLess(time.monotonic() - begun, 15)
        self.assertEqual((state["phase"], state["status"]), ("done", "interrupted"))
        self.assertIn("cognate-result/1", studio.ask("/report")[2])
        self.assertEqual(studio.status("/stop", {}), 200)  # of nothing
        self.ends_well(studio)

    def test_the_newest_request_ends_the_one_before(self):
        studio = self.serve(ENDLESS)
        for _ in range(4):
            studio.document("/solve", {"text": ENDLESS})
        last = studio.document("/solve", {"text": SHORT})["run"]
        self.assertEqual(last, 5)
        state = studio.wait_until(lambda state: state["phase"] != "solving")
        self.assertEqual((state["run"], state["phase"], state["report"]), (5, "done", 5))
        self.ends_well(studio)

    def test_a_time_limit_ends_a_run(self):
        studio = self.serve(ENDLESS, "--time-limit", "0.5")
        studio.document("/solve", {"text": ENDLESS})
        state = studio.wait_until(lambda state: state["phase"] == "done")
        self.assertEqual(state["status"], "time-limit")

    # The file

    def test_a_text_is_saved_as_it_stands(self):
        studio = self.serve()
        self.file.chmod(0o600)
        text = SHORT + "# Zähne – 齿数\r\n\t# end without a line's end"
        saved = studio.document("/save", {"text": text, "version": 1})
        self.assertEqual(saved, {"version": 2})
        self.assertEqual(self.file.read_bytes(), text.encode())
        self.assertEqual(self.file.stat().st_mode & 0o777, 0o600)
        self.assertEqual(os.listdir(self.folder), ["problem.toml"])
        self.assertEqual(studio.status("/save", {"text": "", "version": 1}), 409)
        self.assertEqual(self.file.read_bytes(), text.encode())

    def test_a_link_stays_one(self):
        real = self.folder / "real.toml"
        real.write_text(SHORT)
        link = self.folder / "link.toml"
        link.symlink_to("real.toml")
        studio = self.started(Studio(link))
        self.assertEqual(studio.status("/save", {"text": "a", "version": 1}), 200)
        self.assertTrue(link.is_symlink())
        self.assertEqual(real.read_text(), "a")

    def test_what_others_save_is_seen_and_not_overwritten(self):
        studio = self.serve()
        new = self.folder / "new"
        new.write_text(SHORT + "# by rename\n")
        new.rename(self.file)
        state = studio.wait_until(lambda state: state["file_version"] == 2, 10)
        self.assertEqual(studio.document("/file"), {"version": 2, "text": SHORT + "# by rename\n"})
        # Saved before anybody looked.
        self.file.write_text(SHORT + "# in place\n")
        self.assertEqual(studio.status("/save", {"text": "mine", "version": 2}), 409)
        self.assertEqual(self.file.read_text(), SHORT + "# in place\n")
        self.assertEqual(studio.document("/file")["version"], 3)
        # What cannot be edited leaves the version.
        self.file.write_bytes(b"\xff\xfe")
        time.sleep(0.5)
        self.assertEqual(studio.document("/file")["version"], 3)
        self.file.unlink()
        self.assertEqual(studio.status("/save", {"text": "again", "version": 3}), 200)
        self.assertEqual(self.file.read_text(), "again")

    def test_without_a_file_nothing_on_the_disk_is_touched(self):
        studio = self.started(Studio(cwd=self.folder))
        self.assertEqual(studio.status("/file"), 404)
        self.assertEqual(studio.status("/save", {"text": "a", "version": 0}), 404)
        (self.folder / "drawing.svg").write_text("<svg/>")
        (self.folder / "base.toml").write_text(SHORT)
        for text in ('kind = "path-generation"\n[target]\nsvg = "drawing.svg"\n',
                     'kind = "study"\nbase = "base.toml"\n'):
            faults = studio.document("/check", {"text": text})["faults"]
            self.assertIn("there is none", faults[0]["message"])
        self.assertEqual(sorted(os.listdir(self.folder)), ["base.toml", "drawing.svg"])

    def test_what_cannot_be_edited_is_refused(self):
        for name, content in (("binary.toml", b"\0\1\2"), ("latin.toml", b"# \xe9\n"),
                              ("large.toml", b"# x\n" * 200000)):
            (self.folder / name).write_bytes(content)
        for file in ("missing.toml", ".", "binary.toml", "latin.toml", "large.toml", "/dev/zero"):
            with self.subTest(file):
                ran = subprocess.run([PROGRAM, "studio", file, "--no-open"], cwd=self.folder,
                                     capture_output=True, text=True, timeout=20)
                self.assertEqual((ran.returncode, ran.stdout), (2, ""))
                self.assertIn("cannot edit", ran.stderr)

    def test_ports(self):
        taken = self.serve()
        for port in ("0", "-1", "65536", "x", str(taken.port)):
            with self.subTest(port):
                ran = subprocess.run([PROGRAM, "studio", "--no-open", "--port", port],
                                     capture_output=True, text=True, timeout=20)
                self.assertEqual((ran.returncode, ran.stdout), (2, ""))
        taken.end()
        again = self.started(Studio(None, "--port", str(taken.port)))
        self.assertEqual(again.port, taken.port)
        self.assertNotEqual(again.token, taken.token)

    # What it refuses

    def test_only_who_knows_the_token_gets_an_answer(self):
        studio = self.serve()
        wrong = "0" * 32
        for path in ("/", "/state", "/report", "/sketch", "/file", "/template?name=new/cam", "/open",
                     "/open?invitation=", "/open?invitation=" + wrong):
            for token in (None, "", wrong, studio.token[:-1], studio.token + "0"):
                with self.subTest(path=path, token=token):
                    status, _, text = studio.ask(path, X_Cognate_Token=token)
                    self.assertEqual(status, 403)
                    self.assertNotIn(studio.token, text)
        for path in ("/check", "/solve", "/stop", "/save"):
            self.assertEqual(studio.status(path, {"text": "a", "version": 1}, X_Cognate_Token=None),
                             403)
        self.assertEqual(self.file.read_text(), SHORT)
        self.assertEqual(studio.status("/state?token=" + studio.token, X_Cognate_Token=None), 200)
        self.ends_well(studio)

    def test_only_pages_of_its_own_get_an_answer(self):
        studio = self.serve()
        own = f"127.0.0.1:{studio.port}"
        for host in ("evil.example", "127.0.0.1", f"evil.example:{studio.port}", "", own + ".evil",
                     f"127.0.0.1:{studio.port + 1}", f"[::1]:{studio.port}"):
            self.assertEqual(studio.status("/state", Host=host), 403, host)
        for host in (own, f"localhost:{studio.port}"):
            self.assertEqual(studio.status("/state", Host=host), 200)
        for origin in ("http://evil.example", "null", "https://" + own, "http://127.0.0.1",
                       f"http://127.0.0.1:{studio.port + 1}"):
            self.assertEqual(studio.status("/check", {"text": ""}, Origin=origin), 403, origin)
        self.assertEqual(studio.status("/check", {"text": ""}, Origin="http://" + own), 200)
        status, headers, _ = studio.ask("/check", method="OPTIONS", X_Cognate_Token=None,
                                        Origin="http://evil.example",
                                        Access_Control_Request_Method="POST")
        self.assertEqual(status, 403)
        self.assertNotIn("access-control", str(headers).lower())
        self.ends_well(studio)

    def test_other_addresses_of_this_machine_are_not_listened_at(self):
        studio = self.serve()
        addresses = {entry[4][0] for entry in socket.getaddrinfo(socket.gethostname(), None)}
        for address in ["::1", "127.0.0.2", *addresses - {"127.0.0.1"}]:
            with self.subTest(address), self.assertRaises(OSError):
                socket.create_connection((address, studio.port), 2).close()
        self.ends_well(studio)

    def test_every_answer_says_for_whom_it_is(self):
        studio = self.serve()
        studio.document("/solve", {"text": SHORT})
        studio.wait_until(lambda state: state["phase"] == "done")
        for path in ("/", "/report", "/sketch", "/state", "/none"):
            headers = studio.ask(path)[1]
            self.assertEqual(headers["Cache-Control"], "no-store")
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertEqual(headers["Referrer-Policy"], "no-referrer")
            if headers["Content-Type"].startswith("text/html"):
                policy = headers["Content-Security-Policy"]
                nonce = re.search(r"script-src 'nonce-([0-9a-f]{32})'", policy)[1]
                page = studio.ask(path)[2]
                self.assertIn("default-src 'none'", policy)
                self.assertNotIn(nonce, page)  # each answer has its own
                self.assertNotRegex(page, r"<script>")
        self.ends_well(studio)

    def test_no_file_of_the_disk_is_served(self):
        studio = self.serve()
        (self.folder / "secret").write_text("SECRET")
        for path in ("/../secret", "/..%2fsecret", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd",
                     "/etc/passwd", "/problem.toml", "/file/../../secret", "/report/../secret",
                     "/template?name=../secret", "/template?name=/etc/passwd", "/template",
                     "/template?name=new/", "/template?name=new/study", "/" + "a" * 5000,
                     "/%00", "/state%00"):
            with self.subTest(path[:40]):
                status, _, text = studio.ask(path)
                self.assertEqual(status, 404)
                self.assertNotIn("SECRET", text)
        self.ends_well(studio)

    def test_bad_bodies(self):
        studio = self.serve()
        for raw in (b"", b"{", b"[]", b"null", b'"text"', b'{"text": 1}', b'{"text": "a"', b"{}",
                    b"\xff\xfe\x00", b'{"text": "\xff"}', b'{"text": "\\ud800"}', b"[" * 100000,
                    os.urandom(1000)):
            for path in ("/check", "/solve", "/save"):
                self.assertEqual(studio.status(path, raw=raw), 400, (path, raw[:20]))
        for version in (None, "1", -1, 1.5, [1]):
            self.assertEqual(studio.status("/save", {"text": "a", "version": version}), 400)
        self.assertEqual(studio.status("/check", raw=b"text=a", Content_Type="text/plain"), 415)
        self.assertEqual(studio.status("/check", {"text": ""}, Content_Encoding="gzip"), 411)
        self.assertEqual(studio.status("/state", Range="bytes=0-1,0-1"), 400)
        for method in ("PUT", "DELETE", "PATCH", "HEAD", "OPTIONS"):
            self.assertEqual(studio.status("/state", method=method), 405, method)
        self.assertEqual(studio.status("/state", method="BREW"), 400)
        self.assertEqual(studio.status("/nothing", {"text": "a"}), 404)
        self.assertEqual(self.file.read_text(), SHORT)
        self.ends_well(studio)

    def test_a_body_that_is_too_large_is_not_read(self):
        studio = self.serve()
        self.assertEqual(studio.status("/check", {"text": "x" * (1 << 20)}), 413)
        self.assertEqual(studio.status("/check", {"text": "#" * 1000000}), 200)
        for length in ("99999999999", "-1", "1e3", "99999999999999999999999", "0x10"):
            answer = self.talk(studio, "POST /check", f"Content-Length: {length}")
            self.assertRegex(answer, r"^HTTP/1.1 41[13] ", length)
        answer = self.talk(studio, "POST /check", "Transfer-Encoding: chunked",
                           body=b"100000\r\n" + b"x" * 0x100000)
        self.assertRegex(answer, "^HTTP/1.1 411 ")
        self.ends_well(studio)

    def talk(self, studio, begin, *headers, body=b""):
        with socket.create_connection(("127.0.0.1", studio.port), 20) as connection:
            lines = [f"{begin} HTTP/1.1", f"Host: 127.0.0.1:{studio.port}",
                     f"X-Cognate-Token: {studio.token}", "Content-Type: application/json", *headers]
            connection.sendall("\r\n".join([*lines, "", ""]).encode() + body)
            answer = b""
            while part := connection.recv(65536):
                answer += part
            return answer.decode()

    def test_what_is_no_request(self):
        studio = self.serve()
        for text in (b"\r\n\r\n", b"GET\r\n\r\n", os.urandom(5000), b"GET / HTTP/9.9\r\n\r\n",
                     b"A" * 100000, b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n",
                     b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 100000,
                     b"GET / HTTP/1.1\r\nX: " + b"y" * 100000 + b"\r\n\r\n"):
            with self.subTest(text[:20]):
                with socket.create_connection(("127.0.0.1", studio.port), 30) as connection:
                    try:
                        connection.sendall(text)
                        connection.shutdown(socket.SHUT_WR)
                        answer = connection.recv(100)
                    except OSError:
                        answer = b""
                    self.assertRegex(answer, rb"^(HTTP/1.1 4\d\d |$)")
        self.ends_well(studio)

    def test_connections_that_send_nothing_hinder_nobody(self):
        studio = self.serve()
        silent = [socket.create_connection(("127.0.0.1", studio.port), 10) for _ in range(150)]
        for connection in silent[::2]:
            connection.sendall(b"POST /solve HTTP/1.1\r\nHost: ")
        begun = time.monotonic()
        for _ in range(20):
            self.assertEqual(studio.status("/state", timeout=5), 200)
        self.assertLess(time.monotonic() - begun, 5)
        # Each is cut off in a while, also one that sends little by little.
        self.assertTrue(self.is_cut_off(silent[0], begun + 25))
        # Not even so many that the rest has to wait.
        more = [socket.create_connection(("127.0.0.1", studio.port), 10) for _ in range(100)]
        self.assertEqual(studio.status("/state", timeout=30), 200)
        begun = time.monotonic()
        self.assertEqual(studio.end(), 0)
        self.assertLess(time.monotonic() - begun, 5)
        for connection in silent + more:
            connection.close()

    def is_cut_off(self, connection, ends):
        """Whether the server ends a connection on which a byte comes now and then."""
        connection.settimeout(0.5)
        while time.monotonic() < ends:
            try:
                connection.sendall(b"x")
                connection.recv(100)
                return True
            except TimeoutError:
                continue
            except OSError:
                return True
        return False

    def test_an_interrupt_ends_it_while_it_solves(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            studio = self.serve(ENDLESS)
            studio.document("/solve", {"text": ENDLESS})
            studio.wait_until(lambda state: state["best"] is not None)
            begun = time.monotonic()
            self.assertEqual(studio.end(number), 0, studio.errors)
            self.assertLess(time.monotonic() - begun, 10)
            with self.assertRaises(OSError):
                studio.status("/state")


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
