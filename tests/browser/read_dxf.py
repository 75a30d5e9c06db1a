"""A drawing as ezdxf reads it, as JSON: its faults, its unit and its shapes; null without ezdxf.

Run as: read_dxf.py FILE
"""

import json
import sys

try:
    import ezdxf
except ImportError:
    print("null")
    sys.exit()


def shape(entity):
    one = {"type": entity.dxftype(), "layer": entity.dxf.layer}
    if one["type"] == "POLYLINE":
        one.update(points=[list(at)[:2] for at in entity.points()], closed=entity.is_closed)
    elif one["type"] == "LWPOLYLINE":
        one.update(points=[list(at) for at in entity.get_points("xy")], closed=entity.closed)
    elif one["type"] == "CIRCLE":
        one.update(at=list(entity.dxf.center)[:2], radius=entity.dxf.radius)
    elif one["type"] == "TEXT":
        one.update(at=list(entity.dxf.insert)[:2], text=entity.dxf.text)
    return one


document = ezdxf.readfile(sys.argv[1])
json.dump({"faults": [str(error.message) for error in document.audit().errors],
           "shapes": [shape(entity) for entity in document.modelspace()]}, sys.stdout)
