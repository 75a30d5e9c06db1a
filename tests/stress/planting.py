"""Four-bars planted in problems: drawing them, placing them, and what a program makes of them.

Nothing here comes from the program under test: the closure, the classes, the transmission angle and
the error are computed again, in complex numbers. A place (x, y) is x + iy.
"""

import cmath
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile
import time

CLASSES = ["crank-rocker", "double-crank", "rocker-crank", "double-rocker", "triple-rocker"]
LENGTHS = ["crank", "coupler", "rocker", "frame"]


class FourBar:
    """Pivots A and D, links A-B, B-C and C-D, the side of B->D on which C lies, and a coupler point
    in axes with origin B, the first of them towards C."""

    def __init__(self, pivot_a, pivot_d, crank, coupler, rocker, side, point):
        self.pivot_a, self.pivot_d = pivot_a, pivot_d
        self.crank, self.coupler, self.rocker = crank, coupler, rocker
        self.side, self.point = side, point

    def lengths(self):
        return [self.crank, self.coupler, self.rocker, abs(self.pivot_d - self.pivot_a)]

    def at(self, angle):
        """Coupler point, direction of the coupler and transmission angle; None where it is open."""
        b = self.pivot_a + self.crank * cmath.exp(1j * angle)
        to_d = self.pivot_d - b
        distance = abs(to_d)
        if not abs(self.coupler - self.rocker) < distance < self.coupler + self.rocker:
            return None
        cosine = (self.coupler**2 + distance**2 - self.rocker**2) / (2 * self.coupler * distance)
        turned = cmath.exp(1j * self.side * math.acos(cosine))
        direction = to_d / distance * turned
        cosine = (self.coupler**2 + self.rocker**2 - distance**2) / (2 * self.coupler * self.rocker)
        return b + direction * self.point, direction, math.degrees(math.acos(cosine))

    def class_name(self):
        links = self.lengths()
        if 2 * (min(links) + max(links)) > sum(links):
            return "triple-rocker"
        shortest = links.index(min(links))
        return ["crank-rocker", "double-rocker", "rocker-crank", "double-crank"][shortest]

    def turns_fully(self):
        return self.class_name() in ("crank-rocker", "double-crank")

    def ratio(self):
        return max(self.lengths()) / min(self.lengths())


def random_four_bar(rng, wanted):
    """A linkage of the class `wanted`, no length more than seven times another and a part in fifty
    away from the change point."""
    while True:
        pivot_a = complex(rng.uniform(-1, 1), rng.uniform(-1, 1))
        pivot_d = pivot_a + rng.uniform(0.3, 2) * cmath.exp(1j * rng.uniform(0, 2 * math.pi))
        made = FourBar(pivot_a, pivot_d, rng.uniform(0.3, 2), rng.uniform(0.3, 2),
                       rng.uniform(0.3, 2), rng.choice([1, -1]),
                       complex(rng.uniform(-1, 2), rng.uniform(-1.5, 1.5)))
        links = made.lengths()
        excess = 2 * (min(links) + max(links)) - sum(links)
        closes = 2 * max(links) < 0.98 * sum(links)
        if closes and abs(excess) > 0.02 * sum(links) and made.class_name() == wanted:
            return made


def ranges(linkage, steps=720):
    """Intervals of the crank's angle in which the linkage closes, to a step; a whole turn is one."""
    grid = [2 * math.pi * k / steps for k in range(steps)]
    closes = [linkage.at(angle) is not None for angle in grid]
    if all(closes):
        return [(0, 2 * math.pi)]
    found = []
    for k in range(steps):
        if closes[k] and not closes[k - 1]:
            end = k
            while closes[(end + 1) % steps]:
                end += 1
            if end > k + 8:  # some of its ends is left out below
                found.append((2 * math.pi * k / steps, 2 * math.pi * end / steps))
    return found


