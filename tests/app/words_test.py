"""The texts of the report pages: whole in each language, all used, and none left in the scripts.

Run as: words_test.py ROOT, the project's folder.
"""

import collections
import functools
import html.parser
import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path()

# What stands for the variable parts of a key that is put together, by what is before them, or as a
# whole where something is after them.
VALUES = {
    "arrows.": ["velocity", "acceleration", "reactions"],
    "best.": ["dwell", "function", "leg", "path", "motion"],
    "bill.": ["plate", "cylinder", "pin", "spacer", "length", "width", "thickness", "outside", "bore",
              "stroke"],
    "build.": ["move", "link", "pivot", "slider", "point", "drive", "load"],
    "build.${}_hint": ["move", "link", "pivot", "slider", "point", "drive", "load"],
    "build.choose_": ["move", "link", "pivot", "slider", "point", "drive", "load"],
    "build.example_": ["four_bar", "slider_crank", "six_bar", "quick_return"],
    "build.refused_": ["move", "link", "pivot", "slider", "point", "drive", "load", "field",
                       "number"],
    "build.acts_": ["stroke", "advance", "return", "advance_stroke", "return_stroke"],
    "cam.": ["base_radius", "prime_radius", "offset", "roller_radius", "centre_distance", "arm",
             "face_offset"],
    "closure.": ["groove", "conjugate", "constant-breadth"],
    "constraints.": ["constraint", "value", "bound", "met"],
    "edit.": ["undo", "redo", "reset", "copy", "save", "class", "grashof", "holds", "fails",
              "change_point", "rotates", "least", "greatest", "time_ratio", "swing", "defects",
              "error.max", "error.rms", "error.sum", "error.turned"],
    "edit.${}.title": ["undo", "redo", "reset", "copy", "save"],
    "edit.field.": ["crank", "coupler", "rocker", "frame", "a_x", "a_y", "d_x", "d_y", "point_u",
                    "point_v", "input", "output", "offset", "direction_deg", "slot_deg", "length",
                    "second_line_deg", "centre_x", "centre_y"],
    "extras.": ["velocity", "acceleration", "assembly", "cognate2", "cognate3"],
    "filters.${}_of": ["least", "greatest", "first", "last"],
    "follower.": ["translating-roller", "translating-flat", "translating-knife",
                  "oscillating-roller", "oscillating-flat", "oscillating-knife"],
    "gear.": ["pinion", "worm", "wheel", "worm_wheel", "ring", "its_rack"],
    "gear.part_": ["root", "fillet", "involute", "tip"],
    "gearing.": ["spur", "helical", "internal", "rack", "bevel", "worm"],
    "instant.": ["pole", "moving_centrode", "inflection_diameter", "inflection_centre",
                 "return_centre", "tangential_diameter", "tangential_centre", "acceleration_pole",
                 "ball", "stationary", "inflection_line", "inflection_line_deg"],
    "head.": ["base_radius", "prime_radius"],
    "jump.": ["displacement", "velocity", "acceleration"],
    "kind.": ["gear", "gear_pair"],
    "legend.jump_": ["displacement", "velocity", "acceleration"],
    "machine.fact.": ["speed_mean_rad_s", "speed_max_rad_s", "speed_min_rad_s", "fluctuation",
                      "fluctuation_without_flywheel", "flywheel_inertia_kg_m2",
                      "flywheel_inertia_approximate_kg_m2", "greatest_excess_work_J", "period_s",
                      "energy_swing_J", "motor_work_J", "motor_power_mean_W", "motor_power_max_W",
                      "multiplier", "energy_residual", "start_time_s", "start_turns",
                      "start_end_speed_rad_s", "stop_time_s", "stop_turns",
                      "stop_end_speed_rad_s", "train_ratio", "train_ratio_exact",
                      "train_efficiency", "train_reverse_efficiency", "train_self_locking",
                      "train_inertia_kg_m2"],
    "layers.": ["joint", "slide", "collision", "unresolved"],
    "loads.": ["load", "weight", "drive"],
    "machine.task.": ["steady", "start", "stop"],
    "map.": ["grid", "triangles", "bins"],
    "map.note_": ["grid", "grid_missing", "triangles", "bins"],
    "meaning.": ["found_by", "precision_residual", "condition", "chance_of_unseen_minimum",
                 "best_hits", "closure_residual", "power_residual", "energy_residual"],
    "metric.": ["max", "min", "max_rise", "min_rise", "max_return", "min_return",
                "max_rise_working", "max_return_working"],
    "motion.": ["back", "on"],
    "parallel.wanted_": ["least", "greatest"],
    "problem.": ["max", "min"],
    "part.": ["crank", "coupler", "rocker"],
    "save.": ["picture", "drawing", "film"],
    "raster.": ["continuous", "on_raster", "rounded"],
    "studio.": ["sketch", "mechanism"],
    "take.": ["position", "chord-tolerance", "dxf-version", "steps", "parts", "hole", "width",
              "thickness", "clearance", "gap", "kerf", "sheet", "labels", "bill",
              "spacers", "bearing", "screw", "washer", "boss", "block", "curve",
              "cutter-radius", "bore", "keyway", "hub", "hub-length", "timing-mark"],
    "take.of_": ["drawing", "parts", "wheels"],
    "tolerance.": ["nominal", "worst"],
    "tolerance.${}_title": ["nominal", "worst"],
    "sampling.": ["sobol", "halton", "latin", "random"],
    "stage.": ["gear", "gear_pair", "virtual_gears", "worm", "rack"],
    "status.": ["solved", "infeasible", "no-solution", "done", "time-limit", "interrupted"],
    "stroke_now.": ["rise", "return", "dwell"],
    "study.wanted_": ["least", "greatest"],
    "theme.": ["auto", "light", "dark"],
    "zoom.": ["nearer", "farther", "all", "large"],
    "train.fact.": ["state", "ratio", "ratio_exact", "ratio_error", "degrees_of_freedom",
                    "output_speed_rad_s", "torque_ratio", "efficiency", "reverse_efficiency",
                    "self_locking", "reverse_self_locking", "power_W", "loss_W",
                    "equivalent_inertia_kg_m2", "teeth_sum", "teeth_max"],
    "values.": ["column", "of", "now", "least", "greatest", "unit"],
}

