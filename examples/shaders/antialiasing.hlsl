// Written by lobe 0.1.0
// Specular anti-aliasing: alpha widened by what normals do within a pixel or a texel.

// alpha'^2 = alpha^2 + 2 variance of slopes: Olano & Baker 2010.
float widened(float alpha, float variance) {
    return sqrt(alpha * alpha + 2.0 * variance);
}

// Tokuyoshi & Kaplanyan 2021, listing 5; dn_dx, dn_dy: derivatives of the shading normal, per pixel.
float widened_by_pixel(float alpha, float3 dn_dx, float3 dn_dy) {
    const float t1 = alpha * alpha;
    const float t2 = (dot(dn_dx, dn_dx) + dot(dn_dy, dn_dy)) * 0.07957747;
    return sqrt(min(t1 + min(2.0 * t2, 0.18), max(t1, 1.0)));
}

// Toksvig 2005.
float toksvig_variance(float length_of_mean_normal) {
    return max(1.0 - length_of_mean_normal, 0.0) / length_of_mean_normal;
}
