// Draws paths by rough.js: node roughjs.cjs IN.json OUT.json, run where roughjs is installed.
// IN: {"options": {...}, "icons": {name: [path data, ...]}}. OUT, by name: {"seconds", "lines":
// for each path its pieces, each a row of ops}.
const fs = require('fs');
const rough = require(require.resolve('roughjs/bundled/rough.cjs.js', {paths: [process.cwd()]}));

const {options, icons} = JSON.parse(fs.readFileSync(process.argv[2]));
const generator = rough.generator();
const drawn = {};
for (const [name, paths] of Object.entries(icons)) {
  const draw = () => paths.map((d, i) => generator.path(d, {...options, seed: i + 1}));
  const times = [];
  let found = draw();
  for (let round = 0; round < 9; round++) {
    const began = process.hrtime.bigint();
    found = draw();
    times.push(Number(process.hrtime.bigint() - began) / 1e9);
  }
  times.sort((a, b) => a - b);
  drawn[name] = {seconds: times[4], lines: found.map(one => one.sets.flatMap(set => set.ops))};
}
fs.writeFileSync(process.argv[3], JSON.stringify(drawn));
