/// @file What `cognate --help` and the help of its commands say besides their options.
#pragma once

namespace cognate::app {

inline constexpr const char* kDescription =
    "Cognate finds planar linkages and cams that do what a problem file asks for, analyses "
    "mechanisms, and maps what is possible.\n";

inline constexpr const char* kFooter = R"(Examples:
  cognate solve rocker.toml     find designs; then open rocker.report.html
  cognate analyze press.toml    how a mechanism moves and what it bears
  cognate sweep sizes.toml      vary the numbers of a file, and keep the best
  cognate export press.result.json --format dxf    a drawing for CAD
  cognate check rocker.toml     is the file sound?
  cognate list --metrics        what a result says of a design, and in which unit

Exit status:
  0  done; for solve: at least one design meets every constraint
  1  the problem was well posed, but no design meets every constraint; for
     analyze: the mechanism can be assembled nowhere; for sweep: no row passes
  2  bad input: options, a file, or a place that cannot be written to
  3  a fault of Cognate's own

'cognate COMMAND --help' says more about a command.)";

inline constexpr const char* kSolveFooter = R"(Output:
  A table of the designs, best first, on standard output, and two files in DIR,
  NAME being FILE's name without its ending:
    NAME.result.json   every number of the designs, for programs
    NAME.report.html   the linkages moving, their curves and errors, for a browser
  With --json no files are written unless --out is given.
  Ctrl-C ends the search and reports what was found; a second one ends at once.
  The same file, seed and version give the same designs with any number of
  threads, unless a time limit ended the run.

Examples:
  cognate solve rocker.toml
  cognate solve rocker.toml --out results --time-limit 30
  cognate solve rocker.toml --json --seed 7 > rocker.json)";

inline constexpr const char* kAnalyzeFooter = R"(Output:
  What is true of the motion as a whole (class, transmission angle, limits, time
  ratio, greatest forces) on standard output, and three files in DIR, NAME being
  FILE's name without its ending:
    NAME.csv           one row for each step of the drive; units in the header
    NAME.result.json   the same numbers and the facts, for programs
    NAME.report.html   the mechanism moving, curves of motion and forces
  With --json no files are written unless --out is given.
  Where the mechanism cannot be assembled, cells are empty and a note says why.

Examples:
  cognate analyze press.toml
  cognate analyze press.toml --out results
  cognate analyze press.toml --json > press.json)";

inline constexpr const char* kSweepFooter = R"(Output:
  The counts and the best rows on standard output, and two files in DIR, NAME
  being FILE's name without its ending:
    NAME.study.db      the rows as an SQLite database (table runs, view best); it
                       can be queried while the study runs
    NAME.report.html   the rows in plots with filters (not with --json, unless
                       --out is given)
  Ctrl-C and --time-limit end the run; whatever ended it, the same command goes on
  where it stopped, and the rows are those of a run that was never stopped.
  The same file, seed and version give the same rows with any number of threads
  and of processes.
  mpirun runs a study on many processes and machines that see the same files, each
  with one thread unless --threads says otherwise.

Examples:
  cognate sweep sizes.toml
  cognate sweep sizes.toml --out results --time-limit 3600
  sqlite3 results/sizes.study.db 'SELECT * FROM best LIMIT 5'
  mpirun -n 64 cognate sweep sizes.toml --out results)";

inline constexpr const char* kExportFooter = R"(Output:
  One file in DIR, NAME being that of NAME.result.json. Of a linkage of any type:
    NAME.dxf    one position with the paths of the points, on the layers FRAME,
                GUIDES, LINKS, JOINTS, POINTS, PATHS, TARGET, LABELS
    NAME.svg    a picture with the same
    NAME.csv    where every point is over the drive, units in the header
    NAME.json   lengths, joints, paths and positions in one document
    NAME.dot    the kinematic chain for Graphviz: links as boxes, joints as edges
  With --parts NAME.parts.dxf, .svg or .json: a plate for each link and the frame
  with holes for pins and slots for sliders, side by side on the layers OUTLINES,
  HOLES, SLOTS, LABELS; the label says in which plane (1: the frame) the part lies
  so that the links pass one another. Outlines are lines and true arcs.
  Of a cam:
    NAME.dxf    a closed polyline on the layer PROFILE, PITCH or CUTTER, the base
                circle on BASE_CIRCLE, a cross on CENTRE
    NAME.svg    a picture with the same curves
    NAME.csv    the points with the cam angle, outward normal, radius of curvature;
                of a groove or conjugate cams one file for each curve
  NAME is followed by .pitch or .cutter for those curves.
  Lengths are those of the problem; drawings have no unit of length. Polygons are
  nowhere farther from their curve than the chord tolerance.
  With --row, from a study file NAME.study.db: NAME.ROW.toml, the base file of the
  study with the numbers of that design.

Examples:
  cognate export press.result.json --format dxf --position 45
  cognate export press.result.json --format csv --steps 720
  cognate export press.result.json --format dxf --parts --hole 5 --width 14 --thickness 3
  cognate export press.result.json --format dot && dot -Tsvg -O press.dot
  cognate export cam.result.json --format dxf --dxf-version r12
  cognate export cam.result.json --format csv --curve pitch --chord-tolerance 0.001
  cognate export cam.result.json --format dxf --curve cutter --cutter-radius 6
  cognate export sizes.study.db --row 1234)";

inline constexpr const char* kCheckFooter =
    R"(Every fault is reported as FILE:LINE:COLUMN: what is wrong; what is allowed.

Examples:
  cognate check rocker.toml
  cognate check rocker.toml --json)";

inline constexpr const char* kListFooter = R"(Examples:
  cognate list
  cognate list --metrics)";

}  // namespace cognate::app
