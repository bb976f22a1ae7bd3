// Runs the printed WGSL in Chromium's WebGPU, and the printed GLSL ES in its WebGL 2: browser.mjs FOLDER CHROMIUM PLAYWRIGHT
// FOLDER holds what `shader_write browser` writes, cases.json, and all functions in one file, printed.es.glsl.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { pathToFileURL } from "node:url";

const [folder, chromium, playwright] = process.argv.slice(2);
const { chromium: driver } = (await import(pathToFileURL(playwright + "/index.js"))).default;
const all = JSON.parse(readFileSync(folder + "/cases.json", "utf8"));
const whole = readFileSync(folder + "/printed.es.glsl", "utf8");
const server = createServer((_, reply) => reply.setHeader("Content-Type", "text/html").end("<!doctype html><title>lobe</title>"));
await new Promise((done) => server.listen(0, "127.0.0.1", done));
const browser = await driver.launch({ executablePath: chromium, args: ["--no-sandbox", "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", "--enable-unsafe-swiftshader"] });
const page = await browser.newPage();
await page.goto(`http://127.0.0.1:${server.address().port}/`);

// Both take 10 numbers an input and give, of each code, 7 numbers an input, or what is wrong with it.
const run_wgsl = async ({ inputs, codes }) => {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) return { missing: "WebGPU has no adapter", results: [] };
    const device = await adapter.requestDevice();
    const count = inputs.length / 10, bytes = count * 7 * 4;
    const make = (size, usage) => device.createBuffer({ size, usage });
    const given = make(inputs.length * 4, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST);
    device.queue.writeBuffer(given, 0, new Float32Array(inputs));
    const found = make(bytes, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
    const read = make(bytes, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
    const results = [];
    for (const code of codes) {
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
    return { results };
};

// A vertex shader a function, an input a vertex; transform feedback captures what it finds, and nothing is drawn.
const run_es = ({ inputs, codes, whole }) => {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return { missing: "no WebGL 2", results: [] };
    const compiled = (stage, code) => {
        const shader = gl.createShader(stage);
        gl.shaderSource(shader, code);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
        return shader;
    };
    const fragment = "#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";
    const nothing = compiled(gl.FRAGMENT_SHADER, fragment), count = inputs.length / 10, bytes = count * 7 * 4;
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(inputs), gl.STATIC_DRAW);
    [[3, 0], [3, 3], [2, 6], [2, 8]].forEach(([size, first], location) => {
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, size, gl.FLOAT, false, 40, first * 4);
    });
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, gl.createTransformFeedback());
    const found = gl.createBuffer();
    gl.enable(gl.RASTERIZER_DISCARD);
    const run = (code) => {
        const program = gl.createProgram();
        gl.attachShader(program, compiled(gl.VERTEX_SHADER, code));
        gl.attachShader(program, nothing);
        gl.transformFeedbackVaryings(program, ["found_0123", "found_456"], gl.INTERLEAVED_ATTRIBS);
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
        gl.useProgram(program);
        gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, found);
        gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, new Float32Array(count * 7).fill(NaN), gl.STREAM_READ);
        gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, found);
        gl.beginTransformFeedback(gl.POINTS);
        gl.drawArrays(gl.POINTS, 0, count);
        gl.endTransformFeedback();
        gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
        gl.bindBuffer(gl.COPY_READ_BUFFER, found);
        const values = new Float32Array(bytes / 4);
        gl.getBufferSubData(gl.COPY_READ_BUFFER, 0, values);
        gl.bindBuffer(gl.COPY_READ_BUFFER, null);
        gl.deleteProgram(program);
        const error = gl.getError();
        if (error) throw new Error("WebGL error " + error);
        return Array.from(values);
    };
    const said = (f) => { try { return f(); } catch (error) { return error.message || "unknown"; } };
    const complaint = said(() => {
        compiled(gl.FRAGMENT_SHADER, fragment.replace("precision highp float;\n", whole));
        return "";
    });
    return { complaint, results: codes.map((code) => said(() => run(code))) };
};

let failed = 0;
const say = (good, text) => { failed += !good; console.log(`${good ? "ok   " : "WRONG"} ${text}`); };
const ulps = (x, exact) => {
    if (!Number.isFinite(x)) return 1e30;
    if (x === 0 && Math.abs(exact) < 1e-30) return 0; // flushed: docs/shaders.md
    return Math.abs(x - exact) / 2 ** (Math.max(Math.floor(Math.log2(Math.max(Math.abs(exact), 2 ** -126))), -126) - 23);
};
const below = (errors, share) => errors.sort((a, b) => a - b)[Math.floor(share * (errors.length - 1))];
const approximate = /\b(exp|exp2|log|log2|pow|sin|cos|acos|atan2)\(/; // of WGSL, whose names tell two arguments from one
const judge = (language, { missing, results }, started) => {
    if (missing) return say(false, `${language}: ${missing}`);
    let ran = 0;
    const most = { plain: [-Infinity, "none"], other: [-Infinity, "none"] };
    results.forEach((values, i) => {
        const f = all.functions[i];
        if (typeof values === "string") return say(false, `${language}, ${f.name}: ${values}`);
        const device = [], cpu = [];
        for (let k = 0; k < f.exact.length; ++k) {
            if (f.exact[k] === null || f.cpu[k] === null) continue;
            device.push(ulps(values[7 * Math.floor(k / f.count) + (k % f.count)], f.exact[k]));
            cpu.push(ulps(f.cpu[k], f.exact[k]));
        }
        const other = approximate.test(f.wgsl), share = other ? 0.5 : 0.95;
        const d = below(device, share), c = below(cpu, share);
        ++ran;
        if (!(d <= c + (other ? 32 : 3 + (c > 20 ? c : 0)))) say(false, `${language}, ${f.name}: ${d} ULP, on the CPU ${c}`);
        const kind = other ? "other" : "plain";
        if (d - c > most[kind][0]) most[kind] = [d - c, f.name];
    });
    const [plain, other] = [most.plain, most.other].map(([by, name]) => `${by.toPrecision(3)} ULP (${name})`);
    const seconds = ((performance.now() - started) / 1000).toFixed(1);
    say(ran === all.functions.length, `${language}: ${ran} of ${all.functions.length} functions ran, ${seconds} s; ` +
        `beyond float on the CPU at most ${plain}; with exp, log, pow, sin, cos, acos or atan ${other}`);
};
const run = async (language, f, given) => {
    const started = performance.now();
    const ran = await page.evaluate(f, { inputs: all.inputs, ...given });
    judge(language, ran, started);
    return ran;
};
await run("WGSL", run_wgsl, { codes: all.functions.map((f) => f.wgsl) });
const es = await run("GLSL ES 3.00", run_es, { codes: all.functions.map((f) => f.es), whole });
if (!es.missing) say(!es.complaint, "GLSL ES 3.00: WebGL 2 compiles all in one fragment shader " + es.complaint);
await browser.close();
server.close();
process.exit(failed ? 1 : 0);
