// Written by lobe 0.1.0
// Split-sum terms of isotropic GGX with smith_correlated, four fits, and image-based light with all bounces.
// Domain: cos_v in [0.001,1], alpha in [0.0009,1]. Error of the albedo: tiny 2.8e-2, cheap 1.6e-2, medium 4.6e-3,
// precise 1.1e-3.

struct dfg_terms {
    float scale;
    float bias;
};

struct ibl_weights3 {
    float3 radiance;
    float3 irradiance;
};

dfg_terms dfg_tiny(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = cos_v + (5.9148107 * alpha + 1.3126427) * alpha;
    const float t3 = t2 + 0.0072317305;
    const float t4 = cos_v * t1 * (0.8215735 + 19.310698 * t1) * t3;
    const float t5 = t1 * alpha;
    const float t6 = cos_v * cos_v * cos_v + 21.320505 * t5 * cos_v;
    const float t7 = t6 + 6.755714 * t5;
    const float t8 = 1.0 / (t7 * t3);
    const float t9 = 1.0 - t4 * t8;
    const float t10 = (1.0574776 * cos_v + 1.3323929 * alpha) * cos_v;
    const float t11 = t10 + (3.0923212 * alpha + 0.03739872) * alpha;
    const float t12 = 1.0 - t11 * t7 * t8;
    const float t13 = t12 * t12;
    const float t14 = t9 * (t13 * t13 * t12);
    const dfg_terms returned = {t9 - t14, t14};
    return returned;
}

dfg_terms dfg_cheap(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = 0.4657219 + 9.989591 * t1 + 2.117033 * alpha * cos_v * cos_v;
    const float t3 = cos_v + (5.9148107 * alpha + 1.3126427) * alpha;
    const float t4 = t3 + 0.0072317305;
    const float t5 = t1 * alpha;
    const float t6 = cos_v * cos_v * cos_v + 13.935205 * t5 * cos_v;
    const float t7 = t6 + 2.885303 * t5;
    const float t8 = 1.0 / (t7 * t4);
    const float t9 = 1.0 - cos_v * t1 * t2 * t4 * t8;
    const float t10 = (1.0574776 * cos_v + 1.3323929 * alpha) * cos_v;
    const float t11 = t10 + (3.0923212 * alpha + 0.03739872) * alpha;
    const float t12 = 1.0 - t11 * t7 * t8;
    const float t13 = t12 * t12;
    const float t14 = t9 * (t13 * t13 * t12);
    const dfg_terms returned = {t9 - t14, t14};
    return returned;
}

dfg_terms dfg_medium(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = t1 * alpha;
    const float t3 = t1 * t1;
    const float t4 = 19.25841 * t2 + 0.2791325 - 4.4412456 * t3 * cos_v;
    const float t5 = cos_v * t1 * (t4 * cos_v + 6.3986063 * t1 + 0.7755784);
    const float t6 = (cos_v + (7.78157 * alpha + 3.184543) * alpha) * cos_v;
    const float t7 = sqrt(alpha);
    const float t8 = (1.8398677 * alpha + 3.3001425) * t7 + 0.4379561;
    const float t9 = t6 + t8 * (alpha * t7);
    const float t10 = (cos_v + 8.408655 * t3) * cos_v + (17.736061 * t1 + 3.5498514) * t1;
    const float t11 = (0.5351705 * t1 - 1.9557374) * alpha + 2.9557564;
    const float t12 = t10 * cos_v + t11 * t2;
    const float t13 = 1.0 / (t12 * t9);
    const float t14 = 1.0 - t5 * t9 * t13;
    const float t15 = (1.007147 * cos_v + 3.2703702 * alpha) * cos_v;
    const float t16 = (t15 + 6.58987 * t1) * cos_v + 2.587197 * (t1 * t7);
    const float t17 = 1.0 - t16 * t12 * t13;
    const float t18 = t17 * t17;
    const float t19 = t14 * (t18 * t18 * t17);
    const dfg_terms returned = {t14 - t19, t19};
    return returned;
}

