import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import CancelledError, wait
from pathlib import Path

import pytest

from iconstudio.limits import time_limit
from iconstudio.model import IconstudioError
from iconstudio.tasks import REMEMBERED, forget, remembered, stopped
from iconstudio.workers import ProcessDied, Workers, answer

posix = pytest.mark.skipif(os.name != "posix", reason="needs POSIX signals")
linux = pytest.mark.skipif(not Path("/proc/self").exists(), reason="looks processes up in /proc")


def add(a, b):
    return a + b


def pid():
    return os.getpid()


def fail(message):
    raise ValueError(message)


def vanish(code):
    os._exit(code)


def sleep_after_telling(path):
    """Write down the process's number, then sleep."""
    Path(path).write_text(str(os.getpid()))
    time.sleep(600)


def hang_after_telling(path):
    """Write down the process's number, then hang in C with the interpreter lock held."""
    Path(path).write_text(str(os.getpid()))
    sum(range(10**13))


def swallow(data):
    return len(data)


def surroundings():
    return (
        os.nice(0),
        os.environ.get("OMP_NUM_THREADS"),
        os.environ.get("OPENBLAS_NUM_THREADS"),
        signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, ()),
    )


def allocate(size):
    return len(bytearray(size))


def told(path):
    """Return the process's number once it is written down."""
    deadline = time.monotonic() + 30
    while not (path.exists() and path.read_text()):
        assert time.monotonic() < deadline
        time.sleep(0.02)
    return int(path.read_text())


def alive(number):
    try:
        return Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def ends(number, seconds):
    deadline = time.monotonic() + seconds
    while alive(number):
        if time.monotonic() > deadline:
            return False
        time.sleep(0.02)
    return True


@pytest.fixture(scope="module")
def workers():
    with Workers(1) as pool:
        yield pool


def test_a_task_runs_in_another_process(workers):
    assert workers.submit(add, 2, 3).result() == 5
    assert workers.submit(pid).result() != os.getpid()


def note(folder):
    (Path(folder) / str(os.getpid())).touch()


def test_every_process_has_done_what_is_asked_of_all_before_what_comes_later(tmp_path):
    with Workers(2) as both:
        both.everywhere(note, str(tmp_path))
        processes = [both.submit(pid, lane=lane).result(60) for lane in (0, 1)]
        assert {one.name for one in tmp_path.iterdir()} == {str(one) for one in processes}


def test_an_error_of_the_task_is_raised(workers):
    with pytest.raises(ValueError, match="no good"):
        workers.submit(fail, "no good").result()


def test_a_task_that_cannot_be_pickled_is_an_error_of_its_own(workers):
    with pytest.raises((AttributeError, TypeError, ValueError)):
        workers.submit(lambda: 1).result()
    assert workers.submit(add, 1, 1).result() == 2


def test_a_crash_loses_the_task_and_no_other(workers):
    futures = [workers.submit(vanish, 3), workers.submit(add, 1, 2)]
    assert isinstance(futures[0].exception(), ProcessDied)
    assert futures[0].exception().exitcode == 3
    assert futures[1].result() == 3


@linux
@pytest.mark.parametrize("task", [sleep_after_telling, hang_after_telling])
def test_cancelling_kills_what_runs(workers, tmp_path, task):
    future = workers.submit(task, str(tmp_path / "pid"))
    number = told(tmp_path / "pid")
    assert future.cancel()
    assert wait([future], 5).done
    assert ends(number, 2)
    assert workers.submit(add, 1, 1).result() == 2


@pytest.mark.parametrize("work", [(time.sleep, 600), (sum, range(10**13))])
def test_time_runs_out(workers, work):
    future = workers.submit(*work, timeout=0.1)
    with pytest.raises(TimeoutError):
        future.result()
    assert workers.submit(add, 1, 1).result() == 2


@posix
def test_time_in_which_the_machine_does_other_things_does_not_count(workers):
    assert workers.submit(time.sleep, 0.3, timeout=0.1).result() is None


@posix
def test_workers_give_way_and_ignore_interrupts(workers):
    nice, *threads, blocked = workers.submit(surroundings).result()
    assert nice >= min(19, os.nice(0) + 5)
    assert all(threads)
    assert blocked
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())


