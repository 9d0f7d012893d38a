"""Builds the peers, checks what they compute and times them in turn."""

import collections
import ctypes
import datetime
import importlib.metadata
import json
import os
import platform
import random
import re
import subprocess
import sys
import time

import numpy as np

FULL, UPPER, HALF = 608, 464, 332
TRIANGLE = np.triu_indices(24)
QUANTITIES = {"A": 1, "B": 5}
TASK = {"A": "d", "B": "all"}
# A way that is off by more than this, relative to the largest entry, is no peer.
EXACT, DIFFERENCES = 1e-9, 1e-2
# What a round spends on a way, in nanoseconds, and what a check does.
ROUND, CHECK = 3e5, 1e9

Way = collections.namedtuple("Way", "task method version how layout note function read together tolerance")


class Library:
    """A shared library of functions in the form of peer.h."""

    def __init__(self, path):
        self.dll = ctypes.CDLL(str(path))

    def __getitem__(self, name):
        return ctypes.cast(self.dll[name], ctypes.c_void_p)


class Workshop:
    """Where peers are built, with a list of those that could not be."""

    def __init__(self, here, build, flags):
        self.here, self.build, self.flags, self.left_out = here, build, flags, []

    def command(self, command, method, **options):
        print("$", " ".join(map(str, command)), flush=True)
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
        if done.returncode:
            lines = [line for line in done.stderr.splitlines() if "rror" in line] or done.stderr.splitlines() or ["failed"]
            self.left_out.append({"method": method, "reason": lines[0].strip()})
            print("  left out:", lines[0].strip())
        return done.returncode == 0

    def compiled(self, method, source, name, defines=(), flags=None, libraries=(), generated=()):
        """The library of one source file and what it includes, if it compiles; made anew if they or the command are new."""
        compiler = ["g++", "-std=c++17"] if source.suffix == ".cpp" else ["gcc", "-std=gnu11"]
        to = self.build / f"{name}.so"
        command = [*compiler, *(flags or self.flags), f"-I{self.here}", f"-I{self.build}", *defines, "-o", to, source, *libraries]
        stamp, line = to.with_suffix(".command"), " ".join(map(str, command))
        sources = [source, *generated, *self.here.glob("*.h"), *self.here.glob("*.hpp")]
        newest = max(s.stat().st_mtime for s in sources)
        if not (to.exists() and stamp.exists() and stamp.read_text() == line and to.stat().st_mtime > newest):
            if not self.command(command, method):
                return None
            stamp.write_text(line)
        try:
            return Library(to)
        except OSError as error:
            self.left_out.append({"method": method, "reason": str(error)})
            return None


def version_of(command):
    return subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]


def commit(root):
    git = lambda *a: subprocess.run(["git", "-C", str(root), *a], capture_output=True, text=True).stdout.strip()
    return git("rev-parse", "HEAD") + ("" if not git("status", "--porcelain", "--", ":!reports") else "+changes")


def package(name):
    """The version of a Debian package, or nothing."""
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else None


