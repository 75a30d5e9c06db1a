"""The server of `cognate studio` from outside: whom and what it refuses.

Run as: studio_access_test.py PROGRAM, the built program.
"""

import os
import re
import socket
import sys
import time
import unittest

from studios import SHORT, Studios
from thinned import whole_only


class StudioAccess(Studios):
    def test_only_who_knows_the_token_gets_an_answer(self):
        studio = self.serve()
        wrong = "0" * 32
        for path in ("/", "/state", "/report", "/sketch", "/mechanism", "/file", "/template?name=new/cam", "/open",
                     "/open?invitation=", "/open?invitation=" + wrong):
            for token in (None, "", wrong, studio.token[:-1], studio.token + "0"):
                with self.subTest(path=path, token=token):
                    status, _, text = studio.ask(path, X_Cognate_Token=token)
                    self.assertEqual(status, 403)
                    self.assertNotIn(studio.token, text)
        for path in ("/check", "/solve", "/stop", "/save", "/export"):
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
        for raw, words in ((b'{"text": 1e999}', "a number in the body is greater than any of double precision"),
                           (b'{"a": [-1e400]}', "expected one below 1.8e308"),
                           (b"[]", "JSON of the type array; expected an object"),
                           (b'{"text": }', "no JSON at its byte 10; expected a JSON object")):
            self.assertIn(words, studio.document("/check", raw=raw)["error"], raw)
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

    def silent(self, studio, count):
        """Connections on which nothing comes, or the begin of a request alone."""
        silent = [socket.create_connection(("127.0.0.1", studio.port), 10) for _ in range(count)]
        for connection in silent[::2]:
            connection.sendall(b"POST /solve HTTP/1.1\r\nHost: ")
        return silent

    def answers_at_once(self, studio):
        begun = time.monotonic()
        for _ in range(20):
            self.assertEqual(studio.status("/state", timeout=5), 200)
        self.assertLess(time.monotonic() - begun, 5)

    def test_connections_that_send_nothing_hinder_nobody(self):
        studio = self.serve()
        silent = self.silent(studio, 20)
        begun = time.monotonic()
        self.answers_at_once(studio)
        self.assertEqual(studio.end(), 0)
        self.assertLess(time.monotonic() - begun, 10)
        for connection in silent:
            connection.close()

    @whole_only
    def test_connections_that_send_nothing_are_cut_off(self):
        studio = self.serve()
        silent = self.silent(studio, 150)
        begun = time.monotonic()
        self.answers_at_once(studio)
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


if __name__ == "__main__":
    del sys.argv[1:2]
    unittest.main()
