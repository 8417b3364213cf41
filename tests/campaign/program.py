"""Calls of the program under test, and what became of each."""
import json, os, subprocess


class Answer:
    """The result of one call: `json`, or a refusal with its reason, or a panic, or a time-out."""
    def __init__(self, status, out, err, expired):
        self.status, self.out, self.err, self.expired = status, out, err, expired
        self.panicked = "panicked at" in err or status < 0 or status == 101
        try:
            self.json = json.loads(out) if out.strip() else None
        except ValueError:
            self.json = None

    @property
    def reason(self):
        """The first line of the message."""
        if isinstance(self.json, dict) and self.json.get("error"):
            error = self.json["error"]
            return str(error.get("message", error) if isinstance(error, dict) else error)
        if isinstance(self.json, dict) and self.json.get("errors"):
            first = self.json["errors"][0]
            return str(first.get("message", first) if isinstance(first, dict) else first)
        return next((line for line in self.err.splitlines() if line.strip()), f"status {self.status}")


class Program:
    """The program under test."""
    def __init__(self, path, seconds=60.0):
        self.path, self.seconds, self.calls = os.path.abspath(path), seconds, 0

    def __call__(self, *arguments):
        self.calls += 1
        try:
            done = subprocess.run([self.path, *map(str, arguments)], capture_output=True, text=True,
                                  timeout=self.seconds, stdin=subprocess.DEVNULL)
            return Answer(done.returncode, done.stdout, done.stderr, False)
        except subprocess.TimeoutExpired:
            return Answer(1, "", "", True)
