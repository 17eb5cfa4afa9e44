#!/usr/bin/env python3
"""Kernels of one's own as a program that `cargo xtask conform` can judge.

    cargo xtask conform -- python3 docs/adapters/ray.py
"""

import json
import math
import struct
import sys


def number(bits):
    """The float that travels as its bits."""
    return struct.unpack(">f" if len(bits) == 8 else ">d", bytes.fromhex(bits))[0]


def bits(x):
    return struct.pack(">d", x).hex()


def vector(three):
    return [number(x) for x in three]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def intersect_plane(o, d, q, n, tmin, tmax):
    """The kernel under test: replace it by yours."""
    cosine = dot(d, n)
    if cosine == 0 or not all(map(math.isfinite, o + d + q + n)):
        return None
    t = dot([q[i] - o[i] for i in range(3)], n) / cosine
    return t if tmin <= t <= tmax and math.isfinite(t) else None


def answer(request):
    kind, x = request["kind"], request["in"]
    if kind != "ray_plane" or request["prec"] != "f64":
        return {"unsupported": "Python's floats are f64, and here is a plane"}
    t = intersect_plane(
        vector(x["o"]), vector(x["d"]), vector(x["q"]), vector(x["n"]),
        number(x["tmin"]), number(x["tmax"]),
    )
    return {"out": {"t": None if t is None else bits(t)}}


for line in sys.stdin:
    request = json.loads(line)
    print(json.dumps({"id": request["id"], **answer(request)}), flush=True)
