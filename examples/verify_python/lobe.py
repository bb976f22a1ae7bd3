"""lobe's judge of BRDFs for NumPy: one file beside the library lobe_verify.

    import lobe, numpy as np
    report = lobe.verify(lambda v, l: 0.8 / np.pi * l[:, 2] * (l[:, 2] > 0) * (v[:, 2] > 0))
    report.passed, report.findings

`python3 lobe.py` prints where it found the library.
"""
import ctypes
import json
import os
import pathlib
import sys

import numpy as np

__all__ = ["verify", "Report"]

_function = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)
_sampler = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_size_t, *[ctypes.c_void_p] * 5)


class _Brdf(ctypes.Structure):  # lobe_brdf of lobe/testkit/c.h
    _fields_ = [("data", ctypes.c_void_p), ("channels", ctypes.c_int), ("numbers", ctypes.c_int),
                ("f_cos", _function), ("sample", _sampler), ("pdf", _function)]


class _Options(ctypes.Structure):  # lobe_options
    _fields_ = [("name", ctypes.c_char_p), ("tolerance", ctypes.c_double), ("seed", ctypes.c_uint64)] + \
        [(name, ctypes.c_int) for name in ("thorough", "single_precision", "reciprocal", "lossless", "isotropic",
                                           "zero_below", "transmits")] + \
        [("eta", ctypes.c_double), ("radiance", ctypes.c_int)]


def _load():
    name = {"win32": "lobe_verify.dll", "darwin": "liblobe_verify.dylib"}.get(sys.platform, "liblobe_verify.so")
    here = pathlib.Path(__file__).resolve().parent
    tried = [os.environ.get("LOBE_VERIFY_LIBRARY"), here / name, here.parent.parent / "build/verify_python" / name]
    for path in filter(None, tried):
        if pathlib.Path(path).is_file():
            return str(path), ctypes.CDLL(str(path))
    raise ImportError(f"{name} is neither in LOBE_VERIFY_LIBRARY nor beside lobe.py: "
                      "cmake -DLOBE_BUILD_C_INTERFACE=ON builds it, as run.sh does")


_path, _library = _load()
_library.lobe_default_options.restype = _Options
_library.lobe_verify.restype = ctypes.c_void_p
_library.lobe_verify.argtypes = [ctypes.POINTER(_Brdf), ctypes.POINTER(_Options)]
for _name in ("lobe_text", "lobe_json", "lobe_junit"):
    getattr(_library, _name).restype = ctypes.c_char_p
    getattr(_library, _name).argtypes = [ctypes.c_void_p]
_library.lobe_error.restype = ctypes.c_char_p
_library.lobe_free.argtypes = [ctypes.c_void_p]


class Report:
    """What was found: `passed`, `text`, `checks` and `findings` (dictionaries), `json`, `junit`. True if all passed."""

    def __init__(self, text, json_text, junit):
        self.text, self.json, self.junit = text, json_text, junit
        self.checks = json.loads(json_text)["checks"]
        self.findings = [c for c in self.checks if not c["passed"]]
        self.passed = not self.findings

    def __bool__(self):
        return self.passed

    def __str__(self):
        return self.text

    def __repr__(self):
        return f"<lobe.Report: {'passed' if self.passed else 'FAILED: ' + ', '.join(c['id'] for c in self.findings)}>"


def _array(address, *shape):
    """Memory of the library as an array."""
    return np.frombuffer((ctypes.c_double * int(np.prod(shape))).from_address(address)).reshape(shape)


def _spectrum(values, count, channels, what):
    values = np.asarray(values, dtype=float)
    if values.shape not in ((count,), (count, channels)):
        raise ValueError(f"{what} has the shape {values.shape}, not ({count},) or ({count}, {channels})")
    return values.reshape(count, -1)


def verify(f_cos, sample=None, pdf=None, *, numbers=2, quiet=False, **options):
    """Judges a BRDF of array functions, prints the report, and returns it.

    f_cos(v, l):   f(v,l) cos(theta_l): n numbers, or n times as many as the spectrum has (16 at most).
    sample(v, u):  (l, weight, pdf); weight = f_cos/pdf; pdf 0 where a sample fails. u has `numbers` columns, 2 or 3.
    pdf(v, l):     n densities in 1/sr.

    v and l are arrays of n rows: unit vectors in tangent space, n = (0, 0, 1), pointing away from the surface.
    Options, as of the C++ kit (docs/verify.md): name, tolerance, seed, thorough, single_precision (directions are
    float32, and its rounding is forgiven), reciprocal, lossless, isotropic, zero_below, transmits, eta, radiance.
    What the functions raise is raised again.
    """
    raised = []

    def guarded(body):
        def call(*arguments):
            if raised:
                return 1
            try:
                # NaN and infinity are findings, not warnings
                with np.errstate(all="ignore"):
                    body(*arguments)
                return 0
            except BaseException as error:  # of Ctrl-C, too: nothing may pass through C
                raised.append(error)
                return 1
        return call

    up = np.array([[0.0, 0.0, 1.0], [0.6, 0.0, 0.8]])
    with np.errstate(all="ignore"):
        first = np.asarray(f_cos(up, up[::-1].copy()), dtype=float)
    if first.ndim not in (1, 2) or first.shape[0] != 2 or not 1 <= first.size // 2 <= 16:
        raise ValueError(f"f_cos has the shape {first.shape} for 2 directions, not (2,) or (2, 1 to 16)")
    channels = first.size // 2

    def c_f_cos(_, n, v, l, out):
        _array(out, n, channels)[:] = _spectrum(f_cos(_array(v, n, 3), _array(l, n, 3)), n, channels, "f_cos")

    def c_pdf(_, n, v, l, out):
        _array(out, n, 1)[:] = _spectrum(pdf(_array(v, n, 3), _array(l, n, 3)), n, 1, "pdf")

    def c_sample(_, n, v, u, l, weight, density):
        a, b, c = sample(_array(v, n, 3), _array(u, n, numbers))
        _array(l, n, 3)[:] = a
        _array(weight, n, channels)[:] = _spectrum(b, n, channels, "the weight of sample")
        _array(density, n, 1)[:] = _spectrum(c, n, 1, "the pdf of sample")

    c_options = _library.lobe_default_options()
    known = [field for field, *_ in _Options._fields_]
    for name, value in options.items():
        if name not in known:
            raise TypeError(f"there is no option {name!r}, but {', '.join(known)}")
        setattr(c_options, name, value.encode() if name == "name" else value)
    brdf = _Brdf(None, channels, numbers, _function(guarded(c_f_cos)),
                 _sampler(guarded(c_sample)) if sample else _sampler(), _function(guarded(c_pdf)) if pdf else _function())
    handle = _library.lobe_verify(ctypes.byref(brdf), ctypes.byref(c_options))
    try:
        if raised:
            raise raised[0]
        if not handle:
            raise ValueError(_library.lobe_error().decode())
        report = Report(*(f(handle).decode() for f in (_library.lobe_text, _library.lobe_json, _library.lobe_junit)))
    finally:
        _library.lobe_free(handle)
    if not quiet:
        print(report)
    return report


if __name__ == "__main__":
    print(_path)
