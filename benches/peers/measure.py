"""Builds the peers, checks what they compute and times them in turn."""

import ctypes
import datetime
import json
import os
import platform
import random
import subprocess
import sys
import time

import numpy as np
from ways import FULL, QUANTITIES, blocks, ways
from workshop import Library, Workshop

# What a round spends on a way, in nanoseconds, and what a check does.
ROUND, CHECK = 3e5, 2e8
# The fewest pairs that the reference is timed on.
FEWEST = 200


def commit(root):
    git = lambda *a: subprocess.run(["git", "-C", str(root), *a], capture_output=True, text=True).stdout.strip()
    return git("rev-parse", "HEAD") + ("" if not git("status", "--porcelain", "--", ":!reports") else "+changes")


def off(got, right):
    """The largest difference in a gradient or Hessian, relative to its largest entry, and in a value."""
    worst = np.max(np.abs(got[:, 0] - right[:, 0]))
    for part in [slice(8, 32), slice(32, FULL)]:
        difference = np.max(np.abs(got[:, part] - right[:, part]), axis=1) / np.max(np.abs(right[:, part]), axis=1)
        worst = max(worst, np.max(difference)) if np.all(np.isfinite(difference)) else np.inf
    return float(worst) if np.isfinite(worst) else np.inf


class Pairs:
    """The pairs, drawn and kept by the crate."""

    def __init__(self, crate, driver, seed, count, gaps=()):
        stride, gaps = ctypes.c_size_t(), np.array(gaps, np.float64)
        sizes = [ctypes.c_uint64, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]
        draw = ctypes.CFUNCTYPE(ctypes.c_void_p, *sizes)(crate["draw_cases"].value)
        self.first = draw(seed, count, gaps.ctypes.data, len(gaps), ctypes.addressof(stride))
        self.count = count
        self.stride = stride.value
        memory = np.zeros(1 << 18)
        skip = (-memory.ctypes.data % 64) // 8
        self.out = memory[skip:]
        of_one = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t, ctypes.c_void_p]
        self.one = ctypes.CFUNCTYPE(ctypes.c_double, *of_one)(driver["run"].value)
        self.many = ctypes.CFUNCTYPE(ctypes.c_double, of_one[0], ctypes.c_size_t, *of_one[1:])(driver["run_together"].value)

    def run(self, way, first, count):
        """Nanoseconds a pair."""
        if callable(way.function):
            return way.function(self.count) / self.count
        pairs = [self.first + self.stride * first, self.stride, count, self.out.ctypes.data]
        ns = self.one(way.function, *pairs) if way.together == 1 else self.many(way.function, way.together, *pairs)
        return ns / count

    def dofs(self):
        raw = (ctypes.c_char * (self.stride * self.count)).from_address(self.first)
        return np.ndarray((self.count, 26), np.float64, raw, strides=(self.stride, 8)).copy()


def check(way, pairs, right):
    """The worst error over as many pairs as there is time for, and nanoseconds a pair."""
    step, worst, first, spent = way.together, 0.0, 0, 0.0
    if callable(way.function):
        spent = way.function(pairs.count)
        got = np.asarray(way.function.result())
        return max(off(got[i, : QUANTITIES[way.task]], right(i)[: QUANTITIES[way.task]]) for i in range(len(got))), spent / pairs.count
    while first + step <= pairs.count and spent < CHECK:
        pairs.out.fill(np.nan)
        spent += step * pairs.run(way, first, step)
        if way.tolerance is not None:
            for k, got in enumerate(blocks(pairs.out, way)):
                worst = max(worst, off(got, right(first + k)[: QUANTITIES[way.task]]))
        first += step
    return worst, spent / first


def timed_warm(pairs, way, first, count):
    """Nanoseconds a pair, after the same untimed unless that takes long.

    A processor's time without what the host takes from it has been seen to stand still: then again."""
    if count > 8 and not callable(way.function):
        pairs.run(way, first, count)
    for _ in range(100):
        if (taken := pairs.run(way, first, count)) > 0:
            return taken
    raise RuntimeError(f"the processor's clock stands still while {way.method} runs")


