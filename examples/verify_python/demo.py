"""GGX in NumPy before the judge: right, then with the masking of one direction only, and the weight of another sampler."""
import time

import numpy as np

import lobe

ALPHA = 0.3
F0 = np.array([1.0, 0.71, 0.29])


def dot(a, b):
    return np.sum(a * b, axis=1)


def unit(w):
    return w / np.linalg.norm(w, axis=1, keepdims=True)


def D(m):  # Trowbridge & Reitz 1975, by the slope of the normal
    return ALPHA**2 / (np.pi * (m[:, 0]**2 + m[:, 1]**2 + (ALPHA * m[:, 2])**2)**2)


def area(w):  # cos(theta) (1 + 2 Lambda): 2 cos(theta)/G1 - cos(theta)
    return np.sqrt(ALPHA**2 * (w[:, 0]**2 + w[:, 1]**2) + w[:, 2]**2)


def G1(w):
    return 2 * w[:, 2] / (w[:, 2] + area(w))


def G2(v, l):  # correlated by height, Heitz 2014
    return 2 * v[:, 2] * l[:, 2] / (l[:, 2] * area(v) + v[:, 2] * area(l))


def brdf(v, l, masking=G2):  # f cos(theta_l)
    m = unit(v + l)
    F = F0 + (1 - F0) * (1 - dot(v, m)[:, None])**5
    above = (v[:, 2] > 0) & (l[:, 2] > 0)
    return np.where(above[:, None], F * (D(m) * masking(v, l) / (4 * v[:, 2]))[:, None], 0)


def pdf(v, l):  # of normals that are seen: G1 D / (4 n.v)
    above = (v[:, 2] > 0) & (l[:, 2] > 0)
    return np.where(above, G1(v) * D(unit(v + l)) / (4 * v[:, 2]), 0)


def sample(v, u):  # Dupuy & Benyoub 2023
    scale = np.array([ALPHA, ALPHA, 1])
    w = unit(v * scale)
    z = (1 - u[:, 0]) * (1 + w[:, 2]) - w[:, 2]
    sine, turn = np.sqrt(np.clip(1 - z**2, 0, 1)), 2 * np.pi * u[:, 1]
    m = unit((np.stack([sine * np.cos(turn), sine * np.sin(turn), z], axis=1) + w) * scale)
    l = 2 * dot(v, m)[:, None] * m - v
    density = pdf(v, l)
    return l, np.where(density[:, None] > 0, brdf(v, l) / density[:, None], 0), density


def mistaken(v, l):
    return brdf(v, l, masking=lambda v, l: G1(v) + 0 * l[:, 2])


for name, f in ("GGX, gold", brdf), ("GGX, masked for the viewer alone", mistaken):
    start = time.perf_counter()
    lobe.verify(f, sample=sample, pdf=pdf, name=name)
    print(f"{time.perf_counter() - start:.1f} s\n")
