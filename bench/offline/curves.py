"""Curves of error over CPU time, for offline.py and rough.py: reading them, and drawing them as SVG."""
import math

COLOURS = {"tukor": "#c80", "tukor --samples": "#ca6", "Cycles": "#06c", "POV-Ray": "#292"}


def figure(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def cpu_at(points, error, column):
    """CPU seconds at which a curve of (CPU, errors...) reaches an error: a line in logarithms between the points around it.

    Below the first point's error that point's time, an upper bound; beyond the last, None.
    """
    points = sorted(points)
    if points[0][column] <= error:
        return points[0][0]
    for (c0, *_), (c1, *_), e0, e1 in ((a, b, a[column], b[column]) for a, b in zip(points, points[1:])):
        if e1 <= error < e0:
            return c0 * (c1 / c0) ** (math.log(e0 / error) / math.log(e0 / e1))
    return None


def svg(panels):
    """`panels`: {title: {renderer: [(CPU, RMSE, relative MSE, RMSE in 8-bit sRGB)]}}; the last error over CPU, logarithmic."""
    width, height, parts = 300, 220, []
    for index, (title, curves) in enumerate(panels.items()):
        left, top = (index % 3) * width + 45, (index // 3) * height + 30
        w, h = width - 65, height - 65
        points = [p for rows in curves.values() for p in rows]
        ends = [(math.floor(10 * f(math.log10(p[i]) for p in points)) + o) / 10 for i in (0, 3) for f, o in ((min, 0), (max, 1))]
        x = lambda cpu: left + w * (math.log10(cpu) - ends[0]) / (ends[1] - ends[0])
        y = lambda error: top + h - h * (math.log10(error) - ends[2]) / (ends[3] - ends[2])
        parts.append(f'<text x="{left}" y="{top - 8}" font-weight="bold">{title}</text>'
                     f'<rect x="{left}" y="{top}" width="{w}" height="{h}" fill="none" stroke="#999"/>')
        ticks = [m * 10.0**e for e in range(-2, 4) for m in (1, 2, 5)]
        for t in ticks:
            if ends[0] <= math.log10(t) <= ends[1]:
                parts.append(f'<path d="M{x(t):.1f} {top}V{top + h}" stroke="#ddd"/><text x="{x(t):.1f}" y="{top + h + 12}" text-anchor="middle">{t:g}</text>')
            if ends[2] <= math.log10(t) <= ends[3]:
                parts.append(f'<path d="M{left} {y(t):.1f}h{w}" stroke="#ddd"/><text x="{left - 4}" y="{y(t) + 3:.1f}" text-anchor="end">{t:g}</text>')
        for name, rows in curves.items():
            line = " ".join(f"{x(p[0]):.1f},{y(p[3]):.1f}" for p in sorted(rows))
            parts.append(f'<polyline fill="none" stroke="{COLOURS[name]}" stroke-width="1.5" points="{line}"/>')
            parts += [f'<circle cx="{x(p[0]):.1f}" cy="{y(p[3]):.1f}" r="2" fill="{COLOURS[name]}"/>' for p in rows]
    below = (len(panels) + 2) // 3 * height
    legend = "".join(f'<text x="{45 + 110 * i}" y="{below + 12}" fill="{c}">{n}</text>' for i, (n, c) in enumerate(COLOURS.items()))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {3 * width} {below + 22}" font-family="sans-serif" font-size="10">'
            f'<rect width="100%" height="100%" fill="#fff"/>{"".join(parts)}{legend}'
            f'<text x="520" y="{below + 12}">RMSE in 8-bit sRGB over CPU seconds</text></svg>\n')
