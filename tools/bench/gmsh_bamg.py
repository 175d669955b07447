#!/usr/bin/env python3
"""Plug-in of ../shared/bench/drive.py for the BAMG that is part of gmsh: DOMAIN.mesh BG.mesh BG.sol OUT.mesh

GMSH names the program. The time of gmsh counts, with what it reads and writes; that of the conversion to its formats does not.
"""
import os
import pathlib
import sys

import peer  # on PYTHONPATH: ../shared/bench/plugins


def loops(edges):
    """The closed chains that the edges form, as lists of indices of edges in order; edges come as (a, b, label)."""
    following = {a: index for index, (a, b, _) in enumerate(edges)}
    left = set(range(len(edges)))
    while left:
        chain = [min(left)]
        while edges[chain[-1]][1] != edges[chain[0]][0]:
            chain.append(following[edges[chain[-1]][1]])
        left -= set(chain)
        yield chain


def geometry(xs, ys, edges):
    """The domain in gmsh's language."""
    lines = [f"Point({i + 1}) = {{{x!r}, {y!r}, 0}};" for i, (x, y) in enumerate(zip(xs, ys))]
    lines += [f"Line({i + 1}) = {{{a + 1}, {b + 1}}};" for i, (a, b, _) in enumerate(edges)]
    chains = list(loops(edges))
    for k, chain in enumerate(chains):
        lines.append(f"Curve Loop({k + 1}) = {{{', '.join(str(i + 1) for i in chain)}}};")
    lines.append(f"Plane Surface(1) = {{{', '.join(str(k + 1) for k in range(len(chains)))}}};")
    for label in sorted({label for _, _, label in edges}):
        members = ", ".join(str(i + 1) for i, edge in enumerate(edges) if edge[2] == label)
        lines.append(f"Physical Curve({label}) = {{{members}}};")
    lines.append("Physical Surface(1) = {1};")
    return "\n".join(lines) + "\n"


def view(xs, ys, triangles, metrics):
    """The metric in gmsh's language, a tensor at each corner of each triangle."""
    tensors = [f"{a!r},{b!r},0,{b!r},{c!r},0,0,0,1" for a, b, c in metrics]
    lines = ['View "metric" {']
    for corners in triangles:
        places = ",".join(f"{xs[v]!r},{ys[v]!r},0" for v in corners)
        lines.append(f"TT({places}){{{','.join(tensors[v] for v in corners)}}};")
    return "\n".join(lines) + "\n};\n"


def main():
    domain, background, metric, out = (os.path.abspath(path) for path in sys.argv[1:5])
    xs, ys, edges, _ = peer.read_mesh(domain)
    bx, by, _, triangles = peer.read_mesh(background)
    pathlib.Path(out + ".pos").write_text(view(bx, by, triangles, peer.read_sol(metric)))
    pathlib.Path(out + ".geo").write_text(
        geometry(xs, ys, edges) + f'Merge "{out}.pos";\nField[1] = PostView;\nField[1].ViewIndex = 0;\n'
        "Background Field = 1;\nMesh.Algorithm = 7;\nMesh.MeshSizeExtendFromBoundary = 0;\n"
        "Mesh.MeshSizeFromPoints = 0;\nMesh.SaveElementTagType = 2;\n")
    made = out + ".gmsh.mesh"
    status = peer.timed([os.environ.get("GMSH", "gmsh"), "-2", "-nt", "1", out + ".geo", "-o", made], out)
    if status == 0:
        peer.write_mesh(out, *peer.read_mesh(made))
    for suffix in (".pos", ".geo", ".gmsh.mesh"):
        pathlib.Path(out + suffix).unlink(missing_ok=True)
    return status


if __name__ == "__main__":
    sys.exit(main())
