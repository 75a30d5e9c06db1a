"""Sheets of parts for their tests: documents and drawings, sizes that suit a linkage."""

import json

from exported_linkages import ExportedLinkages

try:
    import ezdxf
except ImportError:
    ezdxf = None


def shortest(document):
    return min((length["length"] for link in document["links"] for length in link["lengths"]), default=1)


class PartSheets(ExportedLinkages):
    def sizes(self, result, hole=0.25, width=0.5):
        least = shortest(self.document(result))
        return "--parts", "--hole", hole * least, "--width", width * least

    def sheet(self, result, *options):
        """The document and the drawing of parts."""
        document = json.loads(self.export(result, "json", *options).read_text())
        drawing = ezdxf.readfile(self.export(result, "dxf", *options))
        self.assertEqual(drawing.audit().errors, [])
        return document, drawing.modelspace()

    def outlines(self, space):
        return list(space.query('*[layer=="OUTLINES"]'))

    def in_millimetres(self):
        return self.analysed("mm", 'length_unit = "mm"\n[mechanism]\ntype = "four-bar"\nfixed_pivots = [[0, 0], [80, 0]]\n'
                             "crank = 40\ncoupler = 90\nrocker = 80\n")
