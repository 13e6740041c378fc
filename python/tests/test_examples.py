"""The examples run, and their figures are right."""

import importlib.util
import os
import signal
import sys
from pathlib import Path

import linkage
import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def example(name: str):
    specification = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(specification)
    # Workers of a cluster find its functions by this name.
    sys.modules[name] = module
    specification.loader.exec_module(module)
    return module


def test_least_squares_finds_the_dimensions():
    pytest.importorskip("scipy")
    module = example("least_squares")
    assert np.abs(module.main()).max() < 1e-9
    phi = np.linspace(0, 6, 5)
    residuals, jacobian = module.problem(["crank", "arm"], phi, np.zeros((5, 2)))
    x, step = np.array([50.0, 70.0]), 1e-6
    for k, own in enumerate(np.eye(2)):
        difference = (residuals(x + step * own) - residuals(x - step * own)) / (2 * step)
        assert np.allclose(jacobian(x)[:, k], difference, atol=1e-7)


def test_gradients_of_jax():
    pytest.importorskip("jax")
    assert example("with_jax").main() < 1e-7


def test_gradients_of_torch():
    pytest.importorskip("torch")
    assert example("with_torch").main()


def test_a_study_by_ray_is_that_of_one_process():
    ray = pytest.importorskip("ray")
    module = example("with_ray")
    m = linkage.load(module.FILE).assemble()
    paths = os.pathsep.join([str(EXAMPLES), *(path for path in sys.path if path)])
    ray.init(num_cpus=2, include_dashboard=False, runtime_env={"env_vars": {"PYTHONPATH": paths}})
    try:
        found = module.study(50_001, parts=3)
    finally:
        ray.shutdown()
    assert found.to_bytes() == module.study_part(m, 7, 50_001, 0, 1).to_bytes()


@pytest.fixture(scope="module")
def cluster():
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    ) as local, distributed.Client(local) as client:
        paths = [str(EXAMPLES), *(path for path in sys.path if path)]
        client.run(lambda: sys.path.extend(path for path in paths if path not in sys.path))
        yield client


def test_results_of_a_cluster_do_not_depend_on_workers(cluster):
    module = example("cluster")
    m = linkage.load(module.FILE).assemble()
    count = 50_001
    alone = module.study_part(m, 7, count, 0, 1)
    for partitions in (1, 3, 5):
        found = module.tolerances(cluster, m, 7, count, partitions)
        assert found.done == count and found.to_bytes() == alone.to_bytes()
    # The root of the sum of squares of uniform deviations.
    text = module.FILE.read_text()
    bar = linkage.parse(text.replace("{ tracer }", "{ tracer, e: sensitivity(tracer) }"))
    e = bar.assemble().path(module.PHI).e
    parts = [e[name] * one.tolerance for name, one in bar.parameters.items()]
    expected = np.sqrt(sum(part**2 for part in parts) / 3)
    names = ("tracer.x", "tracer.y")
    deviations = [alone.statistics(name).deviation.value for name in names]
    assert np.allclose(deviations, expected, rtol=0.02)


def test_a_search_on_a_cluster_is_that_of_one_process(cluster):
    module = example("cluster")
    m = linkage.load(module.FILE).assemble()
    wanted = m.path(np.linspace(0.3, 2.0, 6), crank=np.full(6, 48.0)).tracer
    alone = module.design_blocks(m, 7, 0, 150_000, wanted)
    assert module.designs(cluster, m, 7, 150_000, 2, wanted) == alone
    assert all(np.isfinite(block[1]) for block in alone)


def test_a_killed_worker_changes_nothing(cluster):
    module = example("cluster")
    m = linkage.load(module.FILE).assemble()
    count = 100_000
    alone = module.study_part(m, 3, count, 0, 1)
    processes = cluster.run(os.getpid)
    # From here, not as a task: a task that kills its worker is done again by the other one.
    os.kill(next(iter(processes.values())), signal.SIGKILL)
    found = module.tolerances(cluster, m, 3, count, 6)
    assert found.to_bytes() == alone.to_bytes()
    # A question to a worker that is just being replaced may have no answer.
    cluster.wait_for_workers(2, timeout=120)
    assert set(cluster.run(os.getpid).values()) != set(processes.values())


def test_numbers_of_a_mechanism_do_not_depend_on_the_others():
    pytest.importorskip("distributed")
    uniform = example("cluster").uniform
    whole = uniform(7, 0, 100, 5)
    assert (uniform(7, 33, 10, 5) == whole[33:43]).all()
    assert (uniform(8, 33, 10, 5) != whole[33:43]).all()
