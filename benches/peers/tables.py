"""The run: builds all candidates, times both tables and writes them."""

import datetime
import json
import os
import platform
import subprocess
import sys
import time

from measure import Pairs, checked, time_in_rounds
from candidates import candidates
from workshop import Library, Workshop

# The gaps of the second table, and the methods in it.
GAPS = [1e-6, 1e-4, 0.02, 0.1, 0.5]
OVER_GAPS = ["beamgap, blocks", "beamgap, four pairs in lanes"]


def main_table(all_candidates, references, pairs, given, left_out):
    """All candidates on the pairs, each task from the fastest to the slowest."""
    chosen = [w for w in all_candidates if w in references.values() or given.only in w.method]
    timed = [one for w in chosen if (one := checked(w, pairs, references[w.task], left_out))]
    time_in_rounds(timed, given.rounds, given.seed)
    rows = []
    for one in timed:
        candidate, (low, median, high) = one.candidate, one.ns()
        rows.append({
            "method": candidate.method, "version": candidate.version, "how": candidate.how, "task": candidate.task, "layout": candidate.layout,
            "ns_median": median, "ns_low": low, "ns_high": high,
            "ratio": one.ratio(), "error": one.rounded_error(), "note": candidate.note,
        })
    return sorted(rows, key=lambda row: (row["task"], row["ratio"]))


def over_gaps(all_candidates, references, pairs_at, given, left_out):
    """The crate's candidates on the same pairs at each gap, and at mixed gaps; nothing if the pairs are already moved."""
    candidates = [w for w in all_candidates if w.method in OVER_GAPS and given.only in w.method]
    if given.gaps or not candidates:
        return []
    all_pairs = [(gap, pairs_at(GAPS, which)) for which, gap in enumerate(GAPS)] + [(None, pairs_at(GAPS))]
    timed = []
    for candidate in candidates:
        for gap, pairs in all_pairs:
            where = " at a mixture of gaps" if gap is None else f" at a gap of {gap:g}"
            if one := checked(candidate, pairs, references[candidate.task], left_out, where):
                timed.append((gap, one))
    time_in_rounds([one for _, one in timed], given.rounds, given.seed)
    return [
        {
            "method": one.candidate.method, "task": one.candidate.task, "layout": one.candidate.layout, "gap": gap,
            "ns_median": one.ns()[1], "ratio": one.ratio(), "error": one.rounded_error(),
        }
        for gap, one in timed
    ]


def commit(root):
    git = lambda *a: subprocess.run(["git", "-C", str(root), *a], capture_output=True, text=True).stdout.strip()
    return git("rev-parse", "HEAD") + ("" if not git("status", "--porcelain", "--", ":!reports") else "+changes")


def cpu_name():
    with open("/proc/cpuinfo") as info:
        return next((line.split(":")[1].strip() for line in info if line.startswith("model name")), platform.machine())


def show(report):
    for row in report["rows"]:
        print(f"{row['task']}  {row['ns_median']:>11.1f} ns  x {row['ratio']:<9} {row['error'] or 0:.0e}  {row['method']}, {row['layout']}")
    for row in report["over_gaps"]:
        gap = "mixture" if row["gap"] is None else f"{row['gap']:g}"
        print(f"{row['task']}  gap {gap:<7}  x {row['ratio']:<9} {row['error']:.0e}  {row['method']}, {row['layout']}")
    for row in report["left_out"]:
        print("left out:", row["method"], "-", row["reason"])


def main(given, here, root, build, flags, debian):
    started = time.time()
    cpu = max(os.sched_getaffinity(0))
    workshop = Workshop(here, build, flags)
    subprocess.run(["cargo", "build", "--release", "--manifest-path", here / "Cargo.toml", "--target-dir", build / "rust"], check=True)
    crate = Library(build / "rust" / "release" / "libpeers.so")
    driver = workshop.compiled("driver", here / "driver.c", "driver")

    def pairs_at(*gaps):
        return Pairs(crate, driver, given.seed, given.pairs, *gaps)

    pairs = pairs_at(given.gaps)
    all_candidates = candidates(workshop, crate, root, debian, pairs.dofs())
    references = {task: next(w for w in all_candidates if w.task == task) for task in "AB"}
    os.sched_setaffinity(0, {cpu})
    rows = main_table(all_candidates, references, pairs, given, workshop.left_out)
    rows_over_gaps = over_gaps(all_candidates, references, pairs_at, given, workshop.left_out)
    report = {
        "schema": "beamgap-peers/2",
        "machine": f"{cpu_name()}, {platform.system()} {platform.release()}",
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "command": " ".join(["benches/peers/run", *sys.argv[1:]]),
        "commit": commit(root),
        "pairs": given.pairs, "rounds": given.rounds,
        "what": "nanoseconds of the processor a pair, median and quartiles over the rounds; ratio is the median over the rounds of the ratio to "
                "the reference, C++ with AVX2, full matrices, run just before; error is the largest in a gradient or Hessian, "
                "relative to its largest entry, against double-double",
        "rows": rows, "over_gaps": rows_over_gaps, "left_out": workshop.left_out,
    }
    given.out.write_text(json.dumps(report, indent=1) + "\n")
    show(report)
    print(f"{given.out}, in {time.time() - started:.0f} s")
