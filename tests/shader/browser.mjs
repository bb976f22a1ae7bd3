// Runs the printed WGSL in Chromium's WebGPU, and compiles the printed GLSL ES in its WebGL 2: browser.mjs FOLDER CHROMIUM PLAYWRIGHT
// FOLDER holds what `shader_write browser` writes: cases.json, printed.es.glsl.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { pathToFileURL } from "node:url";

const [folder, chromium, playwright] = process.argv.slice(2);
const { chromium: driver } = (await import(pathToFileURL(playwright + "/index.js"))).default;
const all = JSON.parse(readFileSync(folder + "/cases.json", "utf8"));
const es = readFileSync(folder + "/printed.es.glsl", "utf8");
const server = createServer((_, reply) => reply.setHeader("Content-Type", "text/html").end("<!doctype html><title>lobe</title>"));
await new Promise((done) => server.listen(0, "127.0.0.1", done));
const browser = await driver.launch({ executablePath: chromium, args: ["--no-sandbox", "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", "--enable-unsafe-swiftshader"] });
const page = await browser.newPage();
await page.goto(`http://127.0.0.1:${server.address().port}/`);

const ran = await page.evaluate(async ({ inputs, functions, es }) => {
    const canvas = document.createElement("canvas").getContext("webgl2");
    let complaint = "no WebGL 2";
    if (canvas) {
        const shader = canvas.createShader(canvas.FRAGMENT_SHADER);
        canvas.shaderSource(shader, "#version 300 es\n" + es + "\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n");
        canvas.compileShader(shader);
        complaint = canvas.getShaderParameter(shader, canvas.COMPILE_STATUS) ? "" : canvas.getShaderInfoLog(shader);
    }
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) return { complaint, missing: "WebGPU has no adapter" };
    const device = await adapter.requestDevice();
    const count = inputs.length / 10, bytes = count * 7 * 4;
    const make = (size, usage) => device.createBuffer({ size, usage });
    const given = make(inputs.length * 4, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST);
    device.queue.writeBuffer(given, 0, new Float32Array(inputs));
    const found = make(bytes, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
    const read = make(bytes, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
    const results = [];
    for (const code of functions) {
        device.pushErrorScope("validation");
        const module = device.createShaderModule({ code });
        const errors = (await module.getCompilationInfo()).messages.filter((m) => m.type === "error").map((m) => m.message);
        if (errors.length) { await device.popErrorScope(); results.push(errors[0]); continue; }
        const pipeline = await device.createComputePipelineAsync({ layout: "auto", compute: { module, entryPoint: "main" } });
        const group = device.createBindGroup({ layout: pipeline.getBindGroupLayout(0),
            entries: [{ binding: 0, resource: { buffer: given } }, { binding: 1, resource: { buffer: found } }] });
        const encoder = device.createCommandEncoder();
        const pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.dispatchWorkgroups(count / 64);
        pass.end();
        encoder.copyBufferToBuffer(found, 0, read, 0, bytes);
        device.queue.submit([encoder.finish()]);
        await read.mapAsync(GPUMapMode.READ);
        results.push(Array.from(new Float32Array(read.getMappedRange())));
        read.unmap();
        const wrong = await device.popErrorScope();
        if (wrong) results[results.length - 1] = wrong.message;
    }
    return { complaint, results };
}, { inputs: all.inputs, functions: all.functions.map((f) => f.code), es });
await browser.close();
server.close();

let failed = 0;
const say = (good, text) => { failed += !good; console.log(`${good ? "ok   " : "WRONG"} ${text}`); };
say(!ran.complaint, "GLSL ES 3.00: WebGL 2 compiles it " + ran.complaint);
say(!ran.missing, "WebGPU " + (ran.missing ?? ""));
const ulps = (x, exact) => {
    if (!Number.isFinite(x)) return 1e30;
    if (x === 0 && Math.abs(exact) < 1e-30) return 0; // flushed: docs/shaders.md
    return Math.abs(x - exact) / 2 ** (Math.max(Math.floor(Math.log2(Math.max(Math.abs(exact), 2 ** -126))), -126) - 23);
};
const below = (errors, share) => errors.sort((a, b) => a - b)[Math.floor(share * (errors.length - 1))];
const approximate = /\b(exp|exp2|log|log2|pow|sin|cos|acos|atan2)\(/;
let ran_functions = 0;
(ran.results ?? []).forEach((values, i) => {
    const f = all.functions[i];
    if (typeof values === "string") return say(false, `${f.name}: ${values}`);
    const device = [], cpu = [];
    for (let k = 0; k < f.exact.length; ++k) {
        if (f.exact[k] === null || f.cpu[k] === null) continue;
        device.push(ulps(values[7 * Math.floor(k / f.count) + (k % f.count)], f.exact[k]));
        cpu.push(ulps(f.cpu[k], f.exact[k]));
    }
    const other = approximate.test(f.code), share = other ? 0.5 : 0.95;
    const d = below(device, share), c = below(cpu, share);
    ++ran_functions;
    if (!(d <= c + (other ? 32 : 3 + (c > 20 ? c : 0)))) say(false, `${f.name}: ${d} ULP, on the CPU ${c}`);
});
say(ran_functions === all.functions.length, `WGSL: ${ran_functions} of ${all.functions.length} functions ran`);
process.exit(failed ? 1 : 0);
