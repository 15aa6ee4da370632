"""Ctrl-C ends a run in order; what is done then is not lost."""

import signal
import subprocess
import time
import unittest

import program

JOURNAL = "journal.ndjson"


class Interrupt(program.SetTest):
    def setUp(self):
        super().setUp()
        self.pack(24, 2000)

    def interrupt(self, *arguments, sent=signal.SIGINT, n_bytes=0):
        """What a run has said that got a signal once its journal was larger than so many bytes."""
        for _ in range(5):
            (self.folder / JOURNAL).unlink(missing_ok=True)
            process = self.start(f"--ndjson={JOURNAL}", *arguments, "packed", stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE)
            self.wait_for_journal(process, n_bytes)
            process.send_signal(sent)
            out, err = process.communicate(timeout=60)
            if process.returncode != program.DONE:  # else it was done before we came to it
                break
        self.assertEqual(process.returncode, program.INTERRUPTED, err.decode())
        return program.Said(out, err)

    def wait_for_journal(self, process, n_bytes):
        journal = self.folder / JOURNAL
        while process.poll() is None and not (journal.exists() and journal.stat().st_size > n_bytes):
            time.sleep(0.0005)

    def n_meshes(self):
        return sum(line["kind"] == "mesh" for line in self.lines(JOURNAL))

    def test_journal_is_whole_and_the_message_names_the_way_on(self):
        said = self.interrupt()
        self.assertEqual(said.errors, f"meshalyzer: interrupted: {self.n_meshes()} of 24 files are done; "
                                      f"--resume {JOURNAL} goes on with it\n")
        self.assertNotIn(b"MESH SET", said.out)
        self.assertLess(len(self.lines(JOURNAL)), 2 * 24, "it went on to the end")

    def test_between_the_meshes(self):
        self.interrupt("--threads", "1", n_bytes=60_000)
        self.assertGreater(len(self.lines(JOURNAL)), 2)

    def test_resumed_it_comes_to_the_same_report(self):
        whole = self.run_program("--summary", "packed").out
        self.interrupt("--summary")
        self.assert_same(self.run_program("--summary", "--resume", JOURNAL, "packed").out, whole, "report")

    def test_report_in_a_file_stays_as_it_was(self):
        self.write("report.json", "of yesterday")
        self.interrupt("--json=report.json")
        self.assertEqual(self.read("report.json"), b"of yesterday")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), [JOURNAL, "packed", "report.json"])

    def test_polite_kill_is_the_same(self):
        self.assertIn("interrupted", self.interrupt(sent=signal.SIGTERM).errors)

    def test_without_a_journal_there_is_no_way_on(self):
        process = self.start("--ndjson", "packed", stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0)
        first = process.stdout.readline()
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, program.INTERRUPTED)
        self.assertRegex(err.decode(), r"^meshalyzer: interrupted: \d+ of 24 files are done\n$")
        self.write(JOURNAL, (first + out).decode())
        self.assertEqual(self.lines(JOURNAL)[0]["number"], 0)


if __name__ == "__main__":
    unittest.main()
