"""Outlines of drawings as polygons, and distances between them, for tests of exports."""

import math


def arc_points(start, end, bulge, count=24):
    """Points of the arc of a DXF bulge, by its definition: tan of a quarter of the angle."""
    if bulge == 0:
        return [start]
    a, b = complex(*start), complex(*end)
    angle = 4 * math.atan(bulge)
    centre = (a + b) / 2 + 1j * (b - a) / (2 * math.tan(angle / 2)) if abs(bulge) != 1 else (a + b) / 2
    turn = [complex(math.cos(angle * i / count), math.sin(angle * i / count)) for i in range(count)]
    return [((centre + (a - centre) * t).real, (centre + (a - centre) * t).imag) for t in turn]


def corners_of(entity):
    """x, y and bulge of the corners of a polyline, of any version of DXF."""
    if entity.dxftype() == "LWPOLYLINE":
        return [(x, y, bulge) for x, y, _, _, bulge in entity.get_points()]
    return [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0)) for v in entity.vertices]


def outline_of(entity, count=24):
    """The polygon of a closed polyline with bulges, or of a circle."""
    if entity.dxftype() == "CIRCLE":
        x, y, _ = entity.dxf.center
        radius = entity.dxf.radius
        steps = 3 * count
        return [(x + radius * math.cos(2 * math.pi * i / steps), y + radius * math.sin(2 * math.pi * i / steps))
                for i in range(steps)]
    points = corners_of(entity)
    polygon = []
    for (x, y, bulge), (nx, ny, _) in zip(points, points[1:] + points[:1]):
        polygon += arc_points((x, y), (nx, ny), bulge, count)
    return polygon


def sides(polygon):
    return list(zip(polygon, polygon[1:] + polygon[:1]))


def box(polygon):
    xs, ys = zip(*polygon)
    return min(xs), min(ys), max(xs), max(ys)


def area(polygon):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in sides(polygon)) / 2


def around(polygon):
    return sum(math.dist(a, b) for a, b in sides(polygon))


def holds(polygon, point):
    """Whether a polygon holds a point: an odd number of its sides is passed on the way out."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in sides(polygon):
        if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
            inside = not inside
    return inside


def to_side(p, a, b):
    ux, uy, px, py = b[0] - a[0], b[1] - a[1], p[0] - a[0], p[1] - a[1]
    square = ux * ux + uy * uy
    share = min(1, max(0, (px * ux + py * uy) / square)) if square else 0
    return math.hypot(px - share * ux, py - share * uy)


def distance_to(polygon, point):
    return min(to_side(point, a, b) for a, b in sides(polygon))


def apart(one, other):
    """The least distance of two polygons that do not cross: it is at a corner of one of them."""
    return min(min(distance_to(other, p) for p in one), min(distance_to(one, p) for p in other))
