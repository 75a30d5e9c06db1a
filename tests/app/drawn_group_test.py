"""Groups of more than two links in mechanisms that are given by their joints as drawn, against bodies under
constraints that know nothing of groups (linked_bodies.py), the same mechanism driven by another of its links, and the
same sweep begun elsewhere.

Run as: drawn_group_test.py PROGRAM LIBRARY.
"""

import json
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from drawn_mechanisms import Drawer, DrawnTestCase, drawn, pinned, table  # noqa: E402
from thinned import some  # noqa: E402
from toml_text import toml_of  # noqa: E402
from written_files import command  # noqa: E402

LIBRARY = pathlib.Path(sys.argv[2])


class DrawnGroups(DrawnTestCase):
    def test_planted_groups_of_four_links_move_as_their_constraints_say(self):
        compared = [self.follow(seed, min(seed % 2, seed % 3)) for seed in some(range(100, 116))]
        self.assertGreater(sum(compared), len(compared) * 8, compared)

    def test_a_group_is_measured_alike_wherever_its_sweep_begins(self):
        """From where it is drawn, and from the middle of the gap in which the crank cannot stand: rows, and the
        swing of the output, which is that of its rows."""
        compared = 0
        for seed in range(200, 220):
            drawer = Drawer(seed)
            if drawer.slides:
                continue
            joints = drawer.draw(0, 0)
            first = table(drawn(joints, "drive", "[drive]\nsteps = 720\n"))
            closed = [row["J1_x"] != "" if "J1_x" in row else any(row[key] for key in row if key.endswith("_x")) for row in first]
            if all(closed) or not closed[-1]:
                continue
            gap = [float(row["crank_deg"]) for row, is_closed in zip(first, closed) if not is_closed]
            if gap[-1] - gap[0] > 0.6 * len(gap):
                continue  # several gaps
            start = (gap[0] + gap[-1]) / 2
            drive = f"[drive]\nstart_deg = {start}\nend_deg = {start + 360}\nsteps = 720\n"
            results = [json.loads(command(drawn(joints, "drive", rest), "analyze", "--json").stdout) for rest in ("", drive)]
            metrics = [result["designs"][0]["metrics"] for result in results]
            for name in ("output_swing_deg", "circuit_swing_deg"):
                self.assertEqual(name in metrics[0], name in metrics[1], (seed, name))
                if name in metrics[0]:
                    self.assertAlmostEqual(metrics[0][name], metrics[1][name], delta=1e-4, msg=(seed, name))
            if "output_swing_deg" in metrics[1]:
                angles = [float(row[f"{metrics[1]['output']}_deg"]) for row in table(drawn(joints, "drive", drive)) if row[f"{metrics[1]['output']}_deg"]]
                self.assertGreater(metrics[0]["output_swing_deg"], max(angles) - min(angles) - 1e-6, seed)
                compared += 1
        self.assertGreater(compared, 2)

    def test_a_sweep_is_reached_from_the_drawing_in_either_turn(self):
        """The drawing stands beyond the end of the sweep, and nearer to its beginning by another turn."""
        pin = pinned
        joints = [pin("A", (0, 0), "frame", "crank"), pin("B", (0.27, -0.53), "crank", "leg1"), pin("P", (0.1, -3.5), "leg1", "plate"),
                  pin("Q", (3.5, -0.5), "leg2", "plate"), pin("R", (-1.4, -3.9), "leg3", "plate"), pin("C", (-0.9, 1.7), "leg2", "frame"),
                  pin("D", (0.9, -0.5), "leg3", "frame")]
        whole = table(drawn(joints, "crank", "[drive]\nsteps = 360\nstart_deg = -63\nend_deg = 297\n"))
        for start in (-700, -300, 100, 500):
            rows = table(drawn(joints, "crank", f"[drive]\nstart_deg = {start}\nend_deg = {start + 100}\nsteps = 100\n"))
            for row in rows:
                same = whole[round(float(row["crank_deg"]) + 63) % 360]
                self.assertAlmostEqual(float(row["Q_x"]), float(same["Q_x"]), delta=1e-9)

    def test_pins_of_one_name_are_one(self):
        group = json.loads(command((LIBRARY / "analysis" / "three-pin-link.toml").read_text(), "analyze", "--json").stdout)["problem"]
        joints = group["mechanism"]["dyad"][0]["joint"]
        for change, reason in (({"name": joints[2]["name"]}, "the name of a point at another place"), ({"name": "A"}, "the name of a"), ({"name": "T"}, "the name of another point")):
            other = json.loads(json.dumps(group))
            other["mechanism"]["dyad"][0]["joint"][1].update(change)
            self.assertIn(reason, self.faults(toml_of(other)))

    def test_a_six_bar_is_driven_in_its_five_bar_loop_too(self):
        """By the link that leaves a group of four, and by the one that leaves dyads: each sees the other move."""
        pin = pinned
        stephenson = [pin("A", (0, 0), "frame", "p"), pin("B", (1, 1.5), "p", "plate"), pin("D", (4, 0), "frame", "q"),
                      pin("C", (3.5, 2), "q", "plate"), pin("E", (2.5, 3), "plate", "r"), pin("F", (5, 4), "r", "s"),
                      pin("G", (6, 1), "s", "frame")]
        by_group = table(drawn(stephenson, "s", "[drive]\nend_deg = 130\nsteps = 1000\n"))
        by_dyads = table(drawn(stephenson, "p", "[drive]\nend_deg = 100\nsteps = 200\n"))
        compared = 0
        for row in by_dyads:
            if row["F_x"] == "":
                continue
            angle = math.degrees(math.atan2(float(row["F_y"]) - 1, float(row["F_x"]) - 6))
            before, after = neighbours(by_group, angle)
            if before is None or not all(other["B_x"] for other in (before, after)):
                continue
            share = (angle - float(before["crank_deg"])) / (float(after["crank_deg"]) - float(before["crank_deg"]))
            for name in ("B_x", "B_y", "C_x", "C_y", "E_x", "E_y"):
                between = (1 - share) * float(before[name]) + share * float(after[name])
                self.assertAlmostEqual(float(row[name]), between, delta=1e-4)
            compared += 1
        self.assertGreater(compared, 50)

    def test_links_that_only_count_as_a_group_are_refused(self):
        pin = pinned
        plate = [pin("P", (2, 3), "leg1", "plate"), pin("Q", (4, 3), "leg2", "plate"), pin("R", (3, 5), "leg3", "plate")]
        legs = [pin("A", (0, 0), "frame", "crank"), pin("B", (1, 1), "crank", "leg1"), pin("C", (5, 0), "frame", "leg2"), pin("D", (0, 6), "frame", "leg3")]
        self.assertEqual(command(drawn(legs + plate, "crank"), "check").returncode, 0)
        # All three legs meet in one point: the plate turns about it with the drive at rest.
        meet = [{**joint, "at": (3 + 2 * (x - 3), 3.5 + 2 * (y - 3.5))} for joint, (x, y) in zip(legs[1:], ((2, 3), (4, 3), (3, 5)))]
        self.assertIn("are drawn at a dead point", self.faults(drawn([legs[0], *meet, *plate], "crank")))
        held = [pin("X", (7, 7), "plate", "bar"), pin("Y", (8, 7), "bar", "frame"), pin("Z", (9, 9), "crank", "rod"), pin("W", (9, 8), "rod", "tail"),
                pin("V", (5, 9), "tail", "tip"), pin("U", (6, 9), "tip", "rod")]
        self.assertIn("is held beside one that is loose", self.faults(drawn(legs + plate + held, "crank")))


def neighbours(rows, angle):
    """The rows before and after an angle of the drive; None where there are none."""
    for before, after in zip(rows, rows[1:]):
        low, high = sorted((float(before["crank_deg"]), float(after["crank_deg"])))
        if low <= angle <= high:
            return before, after
    return None, None


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
