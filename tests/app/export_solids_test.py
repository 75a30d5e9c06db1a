"""Solids of linkages from outside: STEP read again by another program, STL by this one.

Run as: export_solids_test.py PROGRAM LIBRARY [READER], the built program, the folder of library problems, and the
program that reads STEP, without which the refusal of solids is what is tested.
"""

import json
import math
import re
import sys
import unittest

from drawn_outlines import area
from exported_linkages import distance_to_segment, LIBRARY
from exported_solids import READER, Solids
from wheel_files import gear

HOLE, WIDTH, THICKNESS, WASHER, CLEARANCE = 0.25, 0.5, 0.2, 0.02, 0.01  # of the shortest link


def hull_of(points):
    """The convex hull, counter-clockwise, by the chains of Andrew."""
    chain = []
    for ordered in (sorted(points), sorted(points, reverse=True)):
        start = len(chain)
        for p in ordered:
            while len(chain) - start >= 2 and area([chain[-2], chain[-1], p]) <= 0:
                chain.pop()
            chain.append(p)
        chain.pop()
    return chain


def plate_area(part, width, slot_width):
    """The rounded hull less holes and slots; None where these overlap."""
    spots = [(hole["at"], hole["diameter"] / 2) for hole in part["holes"]]
    ends = [tuple(slot[end]) for slot in part["slots"] for end in ("from", "to")]
    if len(part["slots"]) > 1 or any(distance_to_segment(at, *ends) < slot_width / 2 + radius
                                     for at, radius in spots if ends):
        return None
    hull = hull_of([tuple(at) for at, _ in spots] + ends)
    around = sum(math.dist(a, b) for a, b in zip(hull, hull[1:] + hull[:1])) if len(hull) > 1 else 0
    whole = (area(hull) if len(hull) > 2 else 0) + around * width / 2 + math.pi * (width / 2) ** 2
    for slot in part["slots"]:
        whole -= math.dist(slot["from"], slot["to"]) * slot_width + math.pi * (slot_width / 2) ** 2
    return whole - sum(math.pi * radius ** 2 for _, radius in spots)