def ways(workshop, crate, root, debian):
    """All ways, the reference of each task first."""
    gcc, here, build = version_of(["gcc", "-dumpfullversion"]), workshop.here, workshop.build
    flags = " ".join(f for f in workshop.flags if f not in ("-fPIC", "-shared"))
    rustc = version_of(["rustc", "--version"]).split()[1]
    beamgap = re.search(r'^version = "(.*)"', (root / "Cargo.toml").read_text(), re.M)[1]
    all_ways = []

    def add(task, method, version, how, layout, function, note="", read=None, together=1, tolerance=EXACT):
        all_ways.append(Way(task, method, version, how, layout, note, function, read, together, tolerance))

    def both(method, version, how, library, name, layout="full", note=""):
        for task in "AB":
            if library:
                add(task, method, version, how, layout, library[f"{name}_{TASK[task]}_{layout}"], note)

    def ours(method, how, name, layouts=None, note="", together=1, tolerance=EXACT):
        for task in "AB":
            for layout in layouts or [None]:
                function = f"{name}_{TASK[task]}" + (f"_{layout}" if layout else "")
                add(task, method, beamgap, how, layout or "upper", crate[function], note, crate[f"{function}_read"], together, tolerance)

    cxx = f"g++ {gcc} {flags}"
    reference = workshop.compiled("C++ with AVX2, by hand", here / "reference.cpp", "reference")
    for layout in ["full", "upper"]:
        both("C++ with AVX2, by hand", gcc, cxx, reference, "ref", layout, "the reference" if layout == "full" else "")
    lanes = workshop.compiled("C++ with AVX2, by hand, four pairs in lanes", here / "lanes.cpp", "lanes")
    for task in "AB" if lanes else "":
        add(task, "C++ with AVX2, by hand, four pairs in lanes", gcc, cxx, "four lanes, half", lanes[f"lanes_{TASK[task]}_half"], together=4)
    text = workshop.compiled("plain C, textbook form", here / "textbook.c", "textbook", flags=["-O3", "-march=native", "-fno-math-errno", "-fPIC", "-shared"])
    both("plain C, textbook form", gcc, f"gcc {gcc} -O3 -march=native -fno-math-errno", text, "text")

    rust = f"rustc {rustc} --release, default target"
    ours("beamgap, blocks", rust + ", AVX2 at run time", "blocks", ["full", "upper"])
    ours("beamgap, Matrices", rust, "crate", note="B: with both slips")

    # CasADi and SymPy.
    for peer, pieces in [("casadi", ["casadi", "casadi_implicit"]), ("sympy", ["sympy"])]:
        sources = [build / f"{piece}_{TASK[task]}.c" for piece in pieces for task in "AB"]
        generator = here / "generate.py"
        if not all(s.exists() and s.stat().st_mtime > generator.stat().st_mtime for s in sources):
            if not workshop.command([sys.executable, generator, peer, build], peer, cwd=build):
                continue
    casadi = importlib.metadata.version("casadi") if (build / "casadi_d.c").exists() else None
    for name, method in [("casadi", "CasADi, envelope theorem"), ("casadi_implicit", "CasADi, implicit function theorem")]:
        for task in "AB" if casadi else "":
            function = f"{name}_{TASK[task]}"
            generated = build / f"{function}.c"
            defines = [f"-DFUNCTION={function}", f'-DSOURCE="{function}.c"']
            library = workshop.compiled(method, here / "casadi.c", function, [*defines, "-w"], libraries=["-lm"], generated=[generated])
            if library:
                add(task, method, casadi, f"generated C, cse; gcc {gcc} {flags}", "full", library[f"{function}_full"])
            lanes = workshop.compiled(f"{method}, four pairs in lanes", here / "casadi_lanes.cpp", f"{function}_lanes", [*defines, "-w"], generated=[generated])
            if lanes:
                add(task, f"{method}, four pairs in lanes", casadi, f"the same over four lanes; {cxx}", "four lanes", lanes[f"{function}_lanes"], together=4)
    for task in "AB":
        source = build / f"sympy_{TASK[task]}.c"
        if source.exists():
            library = workshop.compiled("SymPy with cse", source, f"sympy_{TASK[task]}", libraries=["-lm"])
            if library:
                add(task, "SymPy with cse", importlib.metadata.version("sympy"), f"generated C; gcc {gcc} {flags}", "full", library[f"sympy_{TASK[task]}_full"])

    # Automatic differentiation in C++.
    for peer, header in [("Eigen", "autodiff_eigen.cpp"), ("Sacado", "autodiff_sacado.cpp")]:
        version = package(debian[peer][0])
        if not version:
            workshop.left_out.append({"method": peer, "reason": f"{debian[peer][0]} is not installed"})
            continue
        mpi = subprocess.run(["mpicxx", "--showme:compile"], capture_output=True, text=True).stdout.split() if peer == "Sacado" else []
        includes = ["-I/usr/include/eigen3", "-I/usr/include/trilinos", "-DOMPI_SKIP_MPICXX", *mpi]
        library = workshop.compiled(peer, here / header, header.split(".")[0], [*includes, "-w"], libraries=[f"-ltrilinos_teuchos{part}" for part in ["comm", "parameterlist", "core"]] if mpi else [])
        names = {"Eigen": "AutoDiffScalar, nested", "Sacado": "SFad, nested"}
        both(f"{peer}, {names[peer]}", version, f"A one chord step, B two; {cxx}", library, peer.lower())

    workshop.left_out.append({"method": "CppAD", "reason": "Debian 12 has no package of it"})

    # The crate's own automatic differentiation, and differences.
    num_dual = re.search(r'name = "num-dual"\nversion = "(.*)"', (here / "Cargo.lock").read_text())[1]
    swept = f"num-dual {num_dual}, hyper-dual sweep"
    ours(f"{swept}, chord", rust + "; A one chord step, B two", "chord")
    ours(f"{swept}, Newton", rust + "; implicit_derivative_binary", "newton")
    ours(f"{swept}, stationary", rust + "; implicit_derivative_sp", "stationary")
    ours(f"num-dual {num_dual}, Dual2SVec64<24>, chord", rust + "; A one chord step, B two", "vector")
    ours("central differences of gradients, 48 closest points", rust, "gradients", tolerance=DIFFERENCES)
    ours("central differences of values, 1153 closest points", rust, "values", tolerance=DIFFERENCES)

    # What the row form cannot be faster than.
    floor = workshop.compiled("floor", here / "floor.c", "floor")
    for layout in ["full", "upper"]:
        for task in "AB":
            if floor:
                add(task, "floor", gcc, cxx.replace("g++", "gcc"), layout, floor[f"floor_{TASK[task]}_{layout}"], "the rows' multiplications and stores alone; computes nothing", tolerance=None)
    return all_ways


