// Compiles WGSL with Tint: tint.mjs FOLDER FILE..., FOLDER being where npm has put webgpu. Prints what the compiler says
// and fails where it says anything.
import fs from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const [folder, ...files] = process.argv.slice(2);
const { create } = await import(pathToFileURL(createRequire(`${folder}/`).resolve("webgpu")).href);
const adapter = await create(["backend=null"]).requestAdapter();
const device = await adapter.requestDevice();
let said = 0;
for (const file of files) {
  device.pushErrorScope("validation");
  const module = device.createShaderModule({ code: fs.readFileSync(file, "utf8") });
  const { messages } = await module.getCompilationInfo();
  // A pipeline makes the compiler go on from WGSL's tree to its own.
  device.createComputePipeline({ layout: "auto", compute: { module } });
  const error = await device.popErrorScope();
  for (const m of messages) console.log(`${file}:${m.lineNum}:${m.linePos}: ${m.type}: ${m.message}`);
  if (error) console.log(`${file}: ${error.message}`);
  said += messages.length + (error ? 1 : 0);
}
device.destroy();
process.exit(said ? 1 : 0);
