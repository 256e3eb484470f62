"""Room for programs that recurse deeply: the interpreter recurses with them."""

import sys
import threading


def run_with_deep_stack(function):
    """Runs the function in a thread with a large stack, and ends the process with the status that it gives."""
    status = []

    def run():
        try:
            status.append(function())
        except SystemExit as error:
            status.append(error.code)

    sys.setrecursionlimit(1_000_000)
    threading.stack_size(512 * 1024 * 1024)
    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    sys.exit(status[0] if status else 1)
