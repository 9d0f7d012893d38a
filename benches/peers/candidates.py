"""All candidates, and the layout of the result of each."""

import collections
import ctypes
import importlib.metadata
import itertools
import re
import sys

import numpy as np
from workshop import package, version_of

# Blocks of the layouts, in numbers; see peer.h and lanes.cpp.
FULL, UPPER, HALF = 608, 464, 332
TRIANGLE = np.triu_indices(24)
QUANTITIES = {"A": 1, "B": 5}
TASK = {"A": "d", "B": "all"}
# A candidate with a larger error than this, relative to the largest entry, is rejected.
EXACT, DIFFERENCES = 1e-9, 1e-2

Candidate = collections.namedtuple("Candidate", "task method version how layout note function read together tolerance")


def candidates(workshop, crate, root, debian, dofs):
    """All candidates, the reference of each task first."""
    gcc, here, build = version_of(["gcc", "-dumpfullversion"]), workshop.here, workshop.build
    flags = " ".join(f for f in workshop.flags if f not in ("-fPIC", "-shared"))
    rustc = version_of(["rustc", "--version"]).split()[1]
    beamgap = re.search(r'^version = "(.*)"', (root / "Cargo.toml").read_text(), re.M)[1]
    all_candidates = []

    def add(task, method, version, how, layout, function, note="", read=None, together=1, tolerance=EXACT):
        all_candidates.append(Candidate(task, method, version, how, layout, note, function, read, together, tolerance))

    def both(method, version, how, library, name, layout="full", note=""):
        for task in "AB":
            if library:
                add(task, method, version, how, layout, library[f"{name}_{TASK[task]}_{layout}"], note)

    def ours(method, how, name, layouts=None, note="", together=1, tolerance=EXACT, tasks="AB", shown="upper"):
        for task in tasks:
            for layout in layouts or [None]:
                function = f"{name}_{TASK[task]}" + (f"_{layout}" if layout else "")
                read = crate[f"{function}_read"]
                add(task, method, beamgap, how, layout or shown, crate[function], note, read, together, tolerance)

    cxx = f"g++ {gcc} {flags}"
    reference = workshop.compiled("C++ with AVX2, by hand", here / "reference.cpp", "reference")
    for layout in ["full", "upper"]:
        both("C++ with AVX2, by hand", gcc, cxx, reference, "ref", layout, "the reference" if layout == "full" else "")
    method = "C++ with AVX2, by hand, four pairs in lanes"
    lanes = workshop.compiled(method, here / "lanes.cpp", "lanes")
    for task in "AB" if lanes else "":
        add(task, method, gcc, cxx, "four lanes, half", lanes[f"lanes_{TASK[task]}_half"], together=4)
    native = ["-O3", "-march=native", "-fno-math-errno"]
    text = workshop.compiled("plain C, textbook form", here / "textbook.c", "textbook", flags=[*native, "-fPIC", "-shared"])
    both("plain C, textbook form", gcc, f"gcc {gcc} {' '.join(native)}", text, "text")

    rust = f"rustc {rustc} --release, default target"
    ours("beamgap, blocks", rust + ", AVX2 at run time", "blocks", ["full", "upper"])
    ours("beamgap, four pairs in lanes", rust + ", AVX2 at run time", "four", together=4, tasks="A", shown="four lanes, half")
    ours("beamgap, linearize", rust + ", AVX2 at run time", "linearize", note="with both slips", tasks="B")
    ours("beamgap, linearize into the caller's memory", rust + ", AVX2 at run time", "written", note="with both slips", tasks="B")
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
            options = dict(defines=[*defines, "-w"], libraries=["-lm"], generated=[generated])
            library = workshop.compiled(method, here / "casadi.c", function, **options)
            if library:
                add(task, method, casadi, f"generated C, cse; gcc {gcc} {flags}", "full", library[f"{function}_full"])
            by_four, function = f"{method}, four pairs in lanes", f"{function}_lanes"
            lanes = workshop.compiled(by_four, here / "casadi_lanes.cpp", function, **options)
            if lanes:
                add(task, by_four, casadi, f"the same over four lanes; {cxx}", "four lanes", lanes[function], together=4)
    for task in "AB":
        source = build / f"sympy_{TASK[task]}.c"
        if source.exists():
            library = workshop.compiled("SymPy with cse", source, f"sympy_{TASK[task]}", libraries=["-lm"])
            if library:
                sympy, function = importlib.metadata.version("sympy"), library[f"sympy_{TASK[task]}_full"]
                add(task, "SymPy with cse", sympy, f"generated C; gcc {gcc} {flags}", "full", function)

    # Automatic differentiation in C++.
    for peer, source in [("Eigen", "autodiff_eigen.cpp"), ("Sacado", "autodiff_sacado.cpp")]:
        version = package(debian[peer][0])
        if not version:
            workshop.left_out.append({"method": peer, "reason": f"{debian[peer][0]} is not installed"})
            continue
        includes, libraries = ["-I/usr/include/eigen3", "-w"], []
        if peer == "Sacado":
            mpi = version_of(["mpicxx", "--showme:compile"]).split()
            includes = ["-I/usr/include/trilinos", "-DOMPI_SKIP_MPICXX", *mpi, "-w"]
            libraries = [f"-ltrilinos_teuchos{part}" for part in ["comm", "parameterlist", "core"]]
        library = workshop.compiled(peer, here / source, source.split(".")[0], includes, libraries=libraries)
        names = {"Eigen": "AutoDiffScalar, nested", "Sacado": "SFad, nested"}
        both(f"{peer}, {names[peer]}", version, f"A one chord step, B two; {cxx}", library, peer.lower())

    workshop.left_out.append({"method": "CppAD", "reason": "Debian 12 has no package of it"})

    # Automatic differentiation and differences of this crate.
    num_dual = re.search(r'name = "num-dual"\nversion = "(.*)"', (here / "Cargo.lock").read_text())[1]
    swept = f"num-dual {num_dual}, hyper-dual sweep"
    ours(f"{swept}, chord", rust + "; A one chord step, B two", "chord")
    ours(f"{swept}, Newton", rust + "; implicit_derivative_binary", "newton")
    ours(f"{swept}, stationary", rust + "; implicit_derivative_sp", "stationary")
    ours(f"num-dual {num_dual}, Dual2SVec64<24>, chord", rust + "; A one chord step, B two", "vector")
    ours("beamgap, rows of hyper-duals, by orders", rust + "; explicit parts and the implicit function theorem", "orders")
    ours("central differences of gradients, 48 closest points", rust, "gradients", tolerance=DIFFERENCES)
    ours("central differences of values, 1153 closest points", rust, "values", tolerance=DIFFERENCES)

    # Lower bounds on the time of the row form.
    bound = workshop.compiled("lower bound", here / "bound.c", "bound")
    note = "the rows' products and stores alone; computes nothing"
    for task, layout in itertools.product("AB" if bound else "", ["full", "upper"]):
        add(task, "lower bound", gcc, f"gcc {gcc} {flags}", layout, bound[f"bound_{TASK[task]}_{layout}"], note, tolerance=None)

    try:
        import jax_peer
    except ImportError as error:
        workshop.left_out.append({"method": "JAX", "reason": str(error)})
        return all_candidates
    for task in "AB":
        how = "AD of the explicit parts; XLA on one core, all pairs at once"
        add(task, "JAX, jit(vmap)", jax_peer.VERSION, how, "full", jax_peer.Task(task, dofs))
    return all_candidates


