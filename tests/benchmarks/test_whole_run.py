"""The main job from the start of the program, rasters cached: first result, last one, and memory.

Run with ``pytest -n 0 tests/benchmarks/test_whole_run.py --benchmark-only``.
"""

import statistics
import subprocess
import sys

import pytest

from tests.benchmarks.memory import Peak

CODE = """
import time
began = time.perf_counter()
from iconstudio.workflows.modelling.spec import MODELLING
from iconstudio.session import Session
from iconstudio.workflows.modelling.file import example
from iconstudio.workflows.events import Result
first, count = None, 0
if __name__ == "__main__":
    with Session() as session:
        for event in session.run(MODELLING, example("motorbike").sketch):
            if isinstance(event, Result) and event.icon.composite.symmetry is None:
                first = first or time.perf_counter() - began
                count += 1
    print(first, count)
"""


@pytest.mark.benchmark(group="motorbike, from the start of the program: 4 styles x 8 lambda_S")
def test_motorbike(benchmark, tmp_path):
    script = tmp_path / "run.py"
    script.write_text(CODE)
    firsts, peaks = [], []

    def run():
        program = subprocess.Popen([sys.executable, str(script)], stdout=subprocess.PIPE, text=True)
        with Peak(program.pid) as peak:
            out, _ = program.communicate()
        first, count = out.split()
        assert count == "32"
        firsts.append(float(first))
        peaks.append(peak.mebibytes)

    benchmark.pedantic(run, rounds=2, warmup_rounds=1)
    benchmark.extra_info["first result, seconds"] = statistics.median(firsts[1:])
    benchmark.extra_info["peak memory of all processes, MiB"] = max(peaks)
