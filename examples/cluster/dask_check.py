"""Runs `beamgap check` on a Dask cluster: a task for each shard, and one merged result.

usage: python dask_check.py SCHEDULER SHARDS [options of beamgap check]

SCHEDULER is the address of a scheduler, or `local` for two processes on this machine. The merged result is written to
merged.json. It is equal, to the last byte, to that of a run on one machine. The exit code is that of beamgap.
"""

import pathlib
import subprocess
import sys
import tempfile

from dask.distributed import Client


def shard(number, of, options):
    """The result of one shard, as text."""
    command = ["beamgap", "check", "--shard", f"{number}/{of}", "--threads", "1", "--format", "json", *options]
    run = subprocess.run(command, capture_output=True, text=True)
    if not run.stdout:  # Exit code 1 is a result; invalid arguments and a failed machine are not.
        raise RuntimeError(run.stderr)
    return run.stdout


def main(scheduler, shards, *options):
    local = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with Client(**local) if scheduler == "local" else Client(scheduler) as client:
        tasks = client.map(shard, range(1, int(shards) + 1), of=shards, options=options, pure=False, retries=2)
        results = client.gather(tasks)
    with tempfile.TemporaryDirectory() as folder:
        parts = [pathlib.Path(folder, f"{number}.json") for number in range(len(results))]
        for part, result in zip(parts, results):
            part.write_text(result)
        return subprocess.run(["beamgap", "merge", *parts, "--output", "json=merged.json"]).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