# Literals that look like text and are none: keys of the keyboard, names, fonts, values of CSS.
NO_TEXT = {"Cognate", "Delete", "Backspace", "Esc", "Escape", "Enter", "Home", "End", "Tab", "Space",
           "use strict", "no words for ${}"}

Literal = collections.namedtuple("Literal", "text start end")

REGEX = re.compile(r"/(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n\[])+/[a-z]*")
STRING = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'')
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


@functools.cache
def literals(script):
    """Strings and templates of a script, the holes of templates as "${}"."""
    found = []

    def template(at):
        start, text = at, ""
        at += 1
        while script[at] != "`":
            if script[at] == "\\":
                text += script[at:at + 2]
                at += 2
            elif script.startswith("${", at):
                text += "${}"
                at = code(at + 2, "}")
            else:
                text += script[at]
                at += 1
        found.append(Literal(text, start, at + 1))
        return at + 1

    def code(at, end):
        depth, before = 0, "("
        while at < len(script):
            char = script[at]
            if char == end and depth == 0:
                return at + 1
            if match := COMMENT.match(script, at):
                at = match.end()
                continue
            if match := STRING.match(script, at):
                found.append(Literal(match[0][1:-1], at, match.end()))
                at, before = match.end(), '"'
                continue
            if char == "`":
                at, before = template(at), '"'
                continue
            # A slash after a value divides.
            if char == "/" and (match := REGEX.match(script, at)) and before in "(,=:[!&|?{};>":
                at, before = match.end(), '"'
                continue
            depth += (char in "{([") - (char in "})]")
            if not char.isspace():
                before = char
            at += 1
        return at

    code(0, "")
    return found


def first_argument(script, at):
    """The end of the first argument of a call, which begins at `at`."""
    ends = {literal.start: literal.end for literal in literals(script)}
    depth = 0
    while depth > 0 or script[at] not in ",)":
        depth += (script[at] in "{([") - (script[at] in "})]")
        at = ends.get(at, at + 1)
    return at


@functools.cache
def kinds():
    """The kinds of problems that have a file to start from, but for the study, which needs another."""
    return [file.stem for file in (ROOT / "app/commands/new").glob("*.toml") if file.stem != "study"]


def put_together(template):
    """The keys that a template such as "status.${}" or "edit.${}.title" stands for."""
    beginning, hole, end = template.partition("${}")
    end = end.replace("${}", "")
    values = VALUES.get(template if end else beginning, kinds() if beginning == "studio.kind." else [])
    return {beginning + value + end for value in values if hole}


def placeholders(text):
    return set(re.findall(r"\{(\w+)\}", text))


def whole(pairs):
    """An object of JSON, none of whose keys is there twice."""
    keys = [key for key, _ in pairs]
    twice = [key for key, count in collections.Counter(keys).items() if count > 1]
    if twice:
        raise ValueError(f"twice: {twice}")
    return dict(pairs)


def texts_of_sources():
    """Pairs of a C++ file and one of its string literals, those of several lines joined."""
    for folder in ("analysis", "app", "problems", "synthesis"):
        for file in sorted((ROOT / folder).rglob("*.?pp")):
            source = re.sub(r'"\s*\n\s*"', "", file.read_text(encoding="utf-8"))
            for text in re.findall(r'R"(\w*)\((.*?)\)\1"', source, re.DOTALL):
                yield file, text[1]
            for text in re.findall(r'"((?:\\.|[^"\\\n])*)"', source):
                yield file, text


