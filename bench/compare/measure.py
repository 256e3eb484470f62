"""Runs a command and measures what it takes: CPU seconds, wall seconds, peak memory, and when its solutions came."""
import functools
import os
import resource
import signal
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass, field
from statistics import median

MEMORY_LIMIT = 8 << 30


@dataclass
class Child:
    lines: list = field(default_factory=list)
    errors: str = ""
    status: int = 0
    cpu: float = 0.0           # user and system seconds of the process and its children
    wall: float = 0.0
    memory: int = 0            # bytes, at the peak
    stamps: dict = field(default_factory=dict)   # CPU seconds when the nth solution had come
    out_of_time: bool = False


def run(command, limit, *arguments, **options):
    """As run_measured, without the CPU seconds that starting any command here takes."""
    child = run_measured(command, limit, *arguments, **options)
    child.cpu = max(child.cpu - launching_cpu(), 0.0)
    return child


@functools.cache
def launching_cpu():
    """What a command that does nothing takes more when it is started here than when it is started by itself: some
    milliseconds of this Python and of time."""
    def alone():
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(["true"])
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    here = median(run_measured(["true"], 20).cpu for _ in range(21))
    return max(here - median(alone() for _ in range(21)), 0.0)


def run_measured(command, limit, wanted=None, ends_solution=lambda line: True, stamp_at=(), environment=None, ends_itself=False):
    """Runs until the command ends, `wanted` solutions have come (unless it ends itself then, with more to say) or the
    limit of CPU seconds is reached."""
    child = Child()
    with tempfile.NamedTemporaryFile("r") as memory_file, tempfile.TemporaryFile("w+") as errors:
        start = time.monotonic()
        # Linux counts the memory of a Python that starts a process as the peak of that process. GNU time is small.
        process = subprocess.Popen(["time", "--quiet", "-o", memory_file.name, "-f", "%M", *command],
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors, text=True,
                                   start_new_session=True, preexec_fn=lambda: set_limits(limit),
                                   env={**os.environ, **(environment or {})})
        # A machine that is busy with other work may be slow, but not without end.
        watch = threading.Timer(5 * limit + 20, lambda: os.killpg(process.pid, signal.SIGKILL))
        watch.start()
        read_solutions(process, child, wanted, ends_solution, set(stamp_at), ends_itself)
        _, status, usage = os.wait4(process.pid, 0)
        watch.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        child.wall = time.monotonic() - start
        child.status = process.returncode
        child.cpu = usage.ru_utime + usage.ru_stime
        child.memory = int((memory_file.read().split() or ["0"])[-1]) * 1024
        errors.seek(0)
        child.errors = errors.read()
        child.out_of_time = child.cpu >= limit - 0.05 or child.wall >= 5 * limit + 20
    return child


def set_limits(limit):
    seconds = int(limit + 0.999)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def read_solutions(process, child, wanted, ends_solution, stamp_at, ends_itself):
    count = 0
    for line in process.stdout:
        child.lines.append(line)
        if not ends_solution(line):
            continue
        count += 1
        if count in stamp_at or count == 1 or count == wanted:
            child.stamps[count] = cpu_seconds(only_child(process.pid))
        if count == wanted and not ends_itself:
            end(only_child(process.pid))
            break
    process.stdout.close()


def only_child(pid):
    try:
        with open(f"/proc/{pid}/task/{pid}/children") as children:
            return int(children.read().split()[0])
    except (OSError, IndexError):
        return None


def cpu_seconds(pid):
    """Of a running process, all its threads included; None if it has ended."""
    if pid is None:
        return None
    clock = (~pid << 3) | 2   # the clock that clock_getcpuclockid(3) names for the process
    try:
        return time.clock_gettime(clock)
    except OSError:
        return None


def end(pid):
    if pid is None:
        return
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
