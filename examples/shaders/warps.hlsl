// Written by lobe 0.1.0
// Maps of the unit square and their inverses; u.x radial, u.y azimuthal, except in the concentric maps.
// Error in float: 3e-7.

float2 square_to_uniform_disk(float2 u) {
    const float t1 = sqrt(u.x);
    const float t2 = u.y < 0.125 ? 0.0 : 1.0;
    const float t3 = u.y < 0.375 ? 0.0 : 1.0;
    const float t4 = u.y < 0.625 ? 0.0 : 1.0;
    const float t5 = u.y < 0.875 ? 0.0 : 1.0;
    const float t6 = t2 + t3 + t4 + t5;
    const bool b1 = t6 == 1.0;
    const bool b2 = t6 == 2.0;
    const bool b3 = t6 == 3.0;
    const bool b4 = b1 || b3;
    const float t7 = u.y - t6 * 0.25;
    const float t8 = t7 * t7;
    const float t9 = t8 * (-41.341675 + t8 * (81.59394 + t8 * -75.4534));
    const float t10 = t7 * 6.2831855 + t7 * (-1.7484555e-07 + t9);
    const float t11 = t8 * (64.93932 + t8 * (-85.44374 + t8 * 59.245964));
    const float t12 = 1.0 + t8 * (-19.739208 + t11);
    const float t13 = b4 ? t10 : t12;
    const float t14 = b1 || b2 ? -t13 : t13;
    const float t15 = b4 ? t12 : t10;
    const float t16 = b2 || b3 ? -t15 : t15;
    return float2(t1 * t14, t1 * t16);
}

float2 uniform_disk_to_square(float2 p) {
    const float t1 = atan2(p.y, p.x) * 0.15915494;
    const float t2 = t1 < 0.0 ? t1 + 1.0 : t1;
    const float t3 = t2 < 1.0 ? t2 : 0.0;
    return float2(p.x * p.x + p.y * p.y, t3);
}

float2 square_to_uniform_disk_concentric(float2 u) {
    const bool b1 = min(u.x, 1.0 - u.x) < min(u.y, 1.0 - u.y);
    const float t1 = 2.0 * u.x - 1.0;
    const float t2 = 2.0 * u.y - 1.0;
    const float t3 = b1 ? t1 : t2;
    const float t4 = b1 ? t2 : t1;
    const float t5 = t3 == 0.0 ? 1.0 : t3;
    const float t6 = t4 / t5 * 0.125;
    const float t7 = t6 < 0.125 ? 0.0 : 1.0;
    const float t8 = t6 < 0.375 ? 0.0 : 1.0;
    const float t9 = t6 < 0.625 ? 0.0 : 1.0;
    const float t10 = t6 < 0.875 ? 0.0 : 1.0;
    const float t11 = t7 + t8 + t9 + t10;
    const bool b2 = t11 == 1.0;
    const bool b3 = t11 == 2.0;
    const bool b4 = t11 == 3.0;
    const bool b5 = b2 || b4;
    const float t12 = t6 - t11 * 0.25;
    const float t13 = t12 * t12;
    const float t14 = -41.341675 + t13 * (81.59394 + t13 * -75.4534);
    const float t15 = t12 * 6.2831855 + t12 * (-1.7484555e-07 + t13 * t14);
    const float t16 = 64.93932 + t13 * (-85.44374 + t13 * 59.245964);
    const float t17 = 1.0 + t13 * (-19.739208 + t13 * t16);
    const float t18 = b5 ? t15 : t17;
    const float t19 = b2 || b3 ? -t18 : t18;
    const float t20 = b5 ? t17 : t15;
    const float t21 = b3 || b4 ? -t20 : t20;
    const float t22 = b1 ? t19 : t21;
    const float t23 = b1 ? t21 : t19;
    return float2(t3 * t22, t3 * t23);
}

float3 square_to_uniform_hemisphere(float2 u) {
    const float t1 = sqrt(u.x * (2.0 - u.x));
    const float t2 = u.y < 0.125 ? 0.0 : 1.0;
    const float t3 = u.y < 0.375 ? 0.0 : 1.0;
    const float t4 = u.y < 0.625 ? 0.0 : 1.0;
    const float t5 = u.y < 0.875 ? 0.0 : 1.0;
    const float t6 = t2 + t3 + t4 + t5;
    const bool b1 = t6 == 1.0;
    const bool b2 = t6 == 2.0;
    const bool b3 = t6 == 3.0;
    const bool b4 = b1 || b3;
    const float t7 = u.y - t6 * 0.25;
    const float t8 = t7 * t7;
    const float t9 = t8 * (-41.341675 + t8 * (81.59394 + t8 * -75.4534));
    const float t10 = t7 * 6.2831855 + t7 * (-1.7484555e-07 + t9);
    const float t11 = t8 * (64.93932 + t8 * (-85.44374 + t8 * 59.245964));
    const float t12 = 1.0 + t8 * (-19.739208 + t11);
    const float t13 = b4 ? t10 : t12;
    const float t14 = b1 || b2 ? -t13 : t13;
    const float t15 = b4 ? t12 : t10;
    const float t16 = b2 || b3 ? -t15 : t15;
    return float3(t1 * t14, t1 * t16, 1.0 - u.x);
}

float2 uniform_hemisphere_to_square(float3 w) {
    const float t1 = atan2(w.y, w.x) * 0.15915494;
    const float t2 = t1 < 0.0 ? t1 + 1.0 : t1;
    const float t3 = t2 < 1.0 ? t2 : 0.0;
    return float2((w.x * w.x + w.y * w.y) / (1.0 + w.z), t3);
}

float3 square_to_cosine_hemisphere(float2 u) {
    const float t1 = sqrt(u.x);
    const float t2 = u.y < 0.125 ? 0.0 : 1.0;
    const float t3 = u.y < 0.375 ? 0.0 : 1.0;
    const float t4 = u.y < 0.625 ? 0.0 : 1.0;
    const float t5 = u.y < 0.875 ? 0.0 : 1.0;
    const float t6 = t2 + t3 + t4 + t5;
    const bool b1 = t6 == 1.0;
    const bool b2 = t6 == 2.0;
    const bool b3 = t6 == 3.0;
    const bool b4 = b1 || b3;
    const float t7 = u.y - t6 * 0.25;
    const float t8 = t7 * t7;
    const float t9 = t8 * (-41.341675 + t8 * (81.59394 + t8 * -75.4534));
    const float t10 = t7 * 6.2831855 + t7 * (-1.7484555e-07 + t9);
    const float t11 = t8 * (64.93932 + t8 * (-85.44374 + t8 * 59.245964));
    const float t12 = 1.0 + t8 * (-19.739208 + t11);
    const float t13 = b4 ? t10 : t12;
    const float t14 = b1 || b2 ? -t13 : t13;
    const float t15 = b4 ? t12 : t10;
    const float t16 = b2 || b3 ? -t15 : t15;
    return float3(t1 * t14, t1 * t16, sqrt(1.0 - u.x));
}

float2 cosine_hemisphere_to_square(float3 w) {
    const float t1 = atan2(w.y, w.x) * 0.15915494;
    const float t2 = t1 < 0.0 ? t1 + 1.0 : t1;
    const float t3 = t2 < 1.0 ? t2 : 0.0;
    return float2(w.x * w.x + w.y * w.y, t3);
}

float cosine_hemisphere_pdf(float3 w) {
    return max(w.z, 0.0) * 0.31830987;
}
