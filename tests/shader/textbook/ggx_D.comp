#version 450
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer inputs { float given[]; };
layout(std430, binding = 1) buffer outputs { float found[]; };
const float PI = 3.14159265;
// Walter et al. 2007, eq. 33, with a cosine.
float D_GGX(float n_h, float a) {
    float a2 = a * a, d = n_h * n_h * (a2 - 1.0) + 1.0;
    return a2 / (PI * d * d);
}
void main() {
    const uint i = 10u * gl_GlobalInvocationID.x, o = 7u * gl_GlobalInvocationID.x;
    vec3 v = vec3(given[i], given[i + 1], given[i + 2]), l = vec3(given[i + 3], given[i + 4], given[i + 5]);
    vec2 u = vec2(given[i + 6], given[i + 7]);
    float alpha = given[i + 8], x = given[i + 9];
    found[o] = l.z > 0.0 ? D_GGX(l.z, alpha) : 0.0;
}
