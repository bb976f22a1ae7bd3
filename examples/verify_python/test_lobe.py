"""The module lobe: shapes, options, what the functions raise, and verdicts."""
import unittest

import numpy as np

import lobe


def matt(v, l, albedo=0.8):
    return np.where((v[:, 2] > 0) & (l[:, 2] > 0), albedo / np.pi * l[:, 2], 0)


def by_cosine(v, u):
    r, turn = np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]
    l = np.stack([r * np.cos(turn), r * np.sin(turn), np.sqrt(1 - u[:, 0])], axis=1)
    return l, np.full(len(u), 0.8), l[:, 2] / np.pi


def ids(report):
    return {c["id"] for c in report.findings}


class Module(unittest.TestCase):
    def test_a_right_one_passes(self):
        report = lobe.verify(matt, quiet=True, name="matt")
        self.assertTrue(report)
        self.assertIn("matt: passed", report.text)
        self.assertIn("<testsuite name=\"matt\"", report.junit)
        self.assertEqual(repr(report), "<lobe.Report: passed>")

    def test_sampler_and_density(self):
        pdf = lambda v, l: np.maximum(l[:, 2], 0) / np.pi
        self.assertTrue(lobe.verify(matt, by_cosine, pdf, quiet=True, isotropic=True))
        self.assertTrue(lobe.verify(matt, lambda v, u: by_cosine(v, u[:, 1:]), pdf, numbers=3, quiet=True))
        self.assertIn("samples_follow_pdf", ids(lobe.verify(matt, by_cosine, lambda v, l: pdf(v, l)**2 * 1.5, quiet=True)))

    def test_spectra(self):
        colour = np.array([0.9, 0.5, 1.2, 0.1])
        for n in 1, 2, 3, 4:
            report = lobe.verify(lambda v, l: matt(v, l)[:, None] / 0.8 * colour[:n], quiet=True)
            self.assertEqual(ids(report), {"white_furnace", "white_furnace_of_light"} if n > 2 else set(), n)

    def test_options(self):
        self.assertIn("white_furnace", ids(lobe.verify(matt, quiet=True, lossless=True)))
        self.assertIn("glm::vec3", lobe.verify(lambda v, l: 2 * matt(v, l), quiet=True, single_precision=True).text)
        with self.assertRaisesRegex(TypeError, "no option 'lossles', but name, "):
            lobe.verify(matt, lossles=True)
        self.assertIn("tolerance", ids(lobe.verify(matt, quiet=True, tolerance=0)))
        with self.assertRaisesRegex(ValueError, "2 or 3"):
            lobe.verify(matt, numbers=4)

    def test_findings(self):
        self.assertIn("steady", ids(lobe.verify(lambda v, l: matt(v, l) * np.random.uniform(0.5, 1, len(l)), quiet=True)))
        self.assertIn("reciprocity", ids(lobe.verify(lambda v, l: matt(v, l) * v[:, 2], quiet=True)))
        self.assertIn("f_cos_finite", ids(lobe.verify(lambda v, l: matt(v, l) / (v[:, 2] > 0.2), quiet=True)))

    def test_what_functions_raise(self):
        def raises(v, l):
            if len(v) != 2:
                raise KeyError("mine")
            return matt(v, l)
        with self.assertRaisesRegex(KeyError, "mine"):
            lobe.verify(raises, quiet=True)
        with self.assertRaisesRegex(ValueError, r"f_cos has the shape \(3,\)"):
            lobe.verify(lambda v, l: np.zeros(3))
        with self.assertRaisesRegex(ValueError, "the pdf of sample has the shape"):
            lobe.verify(matt, lambda v, u: (*by_cosine(v, u)[:2], 1.0), quiet=True)


unittest.main()