@linux
def test_memory_can_be_limited(workers):
    with pytest.raises(MemoryError):
        workers.submit(allocate, 2**30, memory=2**29).result()
    assert workers.submit(allocate, 2**20, memory=2**29).result() == 2**20
    assert workers.submit(allocate, 2**30).result() == 2**30
    assert workers.submit(swallow, b"x").result() == 1


@linux
def test_closing_from_another_thread_wakes_who_waits_and_leaves_no_process(tmp_path):
    workers = Workers(2)
    futures = [workers.submit(hang_after_telling, str(tmp_path / name)) for name in "ab"]
    futures += [workers.submit(add, 1, 1) for _ in range(5)]
    numbers = [told(tmp_path / name) for name in "ab"]
    woken = []

    def wait_for_all():
        wait(futures)
        for future in futures:
            with pytest.raises(CancelledError):
                future.result()
            woken.append(future)

    threads = set(threading.enumerate())
    waiting = threading.Thread(target=wait_for_all)
    waiting.start()
    workers.close()
    waiting.join(10)
    assert woken == futures
    assert not any(map(alive, numbers))
    assert set(threading.enumerate()) <= threads
    workers.close()
    with pytest.raises(CancelledError, match="closed"):
        workers.submit(add, 1, 1)


@linux
def test_closing_while_tasks_stand_in_the_pipe(tmp_path):
    workers = Workers(1)
    workers.submit(sleep_after_telling, str(tmp_path / "pid"))
    told(tmp_path / "pid")
    large = [workers.submit(swallow, bytes(3_000_000)) for _ in range(4)]
    time.sleep(0.3)  # the first of them fills the pipe
    workers.close()
    assert all(future.cancelled() for future in large)


def test_closing_a_pool_that_never_began():
    with Workers() as workers:
        assert workers.count >= 1


@linux
def test_a_pool_whose_idle_worker_is_killed_goes_on():
    with Workers(1) as workers:
        os.kill(workers.submit(pid).result(), signal.SIGKILL)
        time.sleep(0.5)
        assert workers.submit(add, 1, 1).result() == 2


PROGRAM = """
import signal, sys, time
from iconstudio.workers import Workers
from tests.test_workers import add, hang_after_telling, sleep_after_telling

if __name__ == "__main__":
    # Who starts the tests in the background may have had interrupts ignored.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    workers = Workers(2)
    task = {"sleep": sleep_after_telling, "hang": hang_after_telling}[sys.argv[1]]
    seconds = float(sys.argv[2]) or None
    futures = [workers.submit(task, path, timeout=seconds) for path in sys.argv[3:]]
    print("ready", flush=True)
    if sys.argv[1] == "sleep":
        try:
            time.sleep(60)
        except KeyboardInterrupt:
            sys.exit(3)  # without closing
    time.sleep(60)
"""


