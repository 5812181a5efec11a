"""The main job from a cold session with cached rasters: time to the first and last result, memory.

Run with ``python -m pytest tests/benchmarks --benchmark-only``.
"""

import resource
import subprocess
import sys

import pytest

CODE = """
import time
began = time.perf_counter()
from iconstudio.session import Session
from iconstudio.inputs.sketch import example
from iconstudio.workflows.events import Result
first, count = None, 0
if __name__ == "__main__":
    with Session() as session:
        for event in session.model(example("motorbike").sketch):
            if isinstance(event, Result):
                first = first or time.perf_counter() - began
                count += 1
    print(first, time.perf_counter() - began, count)
"""


@pytest.mark.benchmark(group="motorbike: 4 styles, 8 lambda_S each")
def test_motorbike(benchmark, tmp_path):
    script = tmp_path / "run.py"
    script.write_text(CODE)
    firsts = []

    def run():
        out = subprocess.run(
            [sys.executable, str(script)], check=True, capture_output=True, text=True
        ).stdout
        first, _, count = out.split()
        assert count == "32"
        firsts.append(float(first))

    benchmark.pedantic(run, rounds=2, warmup_rounds=1)
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    benchmark.extra_info["first result, seconds"] = sorted(firsts)[len(firsts) // 2]
    benchmark.extra_info["peak memory of the largest process, MiB"] = peak / 1024
