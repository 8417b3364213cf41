"""Settings of all tests."""

import signal

import pytest


@pytest.fixture(autouse=True)
def interruptions_are_heard():
    """A program that a shell started in the background ignores Ctrl-C; the tests send it on purpose."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