def ordered_angles(rng, linkage, count):
    """`count` crank angles in one sense within one range, over a part of it or all."""
    low, high = rng.choice(ranges(linkage))
    margin = 0.03 * (high - low)
    if linkage.turns_fully():
        low = rng.uniform(0, 2 * math.pi)
        if rng.random() < 0.5:  # a whole turn
            shares = sorted((k + rng.uniform(-0.3, 0.3)) / count for k in range(count))
            angles = [low + 2 * math.pi * share for share in shares]
        else:
            span = rng.uniform(0.8, 4.5)
            angles = sorted(low + span * rng.random() for _ in range(count))
    else:
        low, high = low + margin, high - margin
        cut = sorted(rng.uniform(low, high) for _ in range(2))
        if cut[1] - cut[0] < 0.4 * (high - low):
            cut = [low, high]
        angles = sorted(rng.uniform(*cut) for _ in range(count))
    return angles if rng.random() < 0.5 else angles[::-1]


def size_of(points):
    middle = sum(points) / len(points)
    return math.sqrt(sum(abs(p - middle) ** 2 for p in points) / len(points))


def limits(rng, linkage, angles):
    """Lines of [bounds] and [constraints] that the linkage itself satisfies, some of them barely."""
    if linkage.turns_fully():
        seen = [2 * math.pi * k / 3600 for k in range(3600)] + list(angles)
    else:
        low, high = min(angles), max(angles)
        seen = [low + (high - low) * k / 3600 for k in range(3601)]
    transmissions = [linkage.at(angle)[2] for angle in seen]
    constraints = [
        f'class = "{linkage.class_name()}"',
        f"transmission_angle_deg = [{max(0, min(transmissions) - rng.uniform(0.01, 5))!r}, "
        f"{min(180, max(transmissions) + rng.uniform(0.01, 5))!r}]",
        f"link_ratio_max = {linkage.ratio() * rng.uniform(1.001, 1.3)!r}",
        f"pivot_region = {region(rng, linkage)}",
    ]
    low, high = min(linkage.lengths()), max(linkage.lengths())
    bounds = f"length = [{low * rng.uniform(0.7, 0.99)!r}, {high * rng.uniform(1.01, 1.3)!r}]"
    kept = [line for line in constraints if rng.random() < 0.75]
    text = "[constraints]\n" + "\n".join(kept) + "\n" if kept else ""
    return text + (f"[bounds]\n{bounds}\n" if rng.random() < 0.75 else "")


def region(rng, linkage):
    a, d = linkage.pivot_a, linkage.pivot_d
    wide = [rng.uniform(0.01, 0.4) for _ in range(4)]
    return [[min(a.real, d.real) - wide[0], min(a.imag, d.imag) - wide[1]],
            [max(a.real, d.real) + wide[2], max(a.imag, d.imag) + wide[3]]]


class Outcome:
    """What the program answered, by its result document, and how long that took."""

    def __init__(self, document, seconds, code, message):
        self.seconds, self.code, self.message = seconds, code, message
        self.status = document["status"] if document else "none"
        designs = document["designs"] if document else []
        self.found = squares(designs[0]) if designs else math.inf
        self.feasible = self.status == "solved"
        self.designs = designs
        self.facts = document.get("facts", {}) if document else {}


def squares(design):
    """The sum of squares of a design's errors: of a straight line, its deviation."""
    if "straight_length" in design["metrics"]:
        return design["metrics"]["deviation"] ** 2
    return design["error"]["sum_of_squares"]


