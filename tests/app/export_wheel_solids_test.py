"""Solids of gears and cams from outside: STEP read again by another program, STL by this one.

Run as: export_wheel_solids_test.py PROGRAM LIBRARY [READER], the built program, the folder of library problems, and
the program that reads STEP, without which nothing is tested here.
"""

import json
import math
import sys
import unittest

from drawn_outlines import area
from exported_linkages import distance_to_segment, LIBRARY
from exported_solids import facets_of, READER, Solids
from wheel_files import gear, ROLLER_CAM


@unittest.skipIf(READER is None, "built without OpenCASCADE")
class Wheels(Solids):
    def test_gears_hold_the_area_of_their_teeth(self):
        for teeth, shift, bore, hub in [(17, 0.3, 8, 0), (35, 0, 20, 40), (9, 0.5, 0, 0)]:
            with self.subTest(teeth=teeth):
                result = self.result(gear(teeth, shift))
                fine = self.export(result, "--format", "json", "--chord-tolerance", 0.00005)
                drawn = json.loads((self.folder / fine["files"][0]).read_text())["gears"][0]
                expected = 12 * area([point[:2] for point in drawn["outline"]])
                options = ["--thickness", 12]
                if bore:
                    options += ["--bore", bore]
                    expected -= 12 * math.pi * bore ** 2 / 4
                if hub:
                    options += ["--hub", hub, "--hub-length", 30]
                    expected += 18 * math.pi * (hub ** 2 - bore ** 2) / 4
                (solid,) = self.read(self.export(result, "--format", "step", *options))["solids"]
                self.assertAlmostEqual(solid["volume"] / expected, 1, 5)
                self.assertAlmostEqual(solid["high"][2], 30 if hub else 12, 3)
                facets = self.export(result, "--format", "stl", *options)
                self.check_facets(*self.stl(facets).values(), expected, 2e-3)

    def test_a_keyway_is_cut_through_the_hub(self):
        result = self.result(gear(35))
        plain, keyed = (self.read(self.export(result, "--format", "step", "--thickness", 12, "--bore", 20, "--hub", 40,
                                              "--hub-length", 30, *more))["solids"][0]["volume"]
                        for more in ((), ("--keyway",)))
        # DIN 6885 for 20 mm: 6 wide, 2.8 into the hub.
        radius, half = 10, 3
        foot = math.sqrt(radius ** 2 - half ** 2)
        segment = radius ** 2 * math.asin(half / radius) - half * foot
        self.assertAlmostEqual(plain - keyed, 30 * (6 * (12.8 - foot) - segment), 6)

    def test_a_pair_stands_in_mesh_and_a_ring_has_its_rim(self):
        result = self.result(LIBRARY / "gear-pair" / "internal.toml", "solve")
        document = self.export(result, "--format", "step", "--thickness", 8)
        self.assertTrue(any("rim of the ring" in note for note in document["notes"]))
        self.assertTrue(any("no unit of length" in note for note in document["notes"]))
        pinion, wheel = self.read(document)["solids"]
        gears = json.loads((self.folder / self.export(result, "--format", "json", "--chord-tolerance", 1e-4)
                            ["files"][0]).read_text())["gears"]
        reach = gears[1]["root_radius"] + 2 * gears[1]["transverse_module"]
        teeth = [area([point[:2] for point in gear["outline"]]) for gear in gears]
        self.assertAlmostEqual(pinion["volume"] / (8 * teeth[0]), 1, 4)
        self.assertAlmostEqual(wheel["volume"] / (8 * (math.pi * reach ** 2 - abs(teeth[1]))), 1, 4)
        centre = [(low + high) / 2 for low, high in zip(wheel["low"], wheel["high"])]
        self.assertLess(math.dist(centre[:2], gears[1]["centre"]), 1e-5)

    def screws(self, result, options, width, turns):
        """The solids of helical gears: each section from the lowest on turned by so much more about its centre."""
        fine = self.export(result, "--format", "json", "--chord-tolerance", 3e-5)
        drawn = json.loads((self.folder / fine["files"][0]).read_text())["gears"]
        document = self.export(result, "--format", "step", *options)
        for own, solid, gear, turn in zip(document["solids"], self.read(document)["solids"], drawn, turns, strict=True):
            self.assertAlmostEqual(solid["volume"] / (width * area([point[:2] for point in gear["outline"]])), 1, 5)
            self.assertAlmostEqual(own["twist_deg"], math.degrees(turn), 9)
            ends = {round(at[2], 6): [] for at in solid["vertices"]}
            self.assertEqual(sorted(ends), [0, width])
            for x, y, z in solid["vertices"]:
                ends[round(z, 6)].append(complex(x, y) - complex(*gear["centre"]))
            self.assertEqual(len(ends[0]), len(ends[width]))
            self.assertEqual(len(ends[0]) % gear["teeth"], 0)
            for at in ends[0]:
                turned = at * complex(math.cos(turn), math.sin(turn))
                self.assertLess(min(abs(turned - other) for other in ends[width]), 1e-6)

    def spur_text(self, tolerance, width):
        """The facets of the same teeth without a helix."""
        file = self.folder / "spur.toml"
        file.write_text('kind = "gear"\nlength_unit = "mm"\nmechanism = {teeth = 9, module = 2, profile_shift = 0.45}\n')
        (text,) = self.stl(self.export(self.result(file), "--format", "stl", "--thickness", width, "--chord-tolerance", tolerance)).values()
        return text

    def test_helical_teeth_are_screws(self):
        width, helix = 14, math.radians(25)
        text = (f'kind = "{{kind}}"\nlength_unit = "mm"\nmechanism = {{{{gearing = "helical", teeth = {{teeth}}, module = 2, '
                f'helix_deg = -25, face_width = {width}, profile_shift = {{shift}}{{more}}}}}}\n')
        pair = self.result(text.format(kind="gear-pair", teeth=[10, 15], shift=[0.3, 0.2], more=", backlash = 0.05"), "solve")
        # The width is that of the file. A left-handed pinion turns clockwise on the way up, its wheel the other way.
        self.screws(pair, (), width, [-sign * width * math.sin(helix) / teeth for sign, teeth in ((1, 10), (-1, 15))])
        gear = self.result(text.format(kind="gear", teeth=9, shift=0.45, more=""))
        turn = -2 * width * math.sin(helix) / 9
        self.screws(gear, ("--thickness", 2 * width), 2 * width, [turn])
        # Facets, turned back by their height, lie on the outline.
        tolerance = 0.01
        (text,) = self.stl(self.export(gear, "--format", "stl", "--thickness", 2 * width, "--chord-tolerance",
                                       tolerance)).values()
        fine = self.export(gear, "--format", "csv", "--chord-tolerance", 1e-3)
        outline = [tuple(map(float, row.split(",")[:2])) for row in (self.folder / fine["files"][0]).read_text().split()[1:]]
        corners = [complex(x, y) * complex(math.cos(turn * z / 2 / width), -math.sin(turn * z / 2 / width))
                   for facet in facets_of(text)[::40] for x, y, z in facet if 0 < z < 2 * width]
        self.assertGreater(len(corners), 20)
        for at in corners:
            self.assertLess(min(distance_to_segment((at.real, at.imag), *edge)
                                for edge in zip(outline, outline[1:] + outline[:1])), 2e-3)
        # So do their middles within the tolerance, across which the normal is aslant by the helix. They are no more than
        # those of the same teeth without a helix in rows so low that a chord of the screw keeps the tolerance, twice.
        facets = facets_of(text)
        rows = abs(turn) / math.sqrt(4 * tolerance / max(abs(complex(*at)) for at in outline))
        self.assertLess(len(facets), 2 * rows * len(facets_of(self.spur_text(tolerance, 2 * width))))
        for (ax, ay, az), (bx, by, bz), (cx, cy, cz) in facets[::97]:
            z = (az + bz + cz) / 3
            at = complex(ax + bx + cx, ay + by + cy) / 3 * complex(math.cos(turn * z / 2 / width), -math.sin(turn * z / 2 / width))
            if 0 < z < 2 * width:
                off = min(distance_to_segment((at.real, at.imag), *edge) for edge in zip(outline, outline[1:] + outline[:1]))
                self.assertLess(off, 1.15 * tolerance + 1e-3)
        self.check_facets(text, 2 * width * area(outline), 5e-3)
        self.assertIn("allowed is once", self.refusal(gear, "--format", "step", "--thickness", 300))
        bored, plain = (self.read(self.export(gear, "--format", "step", *more))["solids"][0]["volume"]
                        for more in (("--bore", 5, "--hub", 11, "--hub-length", 20), ()))
        self.assertAlmostEqual(plain - bored, math.pi / 4 * (20 * 5 ** 2 - 6 * 11 ** 2), 5)

    def test_cams_hold_the_area_of_their_profile(self):
        cams = 0
        for more in ("", 'closure = "conjugate"'):
            result = self.result(ROLLER_CAM.format(more=more), "solve")
            document = self.export(result, "--format", "step", "--thickness", 6, "--bore", 10, "--hub", 24, "--hub-length", 9)
            solids = self.read(document)["solids"]
            table = self.export(result, "--format", "csv", "--chord-tolerance", 1e-5)
            profiles = [[tuple(map(float, row.split(",")[1:3])) for row in (self.folder / file).read_text().split()[1:]]
                        for file in table["files"]]
            self.assertEqual(len(solids), len(profiles))
            for i, (solid, profile) in enumerate(zip(solids, profiles)):
                expected = 6 * (abs(area(profile)) - math.pi * 25)
                if i + 1 == len(solids):
                    expected += 3 * math.pi * (144 - 25)
                self.assertAlmostEqual(solid["volume"] / expected, 1, 6)
                self.assertAlmostEqual(solid["low"][2], 6 * i, 3)
                cams += 1
        self.assertEqual(cams, 3)

    def test_what_is_wrong_is_said(self):
        result = self.result(gear(20))
        for wrong, message in [
            ((), "expected --thickness T with it"),
            (("--thickness", 5, "--hub", 30), "expected --hub-length L with it, more than the thickness 5"),
            (("--thickness", 5, "--hub", 30, "--hub-length", 4), "more than the thickness 5"),
            (("--thickness", 5, "--bore", 90), "--bore"),
            (("--thickness", 0), "--thickness"),
            (("--thickness", 5, "--kerf", 1), "--kerf"),
            (("--thickness", 5, "--hole", 1), "is that of parts"),
        ]:
            self.assertIn(message, self.refusal(result, "--format", "step", *wrong))
        cam = self.result(ROLLER_CAM.format(more='closure = "groove"'), "solve")
        self.assertIn("grooves", self.refusal(cam, "--format", "step", "--thickness", 5))
        self.assertIn("--curve", self.refusal(cam, "--format", "step", "--thickness", 5, "--curve", "pitch"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
