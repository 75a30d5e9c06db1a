/// @file The texts of `cognate --help` and of the commands' help, apart from the options.
#pragma once

namespace cognate::app {

inline constexpr const char* kDescription =
    R"(Cognate designs planar linkages, cams and gears from a problem file, analyses
mechanisms, computes how machines run, and maps whole families of designs.
)";

inline constexpr const char* kFooter =
    R"(First steps:
  cognate new path-generation     write a commented file to start from
  cognate check rocker.toml       find faults of the file; summarise the problem
  cognate solve rocker.toml       find designs; then open rocker.report.html
  cognate list                    every key that a file may have

Examples:
  cognate analyze press.toml      motion and forces of a mechanism, or
                                  how a machine runs (kind = "machine")
  cognate sweep sizes.toml        vary the numbers of a file, and keep the best
  cognate export press.result.json --format dxf
  cognate list --metrics          the numbers of a result, with their units
  cognate studio rocker.toml      edit and solve a file in the browser
  cognate solve --help            the help of a command

Exit status:
  0  done; for solve: at least one design meets every constraint
  1  the problem is well posed, but no design meets every constraint; for
     analyze: the mechanism cannot be assembled at any angle, or the machine
     does not run as requested; for sweep: no row passes
  2  bad input: options, a file, or a place that cannot be written to
  3  an internal error of Cognate

Shell:
  The Tab key completes commands, options and files after
    source <(cognate completion bash)       in bash; the same for zsh
    cognate completion fish | source        in fish
  Colours are used only on a terminal, and not if NO_COLOR is set.)";

inline constexpr const char* kNewFooter = R"(Output:
  KIND.toml in DIR, a problem that can be solved at once: its keys with their
  meaning, and after # further keys. An existing file is not overwritten.

Examples:
  cognate new path-generation
  cognate new cam --out valves)";

inline constexpr const char* kSolveFooter = R"(Output:
  A table of the designs, best first, on standard output, and files in DIR, NAME
  being FILE's name without its ending:
    NAME.result.json   every number of the designs, for programs
    NAME.report.html   the linkages in motion, their curves and errors, for a
                       browser
    NAME.csv           of a cam: motion, angles, profile and forces over a turn
  With --json no files are written unless --out is given; the documents of
  several files follow one another.
  Ctrl-C ends the search and reports the designs found; a second one ends at
  once.
  With --watch the file is solved again whenever it is saved, faults or not, and
  its files are written anew; Ctrl-C ends that.
  The same file, seed and version give the same designs with any number of
  threads, unless a time limit ended the run.

Examples:
  cognate solve rocker.toml
  cognate solve rocker.toml --out results --time-limit 30
  cognate solve rocker.toml --watch
  cognate solve rocker.toml --json --seed 7 > rocker.json)";

inline constexpr const char* kAnalyzeFooter = R"(Output:
  The quantities of the whole motion (class, transmission angle, limits, time
  ratio, maximum forces) on standard output, and three files in DIR, NAME being
  FILE's name without its ending:
    NAME.csv           one row for each step of the drive; units in the header;
                       for a machine the first column is the motion (task)
    NAME.result.json   the same numbers and the quantities, for programs
    NAME.report.html   the mechanism in motion, curves of motion and forces
  With --json no files are written unless --out is given; the documents of
  several files follow one another.
  For a design of NAME.result.json the files are NAME.designN.csv and so on; a
  synthesised linkage moves as far as it can be assembled.
  Where the mechanism cannot be assembled, cells are empty and a note says why.
  For a gear the table is its flank; an impossible gear, or pair of gears, ends
  with exit status 1.
  For a machine (kind = "machine"): the speed at which it runs, its fluctuation,
  the flywheel, starts and stops; or the reason why there is no steady motion.

Examples:
  cognate analyze press.toml
  cognate analyze press.toml --out results --threads 2
  cognate analyze rocker.result.json --design 2
  cognate analyze press.toml --json > press.json)";

