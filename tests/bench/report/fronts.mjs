// The fronts of error against transmission angle in the page of `cognate sketch`: how long they take, in shares of the longest
// search for designs before them in the same run, and their errors against those that the program finds within the same limits. Usage: node fronts.mjs BUILD [DRAWINGS]
// BUILD: the folder of the build. The drawings are those of sketch.mjs; each front is searched for as the page does after its
// searches for designs, and each of its points solved by the program with the starts of the file that the page saves.
import { Candidate } from "../../../app/report/page/sketch/candidate.js";
import { Front } from "../../../app/report/page/sketch/front.js";
import { Generator } from "../../../app/report/page/sketch/generator.js";
import { problemOf, questionsOf } from "../../../app/report/page/sketch/question.js";
import { byProgram, DRAWINGS, median, searchOf, timed } from "./searches.mjs";

const [build, drawings = "12"] = process.argv.slice(2);
const NEAR = 1.01, FILE = { starts: 500, designs: 3 };
const solve = await searchOf(build);

function answered({ problem, known }, drawn) {
  const { value: { designs = [] }, seconds } = timed(() => solve(known.length ? { ...problem, known } : problem));
  return { found: designs.map((entry) => (drawn.ranges ? new Generator(entry, drawn) : new Candidate(entry))), seconds };
}

// The front of a drawing, and how long it takes until it stands and until it has ended.
function frontOf(drawn) {
  const front = new Front();
  front.follow(drawn);
  const searches = questionsOf(drawn, []).map((question) => answered(question, drawn));
  for (const { found } of searches) front.add(found);
  const longest = searches.at(-1).seconds;
  let [first, all] = [0, 0];
  while (!front.ended) {
    const { found, seconds } = answered(front.question, drawn);
    if (!front.stands) first += seconds;
    all += seconds;
    front.take(found);
  }
  return { points: front.points, stands: first / longest, ended: all / longest };
}

const most = (values) => Math.max(...values).toFixed(2);
for (const [name, drawing] of DRAWINGS) {
  const fronts = Array.from({ length: Number(drawings) }, (_, i) => drawing(i)).map((drawn) => ({ drawn, ...frontOf(drawn) }));
  const ratios = fronts.flatMap(({ drawn, points }) => points.map(({ level, error }) => error / byProgram(build, problemOf({ ...drawn, least: level }, FILE)).error));
  console.log(`${fronts.length} ${name}, ${ratios.length} points`);
  for (const key of ["stands", "ended"]) console.log(`  ${key} after ${median(fronts.map((one) => one[key])).toFixed(2)} of the longest search in the median, ${most(fronts.map((one) => one[key]))} at most`);
  console.log(`  error within 1 % of the program's: ${ratios.filter((ratio) => ratio <= NEAR).length}; ratios: median ${median(ratios).toFixed(3)}, worst ${most(ratios)}, least ${Math.min(...ratios).toFixed(2)}`);
}
