// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Manifold (WebAssembly) on the solids that boolean_crowds.py has written: node boolean_crowds.mjs FOLDER FILE
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, file] = process.argv.slice(2);
// Its heap, which only grows, is an export of the instance.
let memory;
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...given) => {
  const made = await instantiate(...given);
  memory = Object.values((made.instance ?? made).exports).find((each) => each instanceof WebAssembly.Memory);
  return made;
};
const { default: load } = await import(pathToFileURL(`${folder}/node_modules/manifold-3d/manifold.js`));
const wasm = await load();
wasm.setup();
const { Manifold, Mesh } = wasm;

const { united, subtracted, isChain } = JSON.parse(readFileSync(file));
const make = ({ points, faces }) => {
  const mesh = new Mesh({ numProp: 3, vertProperties: Float32Array.from(points), triVerts: Uint32Array.from(faces) });
  mesh.merge();
  return new Manifold(mesh);
};
const begin = process.cpuUsage();
const inputs = united.map(make);
const tools = subtracted.map(make);
[...inputs, ...tools].forEach((solid) => solid.numTri());

const start = process.cpuUsage();
let result = inputs.length > 1 ? Manifold.union(inputs) : inputs[0];
if (isChain) {
  for (const tool of tools) {
    result = result.subtract(tool);
    result.numTri();
  }
} else if (tools.length > 0) {
  result = Manifold.difference([result, ...tools]);
}
const count = result.numTri();
const secondsSince = (then) => {
  const { user, system } = process.cpuUsage(then);
  return (user + system) * 1e-6;
};
const [all, operation] = [begin, start].map(secondsSince);
console.log(
  `${"  Manifold".padEnd(12)} ${operation.toFixed(3).padStart(8)} s ${String(count).padStart(8)} ` +
    `triangles, volume ${result.volume()}, ${(memory.buffer.byteLength * 1e-6).toFixed(1)} MB, ` +
    `${all.toFixed(3)} s with the solids made`);
