#version 450
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer inputs { float given[]; };
layout(std430, binding = 1) buffer outputs { float found[]; };
const float PI = 3.14159265;
// Schlick 1994.
vec3 F_Schlick(float v_h, vec3 F0) {
    float c = 1.0 - v_h, c2 = c * c;
    return F0 + (1.0 - F0) * (c2 * c2 * c);
}
void main() {
    const uint i = 10u * gl_GlobalInvocationID.x, o = 7u * gl_GlobalInvocationID.x;
    vec3 v = vec3(given[i], given[i + 1], given[i + 2]), l = vec3(given[i + 3], given[i + 4], given[i + 5]);
    vec2 u = vec2(given[i + 6], given[i + 7]);
    float alpha = given[i + 8], x = given[i + 9];
    vec3 F = F_Schlick(u.x, vec3(x, 0.5 * x, 0.25 * x));
    found[o] = F.x, found[o + 1] = F.y, found[o + 2] = F.z;
}
