// Written by lobe 0.1.0
// Maps of the unit square and their inverses; u.x radial, u.y azimuthal, except in the concentric maps.
// Error in float: 3e-7.
precision highp float;

vec2 square_to_uniform_disk(vec2 u) {
    float t1 = sqrt(u.x);
    float t2 = u.y < 0.125 ? 0.0 : 1.0;
    float t3 = u.y < 0.375 ? 0.0 : 1.0;
    float t4 = u.y < 0.625 ? 0.0 : 1.0;
    float t5 = u.y < 0.875 ? 0.0 : 1.0;
    float t6 = t2 + t3 + t4 + t5;
    bool b1 = t6 == 1.0;
    bool b2 = t6 == 2.0;
    bool b3 = t6 == 3.0;
    bool b4 = b1 || b3;
    float t7 = u.y - t6 * 0.25;
    float t8 = t7 * t7;
    float t9 = t8 * (-41.341675 + t8 * (81.59394 + t8 * -75.4534));
    float t10 = t7 * 6.2831855 + t7 * (-1.7484555e-07 + t9);
    float t11 = t8 * (64.93932 + t8 * (-85.44374 + t8 * 59.245964));
    float t12 = 1.0 + t8 * (-19.739208 + t11);
    float t13 = b4 ? t10 : t12;
    float t14 = b1 || b2 ? -t13 : t13;
    float t15 = b4 ? t12 : t10;
    float t16 = b2 || b3 ? -t15 : t15;
    return vec2(t1 * t14, t1 * t16);
}

vec2 uniform_disk_to_square(vec2 p) {
    float t1 = atan(p.y, p.x) * 0.15915494;
    float t2 = t1 < 0.0 ? t1 + 1.0 : t1;
    float t3 = t2 < 1.0 ? t2 : 0.0;
    return vec2(p.x * p.x + p.y * p.y, t3);
}

vec2 square_to_uniform_disk_concentric(vec2 u) {
    bool b1 = min(u.x, 1.0 - u.x) < min(u.y, 1.0 - u.y);
    float t1 = 2.0 * u.x - 1.0;
    float t2 = 2.0 * u.y - 1.0;
    float t3 = b1 ? t1 : t2;
    float t4 = b1 ? t2 : t1;
    float t5 = t3 == 0.0 ? 1.0 : t3;
    float t6 = t4 / t5 * 0.125;
    float t7 = t6 < 0.125 ? 0.0 : 1.0;
    float t8 = t6 < 0.375 ? 0.0 : 1.0;
    float t9 = t6 < 0.625 ? 0.0 : 1.0;
    float t10 = t6 < 0.875 ? 0.0 : 1.0;
    float t11 = t7 + t8 + t9 + t10;
    bool b2 = t11 == 1.0;
    bool b3 = t11 == 2.0;
    bool b4 = t11 == 3.0;
    bool b5 = b2 || b4;
    float t12 = t6 - t11 * 0.25;
    float t13 = t12 * t12;
    float t14 = -41.341675 + t13 * (81.59394 + t13 * -75.4534);
    float t15 = t12 * 6.2831855 + t12 * (-1.7484555e-07 + t13 * t14);
    float t16 = 64.93932 + t13 * (-85.44374 + t13 * 59.245964);
    float t17 = 1.0 + t13 * (-19.739208 + t13 * t16);
    float t18 = b5 ? t15 : t17;
    float t19 = b2 || b3 ? -t18 : t18;
    float t20 = b5 ? t17 : t15;
    float t21 = b3 || b4 ? -t20 : t20;
    float t22 = b1 ? t19 : t21;
    float t23 = b1 ? t21 : t19;
    return vec2(t3 * t22, t3 * t23);
}

vec3 square_to_uniform_hemisphere(vec2 u) {
    float t1 = sqrt(u.x * (2.0 - u.x));
    float t2 = u.y < 0.125 ? 0.0 : 1.0;
    float t3 = u.y < 0.375 ? 0.0 : 1.0;
    float t4 = u.y < 0.625 ? 0.0 : 1.0;
    float t5 = u.y < 0.875 ? 0.0 : 1.0;
    float t6 = t2 + t3 + t4 + t5;
    bool b1 = t6 == 1.0;
    bool b2 = t6 == 2.0;
    bool b3 = t6 == 3.0;
    bool b4 = b1 || b3;
    float t7 = u.y - t6 * 0.25;
    float t8 = t7 * t7;
    float t9 = t8 * (-41.341675 + t8 * (81.59394 + t8 * -75.4534));
    float t10 = t7 * 6.2831855 + t7 * (-1.7484555e-07 + t9);
    float t11 = t8 * (64.93932 + t8 * (-85.44374 + t8 * 59.245964));
    float t12 = 1.0 + t8 * (-19.739208 + t11);
    float t13 = b4 ? t10 : t12;
    float t14 = b1 || b2 ? -t13 : t13;
    float t15 = b4 ? t12 : t10;
    float t16 = b2 || b3 ? -t15 : t15;
    return vec3(t1 * t14, t1 * t16, 1.0 - u.x);
}

vec2 uniform_hemisphere_to_square(vec3 w) {
    float t1 = atan(w.y, w.x) * 0.15915494;
    float t2 = t1 < 0.0 ? t1 + 1.0 : t1;
    float t3 = t2 < 1.0 ? t2 : 0.0;
    return vec2((w.x * w.x + w.y * w.y) / (1.0 + w.z), t3);
}

vec3 square_to_cosine_hemisphere(vec2 u) {
    float t1 = sqrt(u.x);
    float t2 = u.y < 0.125 ? 0.0 : 1.0;
    float t3 = u.y < 0.375 ? 0.0 : 1.0;
    float t4 = u.y < 0.625 ? 0.0 : 1.0;
    float t5 = u.y < 0.875 ? 0.0 : 1.0;
    float t6 = t2 + t3 + t4 + t5;
    bool b1 = t6 == 1.0;
    bool b2 = t6 == 2.0;
    bool b3 = t6 == 3.0;
    bool b4 = b1 || b3;
    float t7 = u.y - t6 * 0.25;
    float t8 = t7 * t7;
    float t9 = t8 * (-41.341675 + t8 * (81.59394 + t8 * -75.4534));
    float t10 = t7 * 6.2831855 + t7 * (-1.7484555e-07 + t9);
    float t11 = t8 * (64.93932 + t8 * (-85.44374 + t8 * 59.245964));
    float t12 = 1.0 + t8 * (-19.739208 + t11);
    float t13 = b4 ? t10 : t12;
    float t14 = b1 || b2 ? -t13 : t13;
    float t15 = b4 ? t12 : t10;
    float t16 = b2 || b3 ? -t15 : t15;
    return vec3(t1 * t14, t1 * t16, sqrt(1.0 - u.x));
}

vec2 cosine_hemisphere_to_square(vec3 w) {
    float t1 = atan(w.y, w.x) * 0.15915494;
    float t2 = t1 < 0.0 ? t1 + 1.0 : t1;
    float t3 = t2 < 1.0 ? t2 : 0.0;
    return vec2(w.x * w.x + w.y * w.y, t3);
}

float cosine_hemisphere_pdf(vec3 w) {
    return max(w.z, 0.0) * 0.31830987;
}
