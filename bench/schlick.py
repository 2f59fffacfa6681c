#!/usr/bin/env python3
"""How far Schlick's approximation, which rough metals follow, is from the reflectance of their measured index: the largest
difference over angles, where it is, the largest up to 60 degrees, and that of the mean over the hemisphere.

usage: schlick.py BUILD
"""
import cmath
import json
import math
import subprocess
import sys


def exact(cosine, index):
    """Of unpolarised light, by complex amplitudes."""
    inside = cmath.sqrt(1 - (1 - cosine * cosine) / index ** 2)
    s = (cosine - index * inside) / (cosine + index * inside)
    p = (index * cosine - inside) / (index * cosine + inside)
    return 0.5 * (abs(s) ** 2 + abs(p) ** 2)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    text = subprocess.run([f"{sys.argv[1]}/apps/tukor/tukor", "materials", "--json"], check=True, capture_output=True, text=True).stdout
    print("| metal | largest difference | at degrees | up to 60 degrees | in uniform light |\n|---|---|---|---|---|")
    for row in json.loads(text):
        if "k" not in row or not any(row["k"]):
            continue
        worst, at, near, uniform = 0.0, 0.0, 0.0, 0.0
        for eta, k in zip(row["eta"], row["k"]):
            index, mean = complex(eta, k), 0.0
            normal = exact(1.0, index)
            for step in range(900):
                angle = math.radians((step + 0.5) / 10)
                cosine = math.cos(angle)
                off = normal + (1 - normal) * (1 - cosine) ** 5 - exact(cosine, index)
                mean += off * 2 * cosine * math.sin(angle) * math.radians(0.1)
                if abs(off) > worst:
                    worst, at = abs(off), math.degrees(angle)
                if step < 600:
                    near = max(near, abs(off))
            uniform = max(uniform, abs(mean))
        print(f"| {row['name']} | {worst:.3f} | {at:.0f} | {near:.3f} | {uniform:.3f} |")


if __name__ == "__main__":
    main()