class Markup(html.parser.HTMLParser):
    """Texts and spoken attributes that stand in a page as they are, and the keys that it names."""

    def __init__(self):
        super().__init__()
        self.texts, self.keys, self.silent = [], [], 0

    def handle_starttag(self, tag, attributes):
        self.silent += tag in {"noscript", "script", "style", "title"}
        for name, value in attributes:
            if name.startswith("data-say"):
                self.keys.append(value)
            elif name in {"aria-label", "title", "placeholder", "alt"}:
                self.texts.append(value)

    def handle_endtag(self, tag):
        self.silent -= tag in {"noscript", "script", "style", "title"}

    def handle_data(self, data):
        if not self.silent and not re.fullmatch(r"(?:@\w+@|[xy]|[^A-Za-z])*", data.strip()):
            self.texts.append(data.strip())


class Words(unittest.TestCase):
    def setUp(self):
        page = ROOT / "app/report/page"
        self.languages = {
            file.stem: json.loads(file.read_text(encoding="utf-8"), object_pairs_hook=whole)
            for file in (page / "words").glob("*.json")}
        self.words = self.languages["en"]["words"]
        self.assertGreaterEqual(self.languages.keys(), {"en", "zh"})
        self.assertGreater(len(self.words), 200)
        self.scripts = {file.relative_to(page): file.read_text(encoding="utf-8")
                        for file in page.rglob("*.js")}
        self.markup = {}
        for file in page.rglob("*.html"):
            self.markup[file.relative_to(page)] = parser = Markup()
            parser.feed(file.read_text(encoding="utf-8"))
        self.assertGreater(len(self.scripts), 10)
        self.assertGreater(len(self.markup), 3)

    def test_languages_have_the_same_texts(self):
        for language, texts in self.languages.items():
            with self.subTest(language=language):
                self.assertEqual(list(texts["words"]), list(self.words))
                for key, text in texts["words"].items():
                    self.assertTrue(text, key)
                    self.assertEqual(placeholders(text), placeholders(self.words[key]), key)

    def keys_said(self, script):
        """Keys of calls of say, and the beginnings of those that are put together."""
        for call in re.finditer(r"\bsay\(", script):
            end = first_argument(script, call.end())
            for literal in literals(script):
                if not call.end() <= literal.start < end:
                    continue
                if re.search(r"[!=]==\s*$", script[literal.start - 6:literal.start]):
                    continue
                yield literal.text

    def test_each_key_is_there_and_each_text_is_used(self):
        used = {key for page in self.markup.values() for key in page.keys}
        said = 0
        for name, script in self.scripts.items():
            for key in self.keys_said(script):
                said += 1
                if "." in key and "${}" in key:
                    self.assertTrue(put_together(key), f"{name}: list what `{key}` stands for")
                elif "." in key:
                    used.add(key)
            # Also keys that a table of the script holds, or that a function is given.
            for literal in literals(script):
                used |= ({literal.text} & set(self.words)) | put_together(literal.text)
                # Of a kind with a page of its own the page says more.
                if literal.text == "kind.${}":
                    used |= {f"kind.{kind}" for kind in kinds()} & set(self.words)
        self.assertGreater(said, 100)
        self.assertEqual(sorted(used - set(self.words)), [], "not among the words")
        self.assertEqual(sorted(set(self.words) - used), [], "not used")

    def test_no_text_stands_in_the_markup(self):
        for name, page in self.markup.items():
            self.assertEqual(page.texts, [], name)

    def test_no_text_stands_in_the_scripts(self):
        for name, script in self.scripts.items():
            for literal in literals(script):
                text = literal.text
                before = script[max(0, literal.start - 96):literal.start]
                is_class = re.search(r"\bclass\b[^\n]*$", before)
                words = re.search(r"^[A-Z][a-z]+(?=[ :.,]|$)|\b[a-z]{2,} [a-z]{2,}\b", text)
                line = script.count("\n", 0, literal.start) + 1
                self.assertFalse(words and text not in NO_TEXT and not is_class
                                 and not self.is_no_text(script, literal),
                                 f"{name}:{line}: “{text}” is to be among the words")

    def is_no_text(self, script, literal):
        """Fonts, style and transforms, classes and selectors; keys and what is compared."""
        around = script[max(0, literal.start - 60):literal.start]
        after = script[literal.start + len(literal.text) + 2:][:1]
        return (re.search(r"style: $|font = $|transform[:`]? ?$", around)
                or re.search(r"(querySelector(All)?|\.on)\($", around)
                or "gradient(" in literal.text or re.fullmatch(r"number \w+", literal.text)
                or after == ":" or re.search(r"[!=]== $|key === $", around)
                or literal.text.startswith(("M${}", "translate(", "cognate export")))