inline constexpr const char* kSweepFooter = R"(Output:
  The counts and the best rows on standard output, and two files in DIR, NAME
  being FILE's name without its ending:
    NAME.study.db      the rows as an SQLite database (table runs, view best),
                       which can be queried while the study runs
    NAME.report.html   the rows in plots with filters (not with --json, unless
                       --out is given)
  With --format hdf5 NAME.study.h5, too, has the rows, as columns that h5py and
  pandas read, and as --merge and cognate export --row take them. No run goes on
  with it: only --merge takes its rows over.
  Ctrl-C and --time-limit end the run. The same command continues it, and the
  rows are then those of a run that was never stopped.
  The same file, seed and version give the same rows with any number of threads
  and of processes.
  --part 2/5 evaluates the second of five parts of the designs, on a machine of
  its own; --merge, which may be given several times, takes over the rows of
  such a file, .db or .h5, and what is missing then is evaluated.
  mpirun runs a study on many processes and machines that see the same files,
  each with one thread unless --threads says otherwise.

Examples:
  cognate sweep sizes.toml
  cognate sweep sizes.toml --out results --time-limit 3600
  sqlite3 results/sizes.study.db 'SELECT * FROM best LIMIT 5'
  cognate sweep sizes.toml --format hdf5
  cognate sweep sizes.toml --part 1/2
  cognate sweep sizes.toml --merge other/sizes.study.db
  cognate sweep sizes.toml --merge sizes.study.h5 --out again
  mpirun -n 64 cognate sweep sizes.toml --out results)";

/// What `cognate export` writes of linkages stands between these two, by the formats' own words.
inline constexpr const char* kExportHead = R"(Output:
  One file in DIR, NAME being that of NAME.result.json. Of a linkage:
)";

inline constexpr const char* kExportTail =
    R"(  With --parts NAME.parts.dxf, .svg or .json: a plate for each link and the
  frame with holes for pins and slots for sliders, side by side on layers
  OUTLINES, HOLES, SLOTS and LABELS. The label says in which plane the part
  lies, from 1, so that links pass one another. Outlines are lines and true
  arcs. --kerf K moves what is drawn off the finished edge by half of it,
  --labels stroke writes names in single strokes on ENGRAVE, --sheet 600x400
  packs the parts on sheets with their edges on SHEETS, --bearing 608 gives
  holes the outside diameter of a bearing, --screw M5 makes screws of the pins,
  --block 20x12 gives pins that run in slots a block, --bill writes
  NAME.bill.csv: plates, blocks, pins or screws with nuts, spacers, washers,
  bearings.
  Of a cam:
    NAME.dxf   a closed polyline on the layer PROFILE, PITCH or CUTTER, the base
               circle of the profile on BASE_CIRCLE, the prime circle of a
               roller's pitch curve on PRIME_CIRCLE, a cross on CENTRE
    NAME.svg   a picture with the same curves
    NAME.profile.csv   the points with cam angle, outward normal, curvature
               radius; of a groove or conjugate cams one file for each curve
  NAME is followed by .pitch or .cutter for those curves. Drawings of cams and
  gears have --bore D with its --keyway on BORE and --hub D on HUB.
  Of a gear or a gear pair:
    NAME.dxf   closed outlines on the layer OUTLINE, tip and root as true arcs;
               BASE_CIRCLE, PITCH_CIRCLE, TIP_CIRCLE, ROOT_CIRCLE and CENTRE
    NAME.svg   a picture with the same
    NAME.csv   the points with their radius and the part that they are of; of a
               pair NAME.pinion.csv and NAME.wheel.csv
    NAME.gears.json  radii, places and outlines in one document
  --boss D puts bosses on solid plates in place of --spacers.
  As step and stl gears and cams are solids, too, with --thickness T and the hub
  a boss of --hub-length L: NAME.step, NAME.pinion.stl; in millimetres.
  Lengths are those of the problem; drawings have no unit of length. Polygons
  are nowhere farther from their curve than the chord tolerance.
  With --row, from a study file NAME.study.db or NAME.study.h5: NAME.ROW.toml,
  the base file of the study with the numbers of that design.

