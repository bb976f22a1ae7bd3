#version 450
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer inputs { float given[]; };
layout(std430, binding = 1) buffer outputs { float found[]; };
const float PI = 3.14159265;
// Of two widths: Heitz 2014, eq. 86, 99, and its Lambda.
float D_of(vec3 h, vec2 a) {
    vec3 s = vec3(h.xy / a, h.z);
    float d = dot(s, s);
    return 1.0 / (PI * a.x * a.y * d * d);
}
float lambda_of(vec3 w, vec2 a) {
    vec2 s = a * w.xy;
    return 0.5 * (sqrt(1.0 + dot(s, s) / (w.z * w.z)) - 1.0);
}
float G1_of(vec3 v, vec2 a) { return 1.0 / (1.0 + lambda_of(v, a)); }
float G2_of(vec3 v, vec3 l, vec2 a) { return 1.0 / (1.0 + lambda_of(v, a) + lambda_of(l, a)); }
// Schlick 1994.
vec3 F_Schlick(float v_h, vec3 F0) {
    float c = 1.0 - v_h, c2 = c * c;
    return F0 + (1.0 - F0) * (c2 * c2 * c);
}
// Dupuy & Benyoub 2023, listing 3.
vec3 sample_visible(vec3 v, vec2 u, vec2 a) {
    vec3 w = normalize(vec3(a * v.xy, v.z));
    float phi = 2.0 * PI * u.y, z = fma(1.0 - u.x, 1.0 + w.z, -w.z), s = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
    vec3 h = vec3(s * cos(phi), s * sin(phi), z) + w;
    return normalize(vec3(a * h.xy, h.z));
}
void main() {
    const uint i = 10u * gl_GlobalInvocationID.x, o = 7u * gl_GlobalInvocationID.x;
    vec3 v = vec3(given[i], given[i + 1], given[i + 2]), l = vec3(given[i + 3], given[i + 4], given[i + 5]);
    vec2 u = vec2(given[i + 6], given[i + 7]);
    float alpha = given[i + 8], x = given[i + 9];
    vec2 a = vec2(alpha);
    vec3 h = sample_visible(v, u, a);
    vec3 l_out = reflect(-v, h);
    bool above = v.z > 0.0 && l_out.z > 0.0;
    float D = D_of(h, a), G1 = G1_of(v, a);
    float pdf = above ? G1 * D / (4.0 * v.z) : 0.0;
    float weight = above ? G2_of(v, l_out, a) / G1 : 0.0;
    l_out = above ? l_out : vec3(0.0, 0.0, 1.0);
    vec3 F = F_Schlick(clamp(dot(v, h), 0.0, 1.0), vec3(x, 0.5 * x, 0.25 * x)) * weight;
    found[o] = l_out.x, found[o + 1] = l_out.y, found[o + 2] = l_out.z;
    found[o + 3] = F.x, found[o + 4] = F.y, found[o + 5] = F.z, found[o + 6] = pdf;
}
