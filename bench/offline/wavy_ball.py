#!/usr/bin/env python3
"""A wavy ball as a binary PLY with normals, the same surface at every number of triangles: wavy_ball.py TRIANGLES OUT.ply

needs: tools/install_packages.sh bench
"""
import pathlib
import sys

import numpy


def write(path, triangles):
    rows = round((triangles / 4) ** 0.5)
    columns = 2 * rows
    theta = numpy.linspace(1e-4, numpy.pi - 1e-4, rows + 1)[:, None]
    phi = numpy.linspace(0, 2 * numpy.pi, columns, endpoint=False)[None, :]
    angles = 5 * theta, 6 * phi
    r = 1 + 0.06 * numpy.sin(theta) ** 2 * numpy.sin(angles[0]) * numpy.cos(angles[1])
    by_theta = 0.06 * numpy.cos(angles[1]) * (2 * numpy.sin(theta) * numpy.cos(theta) * numpy.sin(angles[0])
                                              + 5 * numpy.sin(theta) ** 2 * numpy.cos(angles[0]))
    by_phi = -6 * 0.06 * numpy.sin(theta) ** 2 * numpy.sin(angles[0]) * numpy.sin(angles[1])
    zero = 0 * (theta + phi)
    outward = numpy.stack([numpy.sin(theta) * numpy.cos(phi), numpy.cos(theta) + zero, numpy.sin(theta) * numpy.sin(phi)], -1)
    south = numpy.stack([numpy.cos(theta) * numpy.cos(phi), -numpy.sin(theta) + zero, numpy.cos(theta) * numpy.sin(phi)], -1)
    east = numpy.stack([-numpy.sin(phi) + zero, zero, numpy.cos(phi) + zero], -1)
    normals = outward - south * (by_theta / r)[..., None] - east * (by_phi / r / numpy.sin(theta))[..., None]
    normals /= numpy.linalg.norm(normals, axis=-1, keepdims=True)
    vertices = numpy.concatenate([outward * r[..., None], normals], -1).astype("<f4").reshape(-1, 6)
    # At each pole all vertices are one place, so that the ball is closed.
    vertices[:columns] = [0, 1, 0, 0, 1, 0]
    vertices[-columns:] = [0, -1, 0, 0, -1, 0]
    at = numpy.arange(rows * columns).reshape(rows, columns)
    a, b = at.ravel(), numpy.roll(at, -1, axis=1).ravel()
    corners = numpy.concatenate([numpy.stack(t, -1) for t in ((a, b, b + columns), (a, b + columns, a + columns))])
    corners = corners[(corners[:, 0] >= columns) | (corners[:, 1] >= columns)]  # no slivers at the poles
    corners = corners[(corners[:, 1] < rows * columns) | (corners[:, 2] < rows * columns)]
    faces = numpy.empty(len(corners), [("n", "u1"), ("corners", "<i4", 3)])
    faces["n"], faces["corners"] = 3, corners
    header = "ply\nformat binary_little_endian 1.0\n" + f"element vertex {len(vertices)}\n" + "".join(
        f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")) + \
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    partial = path.with_suffix(".partial")
    with open(partial, "wb") as out:
        out.write(header.encode())
        out.write(vertices.tobytes())
        out.write(faces.tobytes())
    partial.rename(path)


write(pathlib.Path(sys.argv[2]), int(sys.argv[1]))