dfg_terms dfg_precise(float cos_v, float alpha) {
    const float t1 = alpha * alpha;
    const float t2 = (-80.92356 * alpha + 159.31013) * alpha - 68.58001;
    const float t3 = (13.252991 * alpha + 47.883152) * alpha + 23.356142;
    const float t4 = (t2 * alpha + 23.680496) * alpha * cos_v + (t3 * t1 + 3.272493);
    const float t5 = t4 * cos_v + (3.1924329 * alpha - 0.30789798) * alpha;
    const float t6 = sqrt(alpha);
    const float t7 = ((3.574554 * t6 + 2.947536) * t6 + 1.1579635) * alpha;
    const float t8 = (0.71944004 * alpha + 0.6703227) * t6 + 0.06690896;
    const float t9 = (cos_v + t7) * cos_v + t8 * (alpha * t6);
    const float t10 = (4.6752467 - alpha) * cos_v + 19.079456 * t1 + 0.16968752;
    const float t11 = (24.166279 * alpha + 86.77667) * t1 + 11.586927;
    const float t12 = (22.483315 * alpha + 10.312562) * alpha + 0.39994174;
    const float t13 = ((t10 * cos_v + t11 * t1) * cos_v + t12 * t1) * cos_v;
    const float t14 = t13 + 0.4846967 * (t1 * alpha);
    const float t15 = 1.0 / (t14 * t9);
    const float t16 = 1.0 - cos_v * t1 * (t5 + 0.1134351) * t9 * t15;
    const float t17 = (-1.996815 * t6 + 2.612494) * alpha + 1.4740415;
    const float t18 = (0.9968305 * cos_v + t17 * alpha) * cos_v + 4.242914 * t1;
    const float t19 = t18 * cos_v + (0.2249494 * t6 + 0.43820956) * (t1 * t6);
    const float t20 = 1.0 - t19 * t14 * t15;
    const float t21 = t20 * t20;
    const float t22 = t16 * (t21 * t21 * t20);
    const dfg_terms returned = {t16 - t22, t22};
    return returned;
}

// radiance: of the prefiltered environment, irradiance: of irradiance/pi.
ibl_weights3 ibl_all_bounces(float cos_v, float alpha, float3 F0) {
    const float t1 = alpha * alpha;
    const float t2 = (-80.92356 * alpha + 159.31013) * alpha - 68.58001;
    const float t3 = (13.252991 * alpha + 47.883152) * alpha + 23.356142;
    const float t4 = (t2 * alpha + 23.680496) * alpha * cos_v + (t3 * t1 + 3.272493);
    const float t5 = t4 * cos_v + (3.1924329 * alpha - 0.30789798) * alpha;
    const float t6 = sqrt(alpha);
    const float t7 = ((3.574554 * t6 + 2.947536) * t6 + 1.1579635) * alpha;
    const float t8 = (0.71944004 * alpha + 0.6703227) * t6 + 0.06690896;
    const float t9 = (cos_v + t7) * cos_v + t8 * (alpha * t6);
    const float t10 = (4.6752467 - alpha) * cos_v + 19.079456 * t1 + 0.16968752;
    const float t11 = (24.166279 * alpha + 86.77667) * t1 + 11.586927;
    const float t12 = (22.483315 * alpha + 10.312562) * alpha + 0.39994174;
    const float t13 = ((t10 * cos_v + t11 * t1) * cos_v + t12 * t1) * cos_v;
    const float t14 = t13 + 0.4846967 * (t1 * alpha);
    const float t15 = 1.0 / (t14 * t9);
    const float t16 = 1.0 - cos_v * t1 * (t5 + 0.1134351) * t9 * t15;
    const float t17 = (-1.996815 * t6 + 2.612494) * alpha + 1.4740415;
    const float t18 = (0.9968305 * cos_v + t17 * alpha) * cos_v + 4.242914 * t1;
    const float t19 = t18 * cos_v + (0.2249494 * t6 + 0.43820956) * (t1 * t6);
    const float t20 = 1.0 - t19 * t14 * t15;
    const float t21 = t20 * t20;
    const float t22 = t16 * (t21 * t21 * t20);
    const float t23 = t16 - t22;
    const float t24 = 1.0 - (t23 + t22);
    const float3 w1 = (1.0 - F0) * exp(-2.75 * pow(alpha, 0.65) - 1.59 * cos_v);
    const float3 w2 = F0 + w1;
    const float t25 = t24 * (0.49 + 0.19 * t24);
    const float3 w3 = t24 * w2 * w2 * (1.0 - t25) / (1.0 - t25 * w2);
    const float t26 = min(max((alpha - 0.1) * 5.0, 0.0), 1.0);
    const float t27 = t26 * t26 * (3.0 - 2.0 * t26);
    const ibl_weights3 returned = {F0 * t23 + t22 + w3 * (1.0 - t27), w3 * t27};
    return returned;
}