class ChineseOfResults(unittest.TestCase):
    def setUp(self):
        file = ROOT / "app/report/page/words/zh.json"
        texts = json.loads(file.read_text(encoding="utf-8"), object_pairs_hook=whole)
        self.terms, self.sentences = texts["terms"], texts["sentences"]
        self.assertGreater(len(self.terms), 100)
        self.assertGreater(len(self.sentences), 100)

    def test_terms_are_translated(self):
        for term, text in self.terms.items():
            self.assertRegex(text, "[\u4e00-\u9fff]", term)

    def test_quantities_over_the_cycle_are_translated_and_documented(self):
        declared = (ROOT / "problems/linkage/cycle/cycle_quantities.hpp").read_text(encoding="utf-8")
        keys = re.findall(r'\.limit_key = "(\w+)_max"', declared)
        words = re.findall(r'\.words = "([^"]+)"', declared)
        self.assertGreaterEqual(len(keys), 5)
        self.assertEqual(len(keys), len(words))
        documented = (ROOT / "docs/constraints.md").read_text(encoding="utf-8")
        for key, text in zip(keys, words):
            self.assertIn(key.replace("_", " "), self.terms)
            self.assertIn(text, self.terms)
            self.assertIn(f"| `{key}_max` |", documented)

    def test_sentences_keep_their_values(self):
        for form, text in self.sentences.items():
            self.assertEqual(placeholders(form), placeholders(text), form)
            self.assertEqual(len(placeholders(form)), len(re.findall(r"\{\d+\}", form)), form)

    def test_each_sentence_is_the_first_that_fits_itself(self):
        # As the page does, from the longest on.
        forms = [(form, re.compile("(.+?)".join(map(re.escape, re.split(r"\{\d+\}", form)))))
                 for form in sorted(self.sentences, key=len, reverse=True)]
        for form in self.sentences:
            said = re.sub(r"\{(\d+)\}", lambda hole: f"{hole[1]}.5", form)
            first = next(other for other, pattern in forms if pattern.fullmatch(said))
            self.assertEqual(first, form)

    def test_sentences_are_those_of_the_program(self):
        """Half of their runs of four words stand in its sources: a changed wording is noticed."""
        source = "\n".join(text for _, text in texts_of_sources()).replace('\\"', '"')
        source = " ".join(source.lower().split())
        for form in self.sentences:
            words = re.sub(r"\{\d+\}", "#", form).lower().split()
            runs = [" ".join(words[i:i + 4]) for i in range(len(words) - 3)]
            runs = [run for run in runs if "#" not in run]
            found = sum(run in source for run in runs)
            self.assertGreaterEqual(found, 0.5 * len(runs), form)


class PlainWords(unittest.TestCase):
    """Phrases that have a plainer word never come back: a program reports, a file requests."""

    PHRASES = {
        r"(is|are|was|were|be|been|being|as) told": "reported",
        r"tells (of|what|whether|which|why|how|its)": "reports, says",
        r"besides": "in addition to, other than, except",
        r"whatever": "for any, any",
        r"lest|amiss|of no account|for want of": "a clause with so that, if, without",
        r"hangs? on": "depends on",
        r"(is|are) wanted": "expected, required, desired",
        r"asked for|asks? for (an?|the|what|it|them|nothing|more|fewer)": "requested, specifies",
        r"keeps? to": "meets, stays within, follows",
        r"bears? (a|an|the|it|what|more|no)": "carries",
        r"comes? to (rest|lie|nothing|be)": "stops, is",
    }

    def expect_plain(self, place, text):
        for phrase, plain in self.PHRASES.items():
            if match := re.search(rf"\b({phrase})\b", text, re.IGNORECASE):
                around = " ".join(text[max(0, match.start() - 40):match.end() + 40].split())
                self.fail(f"{place}: “{match[0]}” in “{around}”; say: {plain}")

    def test_in_the_documentation(self):
        pages = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]
        self.assertGreater(len(pages), 20)
        for page in pages:
            name = str(page.relative_to(ROOT))
            with self.subTest(page=name):
                self.expect_plain(name, page.read_text(encoding="utf-8"))

    def test_in_messages(self):
        count = 0
        for file, text in texts_of_sources():
            if " " in text:
                count += 1
                self.expect_plain(str(file.relative_to(ROOT)), text)
        self.assertGreater(count, 2000)

    def test_in_the_texts_of_reports(self):
        for language in ("en", "zh"):
            texts = json.loads((ROOT / f"app/report/page/words/{language}.json")
                               .read_text(encoding="utf-8"))
            for part in ("words", "terms", "sentences"):
                for key, text in texts.get(part, {}).items():
                    self.expect_plain(f"{language}.json", key if part == "sentences" else text)


if __name__ == "__main__":
    ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
