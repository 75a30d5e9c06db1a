// How long a hand waits for linkages in the page of `cognate sketch`, and their errors against those that the program
// finds by default. Usage: node sketch.mjs BUILD [DRAWINGS [KIND]]
// BUILD: the folder of the build. Strokes are random sums of three harmonics, half of them open, with the tremor of a
// hand; letters are capitals and signs with one, as the page reads them; poses, six to fifteen, lie on such with a direction that turns; functions are sums of harmonics, and outputs of four-bars
// with such a tremor; lines have random limits, boxed lines also a box for the pivots. Each is searched for as the page does, and solved by the program on one thread. KIND: one of
// curves, letters, poses, functions, slider-cranks, lines and boxed-lines alone.
import { problemOf, startsOf } from "../../../app/report/page/sketch/question.js";
import { byProgram, DRAWINGS, median, searchOf, timed } from "./searches.mjs";

const [build, drawings = "100", kind] = process.argv.slice(2);
const NEAR = 1.01, DESIGNS = 8, DESIGNS_OF_LINES = 4;

const best = ({ designs = [] }) => Math.min(Infinity, ...designs.map(({ rms }) => rms));

const solve = await searchOf(build);
for (const [name, drawing] of DRAWINGS.filter(([one]) => !kind || one === kind)) {
  const rounds = startsOf(drawing(0)).map((starts) => ({ starts, seconds: [] }));
  const ratios = [], firsts = [], shares = [];
  for (let i = 0; i < Number(drawings); i += 1) {
    const drawn = drawing(i);
    const found = rounds.map(({ starts, seconds }) => {
      const { value, seconds: own } = timed(() => solve(problemOf(drawn, { starts, designs: drawn.straight ? DESIGNS_OF_LINES : DESIGNS })));
      seconds.push(own);
      return best(value);
    });
    const { error, seconds } = byProgram(build, problemOf(drawn, {}));
    shares.push(rounds[0].seconds.at(-1) / seconds);
    firsts.push(found[0] / error);
    ratios.push(Math.min(...found) / error);
  }
  console.log(`${ratios.length} ${name}`);
  for (const { starts, seconds } of rounds) console.log(`  ${starts} starts: median ${median(seconds).toFixed(2)} s, worst ${Math.max(...seconds).toFixed(2)} s of one core`);
  console.log(`  first answer in ${median(shares).toFixed(3)} of the time of the program's default search (median)`);
  for (const [which, all] of [["first", firsts], ["last", ratios]]) {
    console.log(`  ${which} error within 1 % of the program's: ${all.filter((ratio) => ratio <= NEAR).length} of ${all.length}; ratios: median ${median(all).toFixed(3)}, worst ${Math.max(...all).toFixed(2)}`);
  }
}
