"""Verifies the results of the candidates and times the candidates in interleaved rounds."""

import ctypes
import dataclasses
import random

import numpy as np
from candidates import FULL, QUANTITIES, Candidate, blocks

# The time of a candidate in a round and in a check, in nanoseconds.
ROUND, CHECK = 3e5, 2e8
# The minimum number of pairs for the time of the reference.
FEWEST = 200


def off(got, right):
    """The largest difference in a gradient or Hessian, relative to its largest entry, and in a value."""
    worst = np.max(np.abs(got[:, 0] - right[:, 0]))
    for part in [slice(8, 32), slice(32, FULL)]:
        difference = np.max(np.abs(got[:, part] - right[:, part]), axis=1) / np.max(np.abs(right[:, part]), axis=1)
        worst = max(worst, np.max(difference)) if np.all(np.isfinite(difference)) else np.inf
    return float(worst) if np.isfinite(worst) else np.inf


class Pairs:
    """The pairs, stored by the crate: with the drawn gaps, all at the gap with index `which`, or each at a random gap."""

    def __init__(self, crate, driver, seed, count, gaps=(), which=None):
        stride, gaps = ctypes.c_size_t(), np.array(gaps, np.float64)
        sizes = [ctypes.c_uint64, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t, ctypes.c_void_p]
        draw = ctypes.CFUNCTYPE(ctypes.c_void_p, *sizes)(crate["draw_cases"].value)
        which = len(gaps) if which is None else which
        self.first = draw(seed, count, gaps.ctypes.data, len(gaps), which, ctypes.addressof(stride))
        self.count = count
        self.stride = stride.value
        memory = np.zeros(1 << 18)
        skip = (-memory.ctypes.data % 64) // 8
        self.out = memory[skip:]
        of_one = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t, ctypes.c_void_p]
        self.one = ctypes.CFUNCTYPE(ctypes.c_double, *of_one)(driver["run"].value)
        self.many = ctypes.CFUNCTYPE(ctypes.c_double, of_one[0], ctypes.c_size_t, *of_one[1:])(driver["run_together"].value)
        of_exact = [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]
        self.exact = ctypes.CFUNCTYPE(None, *of_exact)(crate["right_all_full"].value)
        self.known = {}

    def run(self, candidate, first, count):
        """Nanoseconds a pair."""
        if callable(candidate.function):
            return candidate.function(self.count) / self.count
        pairs = [self.first + self.stride * first, self.stride, count, self.out.ctypes.data]
        ns = self.one(candidate.function, *pairs) if candidate.together == 1 else self.many(candidate.function, candidate.together, *pairs)
        return ns / count

    def right(self, i):
        """The exact result for a pair, in the full layout."""
        if i not in self.known:
            self.known[i] = np.zeros((5, FULL))
            at = self.first + self.stride * i
            xi = (ctypes.c_double * 26).from_address(at)
            self.exact(at, xi[24], xi[25], self.known[i].ctypes.data)
        return self.known[i]

    def dofs(self):
        raw = (ctypes.c_char * (self.stride * self.count)).from_address(self.first)
        return np.ndarray((self.count, 26), np.float64, raw, strides=(self.stride, 8)).copy()


def check(candidate, pairs):
    """The worst error over the pairs that fit in the time of a check, and nanoseconds a pair."""
    step, worst, first, spent, count = candidate.together, 0.0, 0, 0.0, QUANTITIES[candidate.task]
    if callable(candidate.function):
        spent = candidate.function(pairs.count)
        got = np.asarray(candidate.function.result())
        return max(off(got[i, :count], pairs.right(i)[:count]) for i in range(len(got))), spent / pairs.count
    while first + step <= pairs.count and spent < CHECK:
        pairs.out.fill(np.nan)
        spent += step * pairs.run(candidate, first, step)
        if candidate.tolerance is not None:
            for k, got in enumerate(blocks(pairs.out, candidate)):
                worst = max(worst, off(got, pairs.right(first + k)[:count]))
        first += step
    return worst, spent / first


def timed_warm(pairs, candidate, first, count):
    """Nanoseconds a pair, after an untimed run of the same pairs unless it takes long.

    The clock of the processor sometimes does not advance on a virtual machine; the run is then repeated."""
    if count > 8 and not callable(candidate.function):
        pairs.run(candidate, first, count)
    for _ in range(100):
        if (taken := pairs.run(candidate, first, count)) > 0:
            return taken
    raise RuntimeError(f"the processor's clock stands still while {candidate.method} runs")


@dataclasses.dataclass
class Timed:
    """A candidate on some pairs, the number of pairs in a round, and its times and ratios to the reference."""

    candidate: Candidate
    pairs: Pairs
    reference: Candidate
    error: float
    count: int
    times: list = dataclasses.field(default_factory=list)
    ratios: list = dataclasses.field(default_factory=list)

    def round(self, number):
        """One round: the reference on a sufficient number of pairs, then the candidate; both with warm caches."""
        first = (number * self.count) % (self.pairs.count - self.count + 1)
        fewest = min(max(self.count, FEWEST), self.pairs.count)
        reference = timed_warm(self.pairs, self.reference, min(first, self.pairs.count - fewest), fewest)
        self.times.append(timed_warm(self.pairs, self.candidate, first, self.count))
        self.ratios.append(self.times[-1] / reference)

    def ns(self):
        """The lower quartile, the median and the upper quartile of the times."""
        return [round(float(ns), 1) for ns in np.quantile(self.times, [0.25, 0.5, 0.75])]

    def ratio(self):
        return float(f"{np.median(self.ratios):.4g}")

    def rounded_error(self):
        return None if self.candidate.tolerance is None else float(f"{self.error:.2g}")


def checked(candidate, pairs, reference, left_out, where=""):
    """A candidate for timing, or nothing if its result is wrong; `where` names the pairs."""
    error, cost = check(candidate, pairs)
    print(f"{candidate.task} {candidate.method}, {candidate.layout}{where}: off by {error:.1e}, about {cost:.0f} ns", flush=True)
    if candidate.tolerance is not None and not error <= candidate.tolerance:
        left_out.append({"method": f"{candidate.method}, task {candidate.task}{where}", "reason": f"off by {error:.1e}"})
        return None
    if cost < ROUND / 16 and not callable(candidate.function):
        cost = pairs.run(candidate, 0, 64)
    count = int(np.clip(ROUND / cost, candidate.together, pairs.count))
    return Timed(candidate, pairs, reference, error, count - count % candidate.together)


def time_in_rounds(timed, rounds, seed):
    """Times all candidates in every round, in a different order each time."""
    order = random.Random(seed)
    for number in range(rounds):
        for one in order.sample(timed, len(timed)):
            one.round(number)