def solve(program, text, seed, threads=None):
    """Runs `program solve` on a file of `text`."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "planted.toml")
        file.write_text(text)
        command = [program, "solve", str(file), "--json", "--seed", str(seed)]
        if threads:
            command += ["--threads", str(threads)]
        begun = time.monotonic()
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        seconds = time.monotonic() - begun
    document = json.loads(done.stdout) if done.stdout.strip() else None
    return Outcome(document, seconds, done.returncode, done.stderr.strip())


class Tally:
    """The outcomes of one noise level and kind of limits."""

    # An exact problem is met when the root mean square error is below so many sizes of the target.
    EXACT = 1e-8

    def __init__(self, name):
        self.name = name
        self.count = self.found = self.infeasible = self.best = self.runs = 0
        self.ratios, self.seconds, self.worse, self.agreeing = [], [], [], []
        self.errors = []  # of the first run of each problem
        self.floor_of_exact = 0

    def add(self, outcomes, planted, exact_scale, label):
        """`planted`: sum of squares of the planted linkage; `exact_scale`: that of an error of one
        size at each target."""
        floor = self.EXACT**2 * exact_scale
        self.floor_of_exact = max(self.floor_of_exact, floor)
        self.count += 1
        first = outcomes[0]
        self.infeasible += sum(not outcome.feasible for outcome in outcomes)
        least = min(outcome.found for outcome in outcomes)
        near = [o for o in outcomes if o.feasible and o.found <= 1.01**2 * least + floor]
        self.best += len(near)
        self.agreeing.append(len(near))
        self.errors.append(first.found)
        self.runs += len(outcomes)
        self.seconds += [outcome.seconds for outcome in outcomes]
        ratio = math.sqrt(max(first.found, floor) / max(planted, floor))
        self.ratios.append(ratio if first.feasible else math.inf)
        if first.feasible and ratio <= 1.001:
            self.found += 1
        else:
            self.worse.append(f"{label} ({first.status}, {ratio:.4g} times the planted error)")

    def agreement(self):
        """In how many problems so many of the runs reach the best."""
        counts = sorted(set(self.agreeing), reverse=True)
        return ", ".join(f"{self.agreeing.count(count)} by {count}" for count in counts)

    def line(self):
        ratios, seconds = sorted(self.ratios), sorted(self.seconds)
        finite = [ratio for ratio in ratios if ratio < math.inf]
        worst = f"{finite[-1]:.4g}" if finite else "-"
        return (f"{self.name}: {self.found} of {self.count} found, "
                f"{self.infeasible} of {self.runs} runs infeasible, worst ratio {worst}, "
                f"median {seconds[len(seconds) // 2]:.2f} s, longest {seconds[-1]:.2f} s, "
                f"{self.best} of {self.runs} runs reach the best to 1 % "
                f"(problems by seeds: {self.agreement()})")


def add_arguments(parser, count):
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=count, help="problems of each noise and limit")
    parser.add_argument("--seed", type=int, default=1, help="of the planted linkages")
    parser.add_argument("--seeds", type=int, default=1, help="runs of each problem")
    parser.add_argument("--noise", type=float, nargs="*", default=[0, 0.001, 0.01, 0.05],
                        help="shares of the target's size")
    parser.add_argument("--limits", nargs="*", choices=["without", "with"], default=["without", "with"])
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files of what failed")
    parser.add_argument("--threads", type=int)
    parser.add_argument("--allowed", type=float,
                        help="share of problems that may be missed before the run fails (default: any)")


def run(arguments, kind, plant):
    """`plant(rng, noise, limited, class)`: text of a file, sum of squares of the planted linkage,
    that of an error of one size at each target. Prints a line for each noise and limits; returns the
    exit status: 1 if a problem is infeasible or more than allowed are missed."""
    return run_all(arguments, kind, plant, kind)[0]


def run_all(arguments, kind, plant, family):
    """As `run`, with the tallies. Problems of one `family` have the same linkages."""
    missed = infeasible = count = 0
    tallies = []
    for noise in arguments.noise:
        for limited in (word == "with" for word in arguments.limits):
            tally = Tally(f"{kind}, noise {100 * noise:g} %, {'limits' if limited else 'no limits'}")
            tallies.append(tally)
            for index in range(arguments.count):
                label = f"{family}-{arguments.seed}-{noise:g}-{'limited' if limited else 'free'}-{index}"
                rng = random.Random(label)
                text, planted, scale = plant(rng, noise, limited, CLASSES[index % len(CLASSES)])
                outcomes = [solve(os.path.abspath(arguments.program), text, seed, arguments.threads)
                            for seed in range(1, arguments.seeds + 1)]
                before = len(tally.worse)
                tally.add(outcomes, planted, scale, label)
                disagree = tally.agreeing[-1] < arguments.seeds
                if arguments.keep and (len(tally.worse) > before or disagree):
                    arguments.keep.mkdir(parents=True, exist_ok=True)
                    errors = " ".join(f"{outcome.status} {outcome.found:.6g}" for outcome in outcomes)
                    (arguments.keep / f"{label}.toml").write_text(
                        f"# planted sum of squares {planted!r}; by seeds {errors}\n" + text)
            print(tally.line(), flush=True)
            for worse in tally.worse:
                print("   ", worse)
            missed += tally.count - tally.found
            infeasible += tally.infeasible
            count += tally.count
    print(f"{count} problems, {missed} missed, {infeasible} infeasible")
    if count == 0 or infeasible > 0:
        return 1, tallies
    too_many = arguments.allowed is not None and missed > arguments.allowed * count
    return int(too_many), tallies