@unittest.skipIf(READER is None, "built without OpenCASCADE")
class Linkages(Solids):
    NAMES = ["klann-leg", "shaper", "toggle-press", "scotch-yoke"]

    def sizes(self, result):
        links = json.loads((self.folder / self.export(result, "--format", "json")["files"][0]).read_text())["links"]
        least = min(length["length"] for link in links for length in link["lengths"])
        return {name: share * least for name, share in
                (("--hole", HOLE), ("--width", WIDTH), ("--thickness", THICKNESS), ("--washer", WASHER),
                 ("--clearance", CLEARANCE))}

    def test_plates_and_pins_have_the_volumes_and_places_of_the_parts(self):
        plates = pins = 0
        for name in self.NAMES:
            with self.subTest(name):
                result = self.result(LIBRARY / "analysis" / f"{name}.toml")
                sizes = self.sizes(result)
                options = [word for pair in sizes.items() for word in pair] + ["--length-unit", "mm"]
                flat = self.export(result, "--format", "json", "--parts", *options)
                parts = json.loads((self.folder / flat["files"][0]).read_text())
                document = self.export(result, "--format", "step", "--parts", *options)
                solids = self.read(document)["solids"]
                self.assertEqual([s["name"] for s in solids], [s["name"] for s in document["solids"]])
                by_name = {solid["name"]: solid for solid in solids}
                layer = sizes["--thickness"] + sizes["--washer"]
                for part in parts["parts"]:
                    solid, plane = by_name[part["name"]], part["plane"] - 1
                    self.assertAlmostEqual(solid["low"][2] / layer, plane, 3)
                    self.assertAlmostEqual((solid["high"][2] - plane * layer) / sizes["--thickness"], 1, 3)
                    expected = plate_area(part, sizes["--width"], sizes["--hole"] + sizes["--clearance"])
                    if expected is None:
                        continue
                    self.assertAlmostEqual(solid["volume"] / (expected * sizes["--thickness"]), 1, 8)
                    plates += 1
                # A pin stands in a hole or slot of each of its parts, whichever the position.
                for pin in parts["pins"]:
                    solid = by_name[f"pin {pin['name']}"]
                    (at,) = {tuple(round(x, 9) for x in one["at"]) for one in solid["cylinders"]}
                    self.assertAlmostEqual(solid["low"][2] / layer, min(pin["planes"]) - 1, 3)
                    self.assertAlmostEqual((solid["high"][2] - solid["low"][2]) / pin["length"], 1, 3)
                    for number in pin["parts"]:
                        held = [math.dist(one["at"], at) for one in by_name[number]["cylinders"]]
                        if not any(slot for part in parts["parts"] if part["name"] == number for slot in part["slots"]):
                            self.assertLess(min(held), 1e-6)
                    pins += 1
        self.assertGreaterEqual(plates, 15)
        self.assertGreaterEqual(pins, 20)

    def test_pins_are_where_the_linkage_has_its_joints_in_the_position(self):
        result = self.result(LIBRARY / "analysis" / "klann-leg.toml")
        for position in (77.5, 201):
            linkage = json.loads((self.folder / self.export(
                result, "--format", "json", "--position", position)["files"][0]).read_text())
            table = (self.folder / self.export(result, "--format", "csv", "--steps", 720)["files"][0]).read_text()
            rows = [row.split(",") for row in table.split()]
            row = dict(zip(rows[0], next(r for r in rows[1:] if abs(float(r[0]) - position) < 1e-9)))
            sizes = [word for pair in self.sizes(result).items() for word in pair]
            solids = {solid["name"]: solid for solid in self.read(self.export(
                result, "--format", "step", "--parts", *sizes, "--position", position,
                "--length-unit", "cm"))["solids"]}
            for joint in ("M", "C", "D", "E"):
                at = [10 * float(row[f"{joint}_{axis}"]) for axis in "xy"]
                self.assertLess(math.dist(solids[f"pin {joint}"]["cylinders"][0]["at"], at), 1e-6)
            for link in linkage["links"]:
                for length in link["lengths"]:
                    ends = [f"pin {length[end]}" for end in ("from", "to")]
                    if all(end in solids for end in ends):
                        apart = math.dist(*(solids[end]["cylinders"][0]["at"] for end in ends))
                        self.assertAlmostEqual(apart, 10 * length["length"], 6)

    def test_units_bearings_spacers_and_repeats(self):
        result = self.result(LIBRARY / "analysis" / "klann-leg.toml")
        options = ("--parts", "--bearing", "608", "--width", 30, "--thickness", 7, "--spacers", "--length-unit", "mm")
        self.assertIn("overlap", self.refusal(result, "--format", "step", *options))
        text = (LIBRARY / "analysis" / "klann-leg.toml").read_text()
        text = re.sub('title = .*', """title = "Kl\u00e4nn's \u03b2 1/2" """, text, count=1)
        result = self.result('length_unit = "in"\n' + text.replace('length_unit = "m"\n', ""))
        inches = ("--parts", "--hole", 0.05, "--width", 0.15, "--thickness", 0.05, "--spacers", "--format", "step")
        document = self.export(result, *inches)
        first = (self.folder / document["files"][0]).read_bytes()
        first.decode("ascii")
        assembly = self.read(document)
        self.assertEqual(assembly["name"], "Kl\u00e4nn's \u03b2 1/2")
        solids = assembly["solids"]
        for own, solid in zip(document["solids"], solids):
            self.assertAlmostEqual(solid["volume"] / (own["volume"] * 25.4 ** 3), 1, 9)
        self.export(result, *inches)
        self.assertEqual((self.folder / document["files"][0]).read_bytes(), first)

    def test_bearings_sit_in_their_links_and_spacers_between(self):
        text = (LIBRARY / "analysis" / "klann-leg.toml").read_text()
        result = self.result('length_unit = "m"\n' + re.sub("(?m)^length_unit.*", "", text))
        order = ("--parts", "--bearing", "608", "--width", 0.05, "--thickness", 0.007, "--spacers")
        parts = json.loads((self.folder / self.export(result, "--format", "json", *order)["files"][0]).read_text())
        planes = {part["name"]: part["plane"] for part in parts["parts"]}
        solids = self.read(self.export(result, "--format", "step", *order))["solids"]
        plates = {solid["name"]: solid for solid in solids}
        # ISO 15: 8, 22, 7 mm.
        bearings = [solid for solid in solids if solid["name"].startswith("bearing ")]
        for solid in bearings:
            self.assertAlmostEqual(solid["volume"], math.pi / 4 * (22 ** 2 - 8 ** 2) * 7, 6)
            link = solid["name"].split(" in ")[1]
            self.assertAlmostEqual(solid["low"][2], 7 * (planes[link] - 1), 6)
            seats = [hole["at"] for hole in plates[link]["cylinders"] if math.isclose(hole["radius"], 11)]
            self.assertLess(min(math.dist(seat, solid["cylinders"][0]["at"]) for seat in seats), 1e-6)
        self.assertEqual(len(bearings), next(row["quantity"] for row in parts["bill"] if row["item"] == "bearing"))
        spacers = [solid for solid in solids if solid["name"].startswith("spacer ")]
        rows = {row["name"]: row for row in parts["bill"] if row["item"] == "spacer"}
        for solid in spacers:
            row = rows[re.fullmatch(r"spacer (.*?)( \d+)?", solid["name"])[1]]
            self.assertAlmostEqual(solid["volume"], math.pi / 4 * ((1e3 * row["outside"]) ** 2 - 8 ** 2) * 7, 6)
            self.assertIn(round(solid["low"][2] / 7) + 1, row["layers"])
            pin = plates["pin " + row["name"]]["cylinders"][0]["at"]
            self.assertLess(math.dist(pin, solid["cylinders"][0]["at"]), 1e-6)
        self.assertEqual(len({solid["name"] for solid in spacers}), sum(row["quantity"] for row in rows.values()))
        self.assertGreaterEqual(len(bearings), 7)
        self.assertGreaterEqual(len(spacers), 1)

    def test_screws_and_washers_are_bodies(self):
        """Volumes by hand; what is stacked on a pin touches and does not overlap."""
        text = (LIBRARY / "analysis" / "klann-leg.toml").read_text()
        result = self.result('length_unit = "m"\n' + re.sub("(?m)^length_unit.*", "", text))
        order = ("--parts", "--width", 0.03, "--thickness", 0.006)
        parts = json.loads((self.folder / self.export(result, "--format", "json", *order, "--screw", "M5")["files"][0]).read_text())
        planes = {part["name"]: part["plane"] for part in parts["parts"]}
        lengths = {row["name"]: 1e3 * row["length"] for row in parts["bill"] if row["item"] == "screw"}
        solids = {solid["name"]: solid for solid in self.read(self.export(result, "--format", "step", *order, "--screw", "M5"))["solids"]}
        for pin in parts["pins"]:
            name = pin["name"]
            screw, nut = solids[f"screw {name}"], solids[f"nut {name}"]
            self.assertAlmostEqual(screw["volume"], math.pi / 4 * (5 ** 2 * lengths[name] + 8.5 ** 2 * 5), 6)
            self.assertAlmostEqual(nut["volume"], (math.sqrt(3) / 2 * 8 ** 2 - math.pi / 4 * 5 ** 2) * 6.8, 6)
            washers = [solid for solid in solids.values() if solid["name"].startswith(f"washer {name} ")]
            self.assertEqual(len(washers), pin["planes"][1] - pin["planes"][0] + 2)
            for washer in washers:
                self.assertAlmostEqual(washer["volume"], math.pi / 4 * (10 ** 2 - 5.3 ** 2), 6)
            stacked = [(solid["low"][2], solid["high"][2]) for solid in (*washers, *(solids[part] for part in pin["parts"]))]
            crossed = pin["planes"][1] - pin["planes"][0] + 1 - len(pin["parts"])
            faces = sorted(stacked)
            self.assertAlmostEqual(faces[0][0] - screw["low"][2], 5, 3)
            self.assertAlmostEqual(faces[-1][1], nut["low"][2], 3)
            gaps = [above[0] - below[1] for below, above in zip(faces, faces[1:])]
            self.assertEqual(sum(gap > 1e-3 for gap in gaps), crossed)
            self.assertGreater(min(gaps), -1e-3)
        chosen = self.read(self.export(result, "--format", "step", *order, "--hole", 0.005, "--washer", "0.001x0.012"))["solids"]
        rings = [solid for solid in chosen if solid["name"].startswith("washer ")]
        self.assertEqual(len(rings), sum(pin["planes"][1] - pin["planes"][0] for pin in parts["pins"]))
        for ring in rings:
            self.assertAlmostEqual(ring["volume"], math.pi / 4 * (12 ** 2 - 5 ** 2), 6)
        # A boss leaves one washer in its gap.
        bossed = self.export(result, "--format", "step", *order, "--hole", 0.005, "--washer", "0.001x0.012", "--boss", 0.008, "--bill")
        (bill,) = [file for file in bossed["files"] if file.endswith(".csv")]
        rows = [row.split(",") for row in (self.folder / bill).read_text().split()]
        for pin in parts["pins"]:
            (row,) = [row for row in rows if row[:2] == ["washer", pin["name"]]]
            self.assertEqual(int(row[2]), len({planes[part] for part in pin["parts"]}) - 1)

    def test_bosses_fill_what_pins_cross(self):
        """Each plate has the volume of the tubes between it and the next plate of its pins more than without."""
        text = (LIBRARY / "analysis" / "klann-leg.toml").read_text()
        result = self.result('length_unit = "m"\n' + re.sub("(?m)^length_unit.*", "", text))
        hole, thickness, washer = 0.008, 0.007, 0.001
        order = ("--parts", "--hole", hole, "--width", 0.03, "--thickness", thickness, "--washer", washer)
        parts = json.loads((self.folder / self.export(result, "--format", "json", *order)["files"][0]).read_text())
        planes = {part["name"]: part["plane"] for part in parts["parts"]}
        spacer = next(row for row in parts["bill"] if row["item"] == "spacer")
        boss = spacer["outside"]
        plain = {solid["name"]: solid for solid in self.read(self.export(result, "--format", "step", *order))["solids"]}
        made = self.read(self.export(result, "--format", "step", *order, "--boss", boss))["solids"]
        self.assertEqual({solid["name"] for solid in made}, set(plain))
        more = dict.fromkeys(plain, 0)
        ring = math.pi / 4 * (boss ** 2 - hole ** 2) * 1e9
        for pin in parts["pins"]:
            held = sorted(pin["parts"], key=planes.get)
            for low, high in zip(held, held[1:]):
                crossed = planes[high] - planes[low] - 1
                more[low] += crossed * (thickness + washer) * ring if crossed else 0
        self.assertGreater(sum(more.values()), 0)
        for solid in made:
            self.assertAlmostEqual(solid["volume"] - plain[solid["name"]]["volume"], more[solid["name"]], 3)
        self.assertIn("no more than the width", self.refusal(result, "--format", "step", *order, "--boss", 0.04))
        self.assertIn("no more than the width", self.refusal(result, "--format", "step", *order, "--boss", hole))
        self.assertIn("--spacers", self.refusal(result, "--format", "step", *order, "--boss", boss, "--spacers"))
        self.assertIn("is that of solids", self.refusal(result, "--format", "dxf", *order, "--boss", boss))
        # Between wide links there is room for slim bosses alone.
        wide = ("--format", "step", "--parts", "--hole", 0.02, "--width", 0.5, "--thickness", 0.1, "--boss")
        slim = float(re.search(r"would meet another part; one of (\S+) fits", self.refusal(result, *wide, 0.5))[1])
        self.assertTrue(0.02 < slim < 0.5, slim)
        self.export(result, *wide, slim)
        self.refusal(result, *wide, 1.3 * slim)

    def test_facets_are_closed_and_hold_the_volume(self):
        result = self.result(LIBRARY / "analysis" / "shaper.toml")
        sizes = [word for pair in self.sizes(result).items() for word in pair]
        document = self.export(result, "--format", "stl", "--parts", *sizes, "--length-unit", "mm")
        self.assertEqual(len(document["files"]), len(document["solids"]))
        for solid, text in zip(document["solids"], self.stl(document).values()):
            self.check_facets(text, solid["volume"], 3e-2)

    def test_what_is_wrong_is_said(self):
        result = self.result(LIBRARY / "analysis" / "crank-rocker.toml")
        parts = ("--parts", "--hole", 0.2, "--width", 0.5)
        for wrong, message in [
            ((), "expected --parts --hole D --width W --thickness T with it"),
            (parts, "expected --thickness T with it"),
            ((*parts, "--thickness", 1e-5), "solids from 0.01 mm to 1 km are allowed"),
            ((*parts, "--thickness", 1, "--kerf", 0.1), "--kerf: is that of a drawing; expected --format dxf, svg"),
            ((*parts, "--thickness", 1, "--sheet", "5x5"), "--sheet: is that of a drawing"),
            ((*parts, "--thickness", 1, "--chord-tolerance", 1), "--chord-tolerance"),
            ((*parts, "--thickness", 1, "--bore", 1), "is for gears and cams"),
            ((*parts, "--thickness", 1, "--position", "x"), "--position"),
            ((*parts, "--thickness", 1e9, "--length-unit", "m"), "to 1 km are allowed"),
        ]:
            self.assertIn(message, self.refusal(result, "--format", "step", *wrong))
        self.assertIn("--hub-length: is that of solids",
                      self.refusal(result, "--format", "dxf", *parts, "--hub-length", 3))


@unittest.skipIf(READER is not None, "built with OpenCASCADE")
class Without(Solids):
    def test_what_to_install_is_said(self):
        result = self.result(gear(20))
        self.assertIn("libocct-data-exchange-dev", self.refusal(result, "--format", "step", "--thickness", 5))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
