// Written by lobe 0.1.0
// Specular anti-aliasing: alpha widened by what normals do within a pixel or a texel.

// alpha'^2 = alpha^2 + 2 variance of slopes: Olano & Baker 2010.
fn widened(alpha: f32, variance: f32) -> f32 {
    return sqrt(alpha * alpha + 2.0 * variance);
}

// Tokuyoshi & Kaplanyan 2021, listing 5; dn_dx, dn_dy: derivatives of the shading normal, per pixel.
fn widened_by_pixel(alpha: f32, dn_dx: vec3f, dn_dy: vec3f) -> f32 {
    let t1 = alpha * alpha;
    let t2 = (dot(dn_dx, dn_dx) + dot(dn_dy, dn_dy)) * 0.07957747;
    return sqrt(min(t1 + min(2.0 * t2, 0.18), max(t1, 1.0)));
}

// Toksvig 2005.
fn toksvig_variance(length_of_mean_normal: f32) -> f32 {
    return max(1.0 - length_of_mean_normal, 0.0) / length_of_mean_normal;
}
