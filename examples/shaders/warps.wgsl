// Written by lobe 0.1.0
// Maps of the unit square and their inverses; u.x radial, u.y azimuthal, except in the concentric maps.
// Error in float: 3e-7.

fn square_to_uniform_disk(u: vec2f) -> vec2f {
    let t1 = sqrt(u.x);
    let t2 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t3 = t2 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b1 = t3 == 1.0;
    let b2 = t3 == 2.0;
    let b3 = t3 == 3.0;
    let b4 = b1 || b3;
    let t4 = u.y - t3 * 0.25;
    let t5 = t4 * t4;
    let t6 = t5 * (-41.341675 + t5 * (81.59394 + t5 * -75.4534));
    let t7 = t4 * 6.2831855 + t4 * (-1.7484555e-07 + t6);
    let t8 = t5 * (64.93932 + t5 * (-85.44374 + t5 * 59.245964));
    let t9 = 1.0 + t5 * (-19.739208 + t8);
    let t10 = select(t9, t7, b4);
    let t11 = select(t7, t9, b4);
    return vec2f(t1 * select(t10, -t10, b1 || b2), t1 * select(t11, -t11, b2 || b3));
}

fn uniform_disk_to_square(p: vec2f) -> vec2f {
    let t1 = atan2(p.y, p.x) * 0.15915494;
    let t2 = select(t1, t1 + 1.0, t1 < 0.0);
    return vec2f(p.x * p.x + p.y * p.y, select(0.0, t2, t2 < 1.0));
}

fn square_to_uniform_disk_concentric(u: vec2f) -> vec2f {
    let b1 = min(u.x, 1.0 - u.x) < min(u.y, 1.0 - u.y);
    let t1 = 2.0 * u.x - 1.0;
    let t2 = 2.0 * u.y - 1.0;
    let t3 = select(t2, t1, b1);
    let t4 = select(t1, t2, b1) / select(t3, 1.0, t3 == 0.0);
    let t5 = t4 * 0.125;
    let t6 = select(1.0, 0.0, t5 < 0.125) + select(1.0, 0.0, t5 < 0.375);
    let t7 = t6 + select(1.0, 0.0, t5 < 0.625) + select(1.0, 0.0, t5 < 0.875);
    let b2 = t7 == 1.0;
    let b3 = t7 == 2.0;
    let b4 = t7 == 3.0;
    let b5 = b2 || b4;
    let t8 = t5 - t7 * 0.25;
    let t9 = t8 * t8;
    let t10 = t9 * (-41.341675 + t9 * (81.59394 + t9 * -75.4534));
    let t11 = t8 * 6.2831855 + t8 * (-1.7484555e-07 + t10);
    let t12 = t9 * (64.93932 + t9 * (-85.44374 + t9 * 59.245964));
    let t13 = 1.0 + t9 * (-19.739208 + t12);
    let t14 = select(t13, t11, b5);
    let t15 = select(t14, -t14, b2 || b3);
    let t16 = select(t11, t13, b5);
    let t17 = select(t16, -t16, b3 || b4);
    return vec2f(t3 * select(t17, t15, b1), t3 * select(t15, t17, b1));
}

fn square_to_uniform_hemisphere(u: vec2f) -> vec3f {
    let t1 = sqrt(u.x * (2.0 - u.x));
    let t2 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t3 = t2 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b1 = t3 == 1.0;
    let b2 = t3 == 2.0;
    let b3 = t3 == 3.0;
    let b4 = b1 || b3;
    let t4 = u.y - t3 * 0.25;
    let t5 = t4 * t4;
    let t6 = t5 * (-41.341675 + t5 * (81.59394 + t5 * -75.4534));
    let t7 = t4 * 6.2831855 + t4 * (-1.7484555e-07 + t6);
    let t8 = t5 * (64.93932 + t5 * (-85.44374 + t5 * 59.245964));
    let t9 = 1.0 + t5 * (-19.739208 + t8);
    let t10 = select(t9, t7, b4);
    let t11 = select(t7, t9, b4);
    return vec3f(t1 * select(t10, -t10, b1 || b2), t1 * select(t11, -t11, b2 || b3), 1.0 - u.x);
}

fn uniform_hemisphere_to_square(w: vec3f) -> vec2f {
    let t1 = atan2(w.y, w.x) * 0.15915494;
    let t2 = select(t1, t1 + 1.0, t1 < 0.0);
    return vec2f((w.x * w.x + w.y * w.y) / (1.0 + w.z), select(0.0, t2, t2 < 1.0));
}

fn square_to_cosine_hemisphere(u: vec2f) -> vec3f {
    let t1 = sqrt(u.x);
    let t2 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t3 = t2 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b1 = t3 == 1.0;
    let b2 = t3 == 2.0;
    let b3 = t3 == 3.0;
    let b4 = b1 || b3;
    let t4 = u.y - t3 * 0.25;
    let t5 = t4 * t4;
    let t6 = t5 * (-41.341675 + t5 * (81.59394 + t5 * -75.4534));
    let t7 = t4 * 6.2831855 + t4 * (-1.7484555e-07 + t6);
    let t8 = t5 * (64.93932 + t5 * (-85.44374 + t5 * 59.245964));
    let t9 = 1.0 + t5 * (-19.739208 + t8);
    let t10 = select(t9, t7, b4);
    let t11 = select(t7, t9, b4);
    return vec3f(t1 * select(t10, -t10, b1 || b2), t1 * select(t11, -t11, b2 || b3), sqrt(1.0 - u.x));
}

fn cosine_hemisphere_to_square(w: vec3f) -> vec2f {
    let t1 = atan2(w.y, w.x) * 0.15915494;
    let t2 = select(t1, t1 + 1.0, t1 < 0.0);
    return vec2f(w.x * w.x + w.y * w.y, select(0.0, t2, t2 < 1.0));
}

fn cosine_hemisphere_pdf(w: vec3f) -> f32 {
    return max(w.z, 0.0) * 0.31830987;
}
