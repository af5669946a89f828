"""Ctrl-C, each time in a process of its own."""

import signal
import subprocess
import sys
import time

import itk
import pytest
from conftest import BRAIN

RUN = """
import sys
import time
import itk

image = itk.imread({image!r})
filter = itk.DelaunayRefinementMeshFilter.New(image, lower_threshold=1, delta=2.0, cell_size=1.3)
print("ready", flush=True)
try:
    {statement}
except KeyboardInterrupt:
    print("interrupted", time.time(), flush=True)
    filter.SetDelta(6.0)
    filter.SetCellSize(100.0)
    filter.Update()
    print(filter.GetOutput().GetNumberOfCells(), flush=True)
"""


def start(program):
    # What a shell runs in its background ignores Ctrl-C, and so would the child.
    heed = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
    return subprocess.Popen(
        [sys.executable, "-c", heed + program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def interrupt(statement, after):
    program = RUN.format(image=str(BRAIN), statement=statement)
    process = start(program)
    assert process.stdout.readline() == "ready\n"
    time.sleep(after)
    sent = time.time()
    process.send_signal(signal.SIGINT)
    out, error = process.communicate(timeout=60)
    return sent, out.split(), error, process.returncode


@pytest.mark.parametrize("after", [0.1, 0.5, 1.5, 2.5])
@pytest.mark.parametrize(
    "statement",
    [
        "filter.Update()",
        "itk.delaunay_refinement_mesh_filter(image, lower_threshold=1, delta=2.0, cell_size=1.3)",
        "itk.tetrahedral_mesh_writer(filter.GetOutput(), file_name='/tmp/never.vtu')",
    ],
)
def test_keyboard_interrupt_within_a_second(statement, after):
    sent, out, error, code = interrupt(statement, after)
    assert out[:1] == ["interrupted"], error
    assert float(out[1]) - sent < 1.0
    assert int(out[2]) > 9000 and code == 0


def test_traceback_is_of_the_interrupt():
    # The function's first use loads libraries, and ITK's loader is deaf.
    program = f"import itk; image = itk.imread({str(BRAIN)!r}); f = itk.delaunay_refinement_mesh_filter; " + (
        "f(image, lower_threshold=1, delta=9.0); print('ready', flush=True); "
        "f(image, lower_threshold=1, delta=2.0, cell_size=1.3)"
    )
    process = start(program)
    process.stdout.readline()
    time.sleep(1.0)
    process.send_signal(signal.SIGINT)
    error = process.communicate(timeout=60)[1]
    assert error.rstrip().endswith("KeyboardInterrupt")
    assert "RuntimeError" not in error


def test_what_a_handler_raises_arrives(brain):
    class Alarm(Exception):
        pass

    def handler(number, frame):
        raise Alarm("after half a second")

    itk.delaunay_refinement_mesh_filter(brain, lower_threshold=1, delta=9.0)
    previous = signal.signal(signal.SIGALRM, handler)
    signal.setitimer(signal.ITIMER_REAL, 0.5)
    try:
        with pytest.raises(Alarm, match="half a second"):
            itk.delaunay_refinement_mesh_filter(brain, lower_threshold=1, delta=2.0, cell_size=1.3)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, previous)
