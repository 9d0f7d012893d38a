#!/usr/bin/env python3
"""Puts faults into the source, one at a time, and tests which command sees each.

The faults are compiled with `--cfg beamgap_faults`, all in one build; the environment variable BEAMGAP_FAULT chooses one.
The build is that of the development profile, because an optimized one takes longer than the commands save.
"""
import os
import subprocess
import sys

TARGET = "target/source_faults"
BEAMGAP = f"{TARGET}/debug/beamgap"

# The fault, the command that must see it, and words of its output: the wrong layer and a wrong function.
CHECK = ["check", "--cases", "121", "--all"]
SEARCH = ["check", "--cases", "242", "--all"]
VERIFY = ["verify", f"{TARGET}/cases.jsonl", "--run", f"{BEAMGAP} evaluate", "--no-explanation"]
ELEMENT = ["verify", f"{TARGET}/elements.jsonl", "--run", f"{BEAMGAP} evaluate", "--no-explanation"]
PROVE = ["prove", "--draws", "64"]
BOUNDS = ["bounds", "--cases", "60"]
FAULTS = ["faults", "--regime", "generic"]
KERNEL = "wrong layer: this function or the kernel"
EXPECTED = [
    # The kernel
    ("last-of-odd-row", CHECK, 1, [KERNEL, "9 + "]),
    ("fourth-vector", CHECK, 1, [KERNEL, "12"]),
    ("remainder-of-15", CHECK, 1, [KERNEL, "15 + 12 dofs"]),
    ("bend-of-12-and-18", CHECK, 1, [KERNEL, "linearize, 12 + 18 dofs"]),
    ("full-of-unequal", CHECK, 1, [KERNEL, "full"]),
    ("parameter-of-lane", CHECK, 1, [KERNEL, "write_d_batch"]),
    ("rest-of-batch", CHECK, 1, [KERNEL, "write_d_batch of"]),
    ("normal-of-lane", CHECK, 1, [KERNEL, "write_d_batch"]),
    ("radius-twice", CHECK, 1, [KERNEL, "g_N", "linearize"]),
    ("bend-of-12-and-18", PROVE, 1, ["kernel, blocks of 12 + 18"]),
    ("full-of-unequal", PROVE, 1, ["kernel, full"]),
    ("normal-with-determinants", PROVE, 1, ["kernel, blocks"]),
    ("last-of-odd-row", BOUNDS, 5, ["kernel"]),
    ("rest-of-batch", BOUNDS, 5, ["kernel"]),
    # Equations, matrices, curves, automatic differentiation
    ("sign-in-53", CHECK, 1, ["wrong layer: the equations", "look at"]),
    ("sign-of-beta", CHECK, 1, ["wrong layer: the matrices"]),
    ("half-of-vector", CHECK, 1, ["Matrices::vector"]),
    ("jet-of-lagrange", CHECK, 1, ["wrong layer: the equations, or the jets"]),
    ("slope-by-orders", CHECK, 1, ["wrong layer: this function", "expand_by_orders"]),
    # The contact element
    ("sign-of-grad-c", CHECK, 1, ["contact::"]),
    ("gamma-without-angle", CHECK, 1, ["contact::"]),
    ("sign-of-grad-c", PROVE, 1, ["contact element, stick: tangent"]),
    ("gamma-without-angle", PROVE, 1, ["contact element, slip: tangent"]),
    ("sign-of-grad-c", ELEMENT, 1, ["tangent"]),
    ("gamma-without-angle", ELEMENT, 1, ["tangent"]),
    # The search
    ("bound-of-first-dof", SEARCH, 1, ["search"]),
    ("end-forgotten", SEARCH, 1, ["search"]),
    ("bar-start-of-beam", SEARCH, 1, ["search"]),
    ("saddles-listed", SEARCH, 1, ["search"]),
    ("region-distance", SEARCH, 1, ["search"]),
    ("saddles-listed", VERIFY, 5, ["UNTRUSTED: the search"]),
    ("end-forgotten", VERIFY, 5, ["UNTRUSTED: the search"]),
    # The gate itself
    ("wide-tolerance", FAULTS, 5, ["NOT DETECTED"]),
    ("symmetry-left-out", FAULTS, 5, ["NOT DETECTED"]),
    ("functions-left-out", FAULTS, 5, ["NOT DETECTED"]),
    ("only-the-first", FAULTS, 5, ["NOT DETECTED"]),
]


def main():
    os.chdir(os.path.join(os.path.dirname(__file__), ".."))
    flags = {"RUSTFLAGS": "--cfg beamgap_faults", "CARGO_TARGET_DIR": TARGET}
    subprocess.run(["cargo", "build", "--locked"], env={**os.environ, **flags}, check=True)
    subprocess.run([BEAMGAP, "export", "--cases", "100", "--output", f"{TARGET}/cases.jsonl"], check=True)
    elements = ["--element", "--cases", "24", "--output", f"{TARGET}/elements.jsonl"]
    subprocess.run([BEAMGAP, "export", *elements], check=True)

    def run(fault, command):
        environment = {**os.environ, "BEAMGAP_FAULT": fault, "NO_COLOR": "1"}
        return subprocess.run([BEAMGAP, *command], env=environment, capture_output=True, text=True)

    unseen = []
    commands = {tuple(command) for _, command, _, _ in EXPECTED}
    unseen += [f"none: {' '.join(command)} fails" for command in commands if run("", command).returncode]
    for fault, command, status, words in EXPECTED:
        found = run(fault, command)
        missing = [word for word in words if word not in found.stdout]
        told = f"{fault}: {' '.join(command)} exits with {found.returncode}"
        if found.returncode != status or missing:
            unseen.append(f"{told}, {status} expected; its output lacks {missing}")
        print(told, flush=True)
    if unseen:
        sys.exit("NOT SEEN\n" + "\n".join(unseen))
    print(f"SEEN: each of {len({fault for fault, *_ in EXPECTED})} faults of the source.")


if __name__ == "__main__":
    main()
