"""The display that VTK draws into: an Xvfb of our own, of which nothing is seen. It starts while the files are read."""
import atexit
import os
import subprocess
from functools import cache

from plotting.inputs import InputError


class Display:
    """Ends with the program."""

    def __init__(self):
        self.answer, put = os.pipe()
        try:
            self.server = subprocess.Popen(["Xvfb", "-displayfd", str(put), "-screen", "0", "64x64x24", "-nolisten", "tcp", "-noreset"],
                                           pass_fds=[put], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except OSError:
            raise InputError("Xvfb cannot be started; the Debian package xvfb is needed for pictures in space") from None
        finally:
            os.close(put)
        atexit.register(self.server.terminate)

    def wait(self):
        """Until it is there, as DISPLAY."""
        if self.answer is None:
            return
        with os.fdopen(self.answer) as answer:
            number = answer.readline().strip()
        self.answer = None
        if not number:
            raise InputError("Xvfb does not start")
        os.environ["DISPLAY"] = ":" + number


@cache
def start_display():
    return Display()
