"""Builds the peers."""

import ctypes
import subprocess


class Library:
    """A shared library of functions in the form of peer.h."""

    def __init__(self, path):
        self.dll = ctypes.CDLL(str(path))

    def __getitem__(self, name):
        return ctypes.cast(self.dll[name], ctypes.c_void_p)


class Workshop:
    """The directory in which peers are built, and the list of those that could not be built."""

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
        """The library of one source file and its includes, if it compiles; built again if a file or the command changes."""
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


def package(name):
    """The version of a Debian package, or nothing."""
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else None