Examples:
  cognate export press.result.json --format dxf --position 45
  cognate export press.result.json --format csv --steps 720
  cognate export press.result.json --format dxf --parts --hole 5 --width 14
  cognate export press.result.json --format dxf --parts --bearing 608 \
    --width 30 --thickness 6 --kerf 0.2 --labels stroke --sheet 600x400 --bill
  cognate export press.result.json --format dot && dot -Tsvg -O press.dot
  cognate export cam.result.json --format csv --curve pitch
  cognate export cam.result.json --format dxf --curve cutter --cutter-radius 6
  cognate export gears.result.json --format dxf --chord-tolerance 0.001
  cognate export gears.result.json --format dxf --kerf 0.2 --bore 10,20 --keyway
  cognate export press.result.json --format step --parts --hole 5 --width 14 \
    --thickness 4 --position 45
  cognate export sizes.study.db --row 1234)";

inline constexpr const char* kSketchFooter =
    R"(Output:
  One page that needs no network: with mouse, pen or finger draw a curve, put
  poses of a body, or draw or type a function of angles, and the page finds
  four-bar linkages for it and shows them in motion.
  Limits, points and designs can be changed; problems and designs are saved as
  files for cognate. With --mechanism a page on which a mechanism is built by
  hand, of links, pivots, sliders and forces: it moves and is analysed at once.
  With a FILE of an analysis its mechanism is on that page, to be changed.
  An existing file is not overwritten.

Examples:
  cognate sketch
  cognate sketch --mechanism
  cognate sketch press.toml
  cognate sketch --out pages/curve.html)";

inline constexpr const char* kInvoluteFooter =
    R"(Output:
  inv a = tan a - a for each angle a, from 0 to less than 90 degrees, or with
  --inverse the angle whose involute is each value, right to the last digits
  also near 0 and 90 degrees; without any VALUE the table of textbooks, from 10
  to 45 degrees. A STEP of angles that is left out is 1 degree.

Examples:
  cognate involute 20 22.5
  cognate involute 10:45:0.5 --csv > involute.csv
  cognate involute --inverse 0.0149043839)";

inline constexpr const char* kStudioFooter =
    R"(Output:
  The address of a page, which the browser opens: the text of FILE with its
  faults beside the lines, and the report of what this program finds. Problems
  of every kind; analyses and machines too. The text is saved to FILE as it
  stands there; where another program saves FILE, the page takes that over, or
  asks.
  Only this machine gets an answer, and only with the token in the address.
  Seed, threads and time limit are those of the command. Ctrl-C ends it.

Examples:
  cognate studio
  cognate studio rocker.toml
  cognate studio rocker.toml --port 8080 --no-open --time-limit 30)";

inline constexpr const char* kCheckFooter =
    R"(Output:
  A summary of the problem on standard output; or every fault in it on standard
  error, each as
    FILE:LINE:COLUMN: what is wrong; what is allowed
  The exit status is 0 for a sound file and 2 for one with faults.
  With --certificate, of NAME.result.json of a timed path with solve.certify:
  the boxes of its proof are made anew and counted until they cover the domain;
  of a sample of those that the proof discards it is shown again, by other code
  and in intervals of 113 bits, that no linkage in them is better than the
  bound. The exit status is 0 if all are confirmed, and 1 if a better linkage
  is found, which is printed, if a box stays undecided, or if the boxes do not
  cover the domain. --seed chooses the sample.

Examples:
  cognate check rocker.toml
  cognate check rocker.toml --json
  cognate check --certificate rocker.result.json --sample 1000 --seed 2)";

inline constexpr const char* kListFooter = R"(Output:
  The kinds of problems, mechanisms, cams, motion laws, solvers and studies with
  all keys of their files, or with KIND those of one kind; with --metrics the
  numbers of results instead.

Examples:
  cognate list
  cognate list cam
  cognate list | less
  cognate list --metrics
  cognate list --json > keys.json)";

inline constexpr const char* kCompletionFooter = R"(Examples:
  source <(cognate completion bash)   in ~/.bashrc; the same for zsh in ~/.zshrc
  cognate completion fish | source    in ~/.config/fish/config.fish)";

inline constexpr const char* kManualFooter = R"(Example:
  cognate manual | man -l -)";

}  // namespace cognate::app