def blocks(raw, candidate):
    """The result of a candidate: one array for each pair and quantity, in the full layout."""
    count = QUANTITIES[candidate.task]
    if candidate.read:
        full = np.zeros((candidate.together, 5, FULL))
        read = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p)(candidate.read.value)
        for k in range(candidate.together):
            read(raw.ctypes.data, k, full[k].ctypes.data)
        return list(full[:, :count])
    if candidate.layout == "four lanes":
        of = raw[: 4 * count * FULL].reshape(count, FULL, 4)
        return [of[:, :, k] for k in range(4)]
    if candidate.layout == "four lanes, half":
        of, full = raw[: 4 * count * HALF].reshape(count, HALF, 4), np.zeros((4, count, FULL))
        full[:, :, :32] = of[:, :32].transpose(2, 0, 1)
        h = full[:, :, 32:].reshape(4, count, 24, 24)
        h[:, :, *TRIANGLE] = of[:, 32:].transpose(2, 0, 1)
        h[:, :, *TRIANGLE[::-1]] = h[:, :, *TRIANGLE]
        return list(full)
    if candidate.layout == "full":
        return [raw[: count * FULL].reshape(count, FULL)]
    of, full = raw[: count * UPPER].reshape(count, UPPER), np.zeros((count, FULL))
    full[:, :32] = of[:, :32]
    h = full[:, 32:].reshape(count, 24, 24)
    h[:, :12, :12], h[:, 12:, 12:] = of[:, 32:176].reshape(count, 12, 12), of[:, 320:].reshape(count, 12, 12)
    h[:, :12, 12:] = of[:, 176:320].reshape(count, 12, 12)
    h[:, 12:, :12] = h[:, :12, 12:].transpose(0, 2, 1)
    return [full]