def main(given, here, root, build, flags, debian):
    started = time.time()
    cpu = max(os.sched_getaffinity(0))
    workshop = Workshop(here, build, flags)
    subprocess.run(["cargo", "build", "--release", "--manifest-path", here / "Cargo.toml", "--target-dir", build / "rust"], check=True)
    crate = Library(build / "rust" / "release" / "libpeers.so")
    driver = workshop.compiled("driver", here / "driver.c", "driver")
    pairs = Pairs(crate, driver, given.seed, given.pairs, given.gaps)
    all_ways = ways(workshop, crate, root, debian, pairs.dofs())
    os.sched_setaffinity(0, {cpu})
    known = {}
    exact = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p)(crate["right_all_full"].value)

    def right(i):
        if i not in known:
            known[i] = np.zeros((5, FULL))
            at = pairs.first + pairs.stride * i
            xi = (ctypes.c_double * 26).from_address(at)
            exact(at, xi[24], xi[25], known[i].ctypes.data)
        return known[i]

    references = {task: next(w for w in all_ways if w.task == task) for task in "AB"}
    chosen = [w for w in all_ways if w in references.values() or given.only in w.method]
    timed = []
    for way in chosen:
        error, cost = check(way, pairs, right)
        print(f"{way.task} {way.method}, {way.layout}: off by {error:.1e}, about {cost:.0f} ns", flush=True)
        if way.tolerance is not None and not error <= way.tolerance:
            workshop.left_out.append({"method": f"{way.method}, task {way.task}", "reason": f"off by {error:.1e}"})
            continue
        if cost < ROUND / 16 and not callable(way.function):
            cost = pairs.run(way, 0, 64)
        count = int(np.clip(ROUND / cost, way.together, pairs.count))
        timed.append((way, error, count - count % way.together, [], []))
    # In turn, in another order each time, each right after the reference on as many pairs as take a while; both in warm caches.
    order = random.Random(given.seed)
    for turn in range(given.rounds):
        for way, _, count, times, ratios in order.sample(timed, len(timed)):
            first = (turn * count) % (pairs.count - count + 1)
            fewest = min(max(count, FEWEST), pairs.count)
            reference = timed_warm(pairs, references[way.task], min(first, pairs.count - fewest), fewest)
            times.append(timed_warm(pairs, way, first, count))
            ratios.append(times[-1] / reference)
    rows = []
    for way, error, count, times, ratios in timed:
        low, median, high = np.quantile(times, [0.25, 0.5, 0.75])
        rows.append({
            "method": way.method, "version": way.version, "how": way.how, "task": way.task, "layout": way.layout,
            "ns_median": round(float(median), 1), "ns_low": round(float(low), 1), "ns_high": round(float(high), 1),
            "ratio": float(f"{np.median(ratios):.4g}"), "error": None if way.tolerance is None else float(f"{error:.2g}"), "note": way.note,
        })
    rows.sort(key=lambda row: (row["task"], row["ratio"]))
    report = {
        "schema": "beamgap-peers/1",
        "machine": f"{cpu_name()}, {platform.system()} {platform.release()}",
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "command": " ".join(["benches/peers/run", *sys.argv[1:]]),
        "commit": commit(root),
        "pairs": given.pairs, "rounds": given.rounds,
        "what": "nanoseconds of the processor a pair, median and quartiles over the rounds; ratio is the median over the rounds of the ratio to "
                "the reference, C++ with AVX2, full matrices, run just before; error is the largest in a gradient or Hessian, "
                "relative to its largest entry, against double-double",
        "rows": rows, "left_out": workshop.left_out,
    }
    given.out.write_text(json.dumps(report, indent=1) + "\n")
    for row in rows:
        print(f"{row['task']}  {row['ns_median']:>11.1f} ns  x {row['ratio']:<9} {row['error'] or 0:.0e}  {row['method']}, {row['layout']}")
    for row in workshop.left_out:
        print("left out:", row["method"], "-", row["reason"])
    print(f"{given.out}, in {time.time() - started:.0f} s")


def cpu_name():
    with open("/proc/cpuinfo") as info:
        return next((line.split(":")[1].strip() for line in info if line.startswith("model name")), platform.machine())
