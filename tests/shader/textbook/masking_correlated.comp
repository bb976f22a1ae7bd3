#version 450
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer inputs { float given[]; };
layout(std430, binding = 1) buffer outputs { float found[]; };
const float PI = 3.14159265;
// Heitz 2014, eq. 99, over 4 n.v n.l.
float V_Smith(float n_v, float n_l, float a) {
    float a2 = a * a;
    float of_v = n_l * sqrt(n_v * n_v * (1.0 - a2) + a2), of_l = n_v * sqrt(n_l * n_l * (1.0 - a2) + a2);
    return 0.5 / (of_v + of_l);
}
void main() {
    const uint i = 10u * gl_GlobalInvocationID.x, o = 7u * gl_GlobalInvocationID.x;
    vec3 v = vec3(given[i], given[i + 1], given[i + 2]), l = vec3(given[i + 3], given[i + 4], given[i + 5]);
    vec2 u = vec2(given[i + 6], given[i + 7]);
    float alpha = given[i + 8], x = given[i + 9];
    found[o] = v.z > 0.0 && l.z > 0.0 ? V_Smith(v.z, l.z, alpha) : 0.0;
}