@pytest.fixture
def program(tmp_path):
    """Return a function that starts a program of its own that uses workers."""
    script = tmp_path / "program.py"
    script.write_text(PROGRAM)
    root = str(Path(__file__).parents[1])
    started = []

    def start(*arguments):
        process = subprocess.Popen(
            [sys.executable, "-W", "error", str(script), *map(str, arguments)],
            env=os.environ | {"PYTHONPATH": root},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
        started.append(process)
        assert process.stdout.readline() == b"ready\n"
        return process

    yield start
    for process in started:
        process.kill()
        process.communicate()


@linux
def test_no_worker_survives_a_killed_program(program, tmp_path):
    files = [tmp_path / "a", tmp_path / "b"]
    process = program("sleep", 0, *files)
    numbers = [told(file) for file in files]
    process.kill()
    assert all(ends(number, 5) for number in numbers)


@linux
def test_a_hung_worker_survives_a_killed_program_no_longer_than_its_time(program, tmp_path):
    process = program("hang", 1, tmp_path / "a")
    number = told(tmp_path / "a")
    process.kill()
    assert ends(number, 6)


@linux
@pytest.mark.parametrize("pause", [0.05, 1.0], ids=["while they start", "at work"])
def test_an_interrupt_on_the_terminal_prints_nothing_and_leaves_nothing(program, tmp_path, pause):
    files = [tmp_path / "a", tmp_path / "b"]
    process = program("sleep", 0, *files)
    time.sleep(pause)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does, to all of them
    assert process.wait(20) == 3
    assert process.stderr.read() == b""
    assert not any(alive(int(file.read_text() or 0)) for file in files if file.exists())


def made_under(key):
    made = []

    def make():
        made.append(key)
        return object()

    remembered(key, make)
    return len(made)


def drop(key):
    forget(key)


def test_a_process_remembers_the_last_few_things(workers):
    lane = workers.idlest()

    def ask(function, key):
        return workers.submit(function, key, lane=lane).result(timeout=20)

    assert ask(made_under, "a") == 1
    assert ask(made_under, "a") == 0
    for key in range(REMEMBERED):
        assert ask(made_under, key) == 1
    assert ask(made_under, "a") == 1
    ask(drop, "a")
    assert ask(made_under, "a") == 1
    assert ask(made_under, REMEMBERED - 1) == 0


def test_a_task_can_name_its_process():
    with Workers(2) as pool:
        first = {pool.submit(os.getpid, lane=0).result(timeout=20) for _ in range(3)}
        second = pool.submit(os.getpid, lane=1).result(timeout=20)
    assert len(first) == 1
    assert second not in first


def work_until_stopped(path):
    """Write down the process's number, then work until nobody wants it."""
    Path(path).write_text(str(os.getpid()))
    while not stopped():
        time.sleep(0.001)
    return os.getpid()


def test_a_ticket_stops_what_runs_and_what_waits_and_the_process_lives_on(tmp_path):
    with Workers(1) as workers:
        ticket = workers.ticket()
        running = workers.submit(work_until_stopped, tmp_path / "a", ticket=ticket)
        waiting = workers.submit(add, 1, 2, ticket=ticket)
        number = told(tmp_path / "a")
        ticket.stop()
        assert running.result(timeout=60) == number
        with pytest.raises(CancelledError):
            waiting.result(timeout=60)
        assert workers.submit(pid, ticket=workers.ticket()).result(timeout=60) == number
        assert workers.submit(pid).result(timeout=60) == number


def test_a_ticket_stops_no_task_of_another(tmp_path):
    with Workers(2) as workers:
        one, other = workers.ticket(), workers.ticket()
        first = workers.submit(work_until_stopped, tmp_path / "a", lane=0, ticket=one)
        second = workers.submit(work_until_stopped, tmp_path / "b", lane=1, ticket=other)
        told(tmp_path / "a")
        told(tmp_path / "b")
        other.stop()
        second.result(timeout=60)
        assert not first.done()
        one.stop()
        first.result(timeout=60)


def test_nobody_is_stopped_outside_a_task():
    assert not stopped()


@posix
def test_a_task_that_does_not_stop_is_killed_when_it_is_in_the_way(tmp_path, monkeypatch):
    monkeypatch.setattr("iconstudio.workers._GRACE", 0.0)
    with Workers(1) as workers:
        ticket = workers.ticket()
        workers.submit(sleep_after_telling, tmp_path / "a", ticket=ticket)
        number = told(tmp_path / "a")
        ticket.stop()
        assert workers.submit(pid).result(timeout=60) != number


def tell_and_sleep(folder, seconds):
    """Leave a file named after the process's number, sleep, and return the number."""
    (folder / str(os.getpid())).touch()
    time.sleep(seconds)
    return os.getpid()


def numbers_in(folder):
    return {int(path.name) for path in folder.iterdir()}


def kill_next(folder, killed):
    """Kill the next process that leaves its number."""
    deadline = time.monotonic() + 30
    while not (new := numbers_in(folder) - killed):
        assert time.monotonic() < deadline
        time.sleep(0.02)
    (number,) = new
    os.kill(number, signal.SIGKILL)
    killed.add(number)


@posix
def test_the_work_of_a_killed_process_is_given_to_another_once(tmp_path):
    with Workers(1) as workers:
        future = workers.submit(tell_and_sleep, tmp_path, 2)
        after = [workers.submit(add, 1, number) for number in range(3)]
        killed = set()
        kill_next(tmp_path, killed)
        assert future.result(timeout=60) in numbers_in(tmp_path) - killed
        assert [one.result(timeout=60) for one in after] == [1, 2, 3]


@posix
def test_a_task_that_loses_two_processes_ends_in_a_sentence(tmp_path):
    with Workers(1) as workers:
        future = workers.submit(tell_and_sleep, tmp_path, 600)
        after = workers.submit(add, 1, 2)
        killed = set()
        kill_next(tmp_path, killed)
        kill_next(tmp_path, killed)
        with pytest.raises(IconstudioError, match=r"^Drawing it was ended twice by the system"):
            answer(future, "Drawing it")
        assert after.result(timeout=60) == 3
        assert len(numbers_in(tmp_path)) == 2


def make_much(path):
    """Make a result that fills the pipe many times over, so that it is killed while it sends."""
    path.write_text(str(os.getpid()))
    return bytes(300_000_000)


@pytest.mark.thorough
@posix
def test_a_process_that_is_killed_while_it_answers_harms_no_other(tmp_path):
    with Workers(1) as workers:
        for number in range(6):
            path = tmp_path / str(number)
            future = workers.submit(make_much, path)
            first = told(path)
            time.sleep(0.03 * number)
            os.kill(first, signal.SIGKILL)
            assert len(future.result(timeout=60)) == 300_000_000
            assert workers.submit(add, 1, 2).result(timeout=60) == 3


@linux
def test_what_was_cancelled_is_not_tried_again(tmp_path):
    with Workers(1) as workers:
        future = workers.submit(tell_and_sleep, tmp_path, 600)
        while not (numbers := numbers_in(tmp_path)):
            time.sleep(0.02)
        assert future.cancel()
        assert workers.submit(add, 1, 1).result(timeout=60) == 2
        assert numbers_in(tmp_path) == numbers
        assert not any(map(alive, numbers))


def work_for(seconds):
    until = time.process_time() + seconds
    while time.process_time() < until:
        pass


def set_a_limit(seconds, work):
    with time_limit(seconds):
        work_for(work)
    work_for(seconds)
    return "in time"


@posix
def test_a_limit_within_a_task(workers):
    assert workers.submit(set_a_limit, 0.2, 0.1).result(timeout=60) == "in time"
    with pytest.raises(TimeoutError):
        workers.submit(set_a_limit, 0.2, 600).result(timeout=60)
    with pytest.raises(TimeoutError):
        workers.submit(set_a_limit, 600, 600, timeout=0.2).result(timeout=60)


@pytest.mark.parametrize(
    ("task", "limits", "words"),
    [
        ((work_for, 600), {"timeout": 0.2}, "Drawing it takes too long."),
        ((allocate, 2**30), {"memory": 2**28}, "Drawing it takes too much memory."),
        ((vanish, 1), {}, "Drawing it crashes the process that does it, or takes too much memory."),
    ],
)
def test_what_a_limit_ends_is_told_in_a_sentence(workers, task, limits, words):
    if "memory" in limits and not sys.platform.startswith("linux"):
        pytest.skip("no other limits address space")
    with pytest.raises(IconstudioError) as caught:
        answer(workers.submit(*task, **limits), "Drawing it")
    assert str(caught.value) == words


def test_an_error_of_the_task_is_no_sentence(workers):
    with pytest.raises(ValueError, match="no good") as caught:
        answer(workers.submit(fail, "no good"), "Drawing it")
    assert "in fail" in caught.value.__notes__[0]


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="only there it is started early")
def test_nobody_hears_of_it_if_the_helper_of_python_is_killed(recwarn):
    from multiprocessing import resource_tracker

    with Workers(1) as workers:
        resource_tracker.ensure_running()
        os.kill(resource_tracker._resource_tracker._pid, signal.SIGKILL)
        # Until it is dead, and still to be waited for.
        os.waitid(os.P_PID, resource_tracker._resource_tracker._pid, os.WEXITED | os.WNOWAIT)
        assert workers.submit(abs, -3).result() == 3
    assert not recwarn.list