def blocks(raw, task, way, crate):
    """What a way wrote, one array a pair and quantity in the full layout."""
    count = QUANTITIES[task]
    if way.read:
        full = np.zeros((way.together, 5, FULL))
        read = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p)(way.read.value)
        for k in range(way.together):
            read(raw.ctypes.data, k, full[k].ctypes.data)
        return list(full[:, :count])
    if way.layout == "four lanes":
        of = raw[: 4 * count * FULL].reshape(count, FULL, 4)
        return [of[:, :, k] for k in range(4)]
    if way.layout == "four lanes, half":
        of, full = raw[: 4 * count * HALF].reshape(count, HALF, 4), np.zeros((4, count, FULL))
        full[:, :, :32] = of[:, :32].transpose(2, 0, 1)
        h = full[:, :, 32:].reshape(4, count, 24, 24)
        h[:, :, *TRIANGLE] = of[:, 32:].transpose(2, 0, 1)
        h[:, :, *TRIANGLE[::-1]] = h[:, :, *TRIANGLE]
        return list(full)
    if way.layout == "full":
        return [raw[: count * FULL].reshape(count, FULL)]
    of, full = raw[: count * UPPER].reshape(count, UPPER), np.zeros((count, FULL))
    full[:, :32] = of[:, :32]
    h = full[:, 32:].reshape(count, 24, 24)
    h[:, :12, :12], h[:, 12:, 12:] = of[:, 32:176].reshape(count, 12, 12), of[:, 320:].reshape(count, 12, 12)
    h[:, :12, 12:] = of[:, 176:320].reshape(count, 12, 12)
    h[:, 12:, :12] = h[:, :12, 12:].transpose(0, 2, 1)
    return [full]


def off(got, right):
    """The largest difference in a gradient or Hessian, relative to its largest entry, and in a value."""
    worst = np.max(np.abs(got[:, 0] - right[:, 0]))
    for part in [slice(8, 32), slice(32, FULL)]:
        difference = np.max(np.abs(got[:, part] - right[:, part]), axis=1) / np.max(np.abs(right[:, part]), axis=1)
        worst = max(worst, np.max(difference)) if np.all(np.isfinite(difference)) else np.inf
    return float(worst) if np.isfinite(worst) else np.inf


class Pairs:
    """The pairs, drawn and kept by the crate."""

    def __init__(self, crate, driver, seed, count):
        stride = ctypes.c_size_t()
        draw = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_uint64, ctypes.c_size_t, ctypes.c_void_p)(crate["draw_cases"].value)
        self.first, self.count = draw(seed, count, ctypes.addressof(stride)), count
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


def check(way, pairs, right, crate):
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
            for k, got in enumerate(blocks(pairs.out, way.task, way, crate)):
                worst = max(worst, off(got, right(first + k)[: QUANTITIES[way.task]]))
        first += step
    return worst, spent / first


def timed_warm(pairs, way, first, count):
    """Nanoseconds a pair, after the same untimed unless that takes long."""
    if count > 8 and not callable(way.function):
        pairs.run(way, first, count)
    return pairs.run(way, first, count)


def main(given, here, root, build, flags, debian):
    started = time.time()
    cpu = max(os.sched_getaffinity(0))
    workshop = Workshop(here, build, flags)
    subprocess.run(["cargo", "build", "--release", "--manifest-path", here / "Cargo.toml", "--target-dir", build / "rust"], check=True)
    crate = Library(build / "rust" / "release" / "libpeers.so")
    driver = workshop.compiled("driver", here / "driver.c", "driver")
    pairs = Pairs(crate, driver, given.seed, given.pairs)
    all_ways = ways(workshop, crate, root, debian)
    all_ways += jax_ways(workshop, here, pairs)
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
        error, cost = check(way, pairs, right, crate)
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
            reference = timed_warm(pairs, references[way.task], first, min(max(count, 200), pairs.count - first))
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


def jax_ways(workshop, here, pairs):
    try:
        import jax_peer
    except ImportError as error:
        workshop.left_out.append({"method": "JAX", "reason": str(error)})
        return []
    return [Way(task, "JAX, jit(vmap)", jax_peer.VERSION, "AD of the explicit parts; XLA on one core, all pairs at once", "full", "",
                jax_peer.Task(task, pairs.dofs()), None, 1, EXACT) for task in "AB"]
