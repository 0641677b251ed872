#!/usr/bin/env python3
"""A sweep of 200 points: on one worker, on two, on four MPI ranks, and killed ten times at random moments (kill -9) and gone on with.
Prints the wall times and whether all of them end with the same results. Wants an idle host. Needs a build (preset release)."""
import argparse
import hashlib
import pathlib
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SWEEP = ROOT / "configs/sweeps/two-hundred.yaml"


def command(rasterloom, out, *more):
    return [str(rasterloom), "sweep", str(SWEEP), "--out", str(out), "--quiet", *more]


def points(out):
    """Rows that are there; None after a kill in the middle of writing, which the next who writes takes back."""
    if not (out / "results.sqlite").exists():
        return 0
    try:
        with sqlite3.connect(f"file:{out / 'results.sqlite'}?mode=ro", uri=True) as database:
            return database.execute("SELECT count(*) FROM points").fetchone()[0]
    except sqlite3.OperationalError:
        return None


def digest(out):
    """Of everything that two runs have to have in common: table `points` as it comes, and the CSV."""
    with sqlite3.connect(f"file:{out / 'results.sqlite'}?mode=ro", uri=True) as database:
        rows = repr(database.execute("SELECT * FROM points").fetchall())
    return hashlib.sha256(rows.encode() + (out / "results.csv").read_bytes()).hexdigest()[:16]


def least_times(ways, runs):
    """Wall and processor time of each way, {name: words}: of the quickest of `runs`, all ways by turns, since other work may be on the host."""
    least = {}
    for _ in range(runs):
        for name, words in ways.items():
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            start = time.monotonic()
            subprocess.run([*words, "--fresh"], check=True)
            wall = time.monotonic() - start
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            least[name] = min(least.get(name, (wall, processor)), (wall, processor))
    return least


def kill_and_resume(rasterloom, out, kills, seconds, seed):
    """Kills the sweep `kills` times, each after a random part of the time that it takes; returns how many points were there each time."""
    chance = random.Random(seed)
    there = []
    for _ in range(kills):
        process = subprocess.Popen(command(rasterloom, out, "--workers", "2"))
        time.sleep(chance.uniform(0, 1.6 * seconds / kills))
        process.send_signal(signal.SIGKILL)
        process.wait()
        there.append(points(out))
    subprocess.run(command(rasterloom, out), check=True)
    return there


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rasterloom", type=pathlib.Path, default=ROOT / "build/release/rasterloom")
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if not options.rasterloom.exists():
        sys.exit(f"bench_sweep.py: {options.rasterloom} is missing; build the preset release first")
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        ways = {"1 worker": command(options.rasterloom, out / "1 worker", "--workers", "1"),
                "2 workers": command(options.rasterloom, out / "2 workers", "--workers", "2")}
        if mpirun := shutil.which("mpirun"):
            ways["4 MPI ranks"] = [mpirun, "--allow-run-as-root", "--oversubscribe", "-n", "4",
                                   *command(options.rasterloom, out / "4 MPI ranks", "--mpi")]
        print("| way | wall time | processor time | results |\n|---|---|---|---|", flush=True)
        least = least_times(ways, options.runs)
        for name, (wall, processor) in least.items():
            print(f"| {name} | {wall:.1f} s | {processor:.1f} s | {points(out / name)} points, {digest(out / name)} |", flush=True)
        there = kill_and_resume(options.rasterloom, out / "killed", options.kills, least["2 workers"][0], options.seed)
        shown = ", ".join("writing" if count is None else str(count) for count in there)
        print(f"| killed {options.kills} times, with so many points there: {shown} | | | "
              f"{points(out / 'killed')} points, {digest(out / 'killed')} |")
        results = {digest(path) for path in out.iterdir()}
    print("The same results by every way." if len(results) == 1 else "THE RESULTS DIFFER.")
    sys.exit(0 if len(results) == 1 else 1)


if __name__ == "__main__":
    main()
