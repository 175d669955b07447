#!/usr/bin/env python3
"""Checks who includes whom: mesher <- fem <- adapt <- tools, third-party libraries per module, no include cycles."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')

# Which prefixes a file below the folder may include with quotes, and which third-party ones in angle brackets.
PROJECT = {
    "mesher": ("mesher/",),
    "fem": ("fem/",),  # and what FEM_READS_OF_MESHER gives
    "adapt": ("adapt/", "fem/", "mesher/"),
    "tools": ("tools/", "adapt/", "fem/", "mesher/"),
}
FEM_READS_OF_MESHER = ("mesher/mesh.h", "mesher/errors.h", "mesher/cracks.h", "mesher/disjoint_sets.h",
                       "mesher/edge_finder.h", "mesher/number_text.h", "mesher/parallel.h",
                       "mesher/geometry/symmetric_tensor.h")
LIBRARIES = {
    "mesher": ("Eigen/", "omp.h"),
    "fem": ("Eigen/", "omp.h"),
    "adapt": ("Eigen/", "omp.h", "nlohmann/", "zlib.h", "cairo.h"),
    "tools": ("Eigen/", "omp.h", "nlohmann/", "CLI/", "CGAL/", "benchmark/"),
}
POSIX = re.compile(r"^(sys/\w+|fcntl|unistd|signal|dirent|poll|malloc)\.h$")


def includes(path):
    """The (line, bracket, name) of each include of a file."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if match := INCLUDE.match(line):
            yield number, match[1], match[2]


def closure(names):
    """The project's headers that these ones include, themselves among them."""
    found, pending = set(), list(names)
    while pending:
        name = pending.pop()
        if name not in found and (ROOT / name).is_file():
            found.add(name)
            pending += [inner for _, bracket, inner in includes(ROOT / name) if bracket == '"']
    return found


def is_standard(name):
    """Headers of the C++ library and of the operating system."""
    return re.fullmatch(r"[a-z_0-9]+", name) or POSIX.match(name)


def wrong_includes(module, path, allowed_extra):
    """What is wrong with the includes of one file, one sentence each."""
    where = path.relative_to(ROOT)
    for number, bracket, name in includes(path):
        if bracket == '"':
            if not name.startswith(PROJECT[module]) and name not in allowed_extra:
                yield f'{where}:{number}: {module} may not include "{name}"'
            elif not (ROOT / name).is_file():
                yield f'{where}:{number}: "{name}" does not exist (paths start at the root)'
        elif not is_standard(name) and not name.startswith(LIBRARIES[module]):
            yield f"{where}:{number}: {module} may not include <{name}>"


def component(name):
    """A header and the source of its name are one: what either includes, the pair needs."""
    return str(pathlib.PurePath(name).with_suffix(""))


def cycle(graph):
    """A cycle of the include graph as a list of names, or None."""
    state, path = {}, []

    def visit(name):
        state[name] = "open"
        path.append(name)
        for inner in graph.get(name, ()):
            if state.get(inner) == "open":
                return path[path.index(inner):] + [inner]
            if inner not in state and (found := visit(inner)):
                return found
        path.pop()
        state[name] = "done"
        return None

    return next((found for name in graph if name not in state and (found := visit(name))), None)


def main():
    problems, graph, num_files = [], {}, 0
    fem_extra = closure(FEM_READS_OF_MESHER)
    for module in PROJECT:
        for path in sorted((ROOT / module).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            problems += wrong_includes(module, path, fem_extra if module == "fem" else ())
            num_files += 1
            own = component(path.relative_to(ROOT))
            inner = {component(name) for _, bracket, name in includes(path) if bracket == '"'}
            graph.setdefault(own, []).extend(sorted(inner - {own}))
    if found := cycle(graph):
        problems.append("include cycle: " + " -> ".join(found))
    print("\n".join(problems) if problems else f"{num_files} files, no wrong include")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
