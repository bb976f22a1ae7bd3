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
// Heitz 2014, eq. 99, over 4 n.v n.l.
float V_Smith(float n_v, float n_l, float a) {
    float a2 = a * a;
    float of_v = n_l * sqrt(n_v * n_v * (1.0 - a2) + a2), of_l = n_v * sqrt(n_l * n_l * (1.0 - a2) + a2);
    return 0.5 / (of_v + of_l);
}
// Schlick 1994.
vec3 F_Schlick(float v_h, vec3 F0) {
    float c = 1.0 - v_h, c2 = c * c;
    return F0 + (1.0 - F0) * (c2 * c2 * c);
}
// Smith, of one direction: Heitz 2014, eq. 72 and 43.
float G1_Smith(float n_w, float a) {
    float a2 = a * a;
    return 2.0 * n_w / (n_w + sqrt(a2 + (1.0 - a2) * n_w * n_w));
}
void main() {
    const uint i = 10u * gl_GlobalInvocationID.x, o = 7u * gl_GlobalInvocationID.x;
    vec3 v = vec3(given[i], given[i + 1], given[i + 2]), l = vec3(given[i + 3], given[i + 4], given[i + 5]);
    vec2 u = vec2(given[i + 6], given[i + 7]);
    float alpha = given[i + 8], x = given[i + 9];
    vec3 f_cos = vec3(0.0);
    float pdf = 0.0;
    vec3 h = normalize(v + l);
    bool above = v.z > 0.0 && l.z > 0.0;
    float D = D_GGX(h.z, alpha);
    f_cos = above ? F_Schlick(clamp(dot(v, h), 0.0, 1.0), vec3(x, 0.5 * x, 0.25 * x)) * (D * V_Smith(v.z, l.z, alpha) * l.z) : vec3(0.0);
    pdf = above ? G1_Smith(v.z, alpha) * D / (4.0 * v.z) : 0.0;
    found[o] = f_cos.x, found[o + 1] = f_cos.y, found[o + 2] = f_cos.z, found[o + 3] = pdf;
}
