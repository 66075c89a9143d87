"""BRDFs over arrays against closed forms, and against bpt."""

import json
import subprocess
import threading
import time

import granada
import numpy as np
import pytest
from conftest import upper_directions


def ward(wi, wo, sx, sy, ks, kd):
    """Ward (1992), "Measuring and modeling anisotropic reflection", equation 5a, with tan(delta) of the half vector."""
    h = wi + wo
    exponent = (h[..., 0] / sx) ** 2 + (h[..., 1] / sy) ** 2
    lobe = np.exp(-exponent / h[..., 2] ** 2) / (4 * np.pi * sx * sy * np.sqrt(wi[..., 2] * wo[..., 2]))
    return kd / np.pi + ks * lobe


def test_diffuse_is_kd_over_pi():
    brdf = granada.BRDF("diffuse kd=(0.2, 0.4, 0.8)")
    values = brdf.eval(upper_directions(100, 1, 0.01), upper_directions(100, 2, 0.01))
    assert values.shape == (100, 3) and values.dtype == np.float32
    np.testing.assert_allclose(values, np.tile([0.2, 0.4, 0.8], (100, 1)) / np.pi, rtol=1e-6)


def test_ward_is_the_published_formula():
    wi = upper_directions(1000, 3, 0.2).astype(np.float64)
    wo = upper_directions(1000, 4, 0.2).astype(np.float64)
    values = granada.BRDF("ward sx=0.1 sy=0.3 ks=0.4 kd=0.2").eval(wi, wo)
    expected = ward(wi, wo, 0.1, 0.3, 0.4, 0.2)
    np.testing.assert_allclose(values[:, 1], expected, rtol=2e-4)
    assert expected.max() > 2 * expected.min()  # the lobe was met


@pytest.mark.parametrize("text", ["ggx ax=0.2 ay=0.4", "strauss s=0.76 m=0.91"])
def test_values_are_those_of_bpt(programs, text):
    angles = np.random.default_rng(5).uniform([0, 0, 0, 0], [1.5, 6, 1.5, 6], (50, 4))
    sine, cosine = np.sin(angles[:, 0::2]), np.cos(angles[:, 0::2])
    directions = np.stack([sine * np.cos(angles[:, 1::2]), sine * np.sin(angles[:, 1::2]), cosine], axis=-1)
    lines = "\n".join(" ".join(f"{angle:.17g}" for angle in row) for row in angles)
    run = subprocess.run([programs / "bpt", "brdf", "eval", text, "--json"], input=lines, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    of_bpt = np.array(json.loads(run.stdout)["values"])
    values = granada.BRDF(text).eval(directions[:, 1], directions[:, 0])
    np.testing.assert_allclose(values, of_bpt, rtol=1e-5)
    if text.startswith("strauss"):  # which is not reciprocal: light and eye are not mixed up
        assert not np.allclose(granada.BRDF(text).eval(directions[:, 0], directions[:, 1]), of_bpt, rtol=1e-2)


@pytest.mark.parametrize("text", ["ward sx=0.1 sy=0.3", "oren", "ashikhmin"])
def test_is_reciprocal(text):
    wi, wo = upper_directions(500, 6, 0.1), upper_directions(500, 7, 0.1)
    brdf = granada.BRDF(text)
    np.testing.assert_allclose(brdf.eval(wi, wo), brdf.eval(wo, wi), rtol=1e-3, atol=1e-6)


def test_broadcasts_as_numpy_does():
    brdf = granada.BRDF("ward sx=0.3")
    wi = upper_directions(12, 8, 0.1).reshape(3, 4, 3)
    wo = upper_directions(4, 9, 0.1)
    values = brdf.eval(wi, wo)
    assert values.shape == (3, 4, 3)
    for i, k in np.ndindex(3, 4):
        np.testing.assert_array_equal(values[i, k], brdf.eval(wi[i, k], wo[k]))
    outer = brdf.eval(wi[:, :1], wo[None])
    np.testing.assert_array_equal(outer[2, 3], brdf.eval(wi[2, 0], wo[3]))
    assert brdf.pdf(wi, wo).shape == (3, 4)
    assert brdf.eval(wi[::2, ::-1], wo).shape == (2, 4, 3)
    np.testing.assert_array_equal(brdf.eval(wi[::2, ::-1], wo)[1, 0], values[2, 3] * 0 + brdf.eval(wi[2, 3], wo[0]))
    assert brdf.eval(np.empty((0, 3)), wo[0]).shape == (0, 3)
    assert brdf.eval([0, 0, 1], [0, 0, 1]).shape == (3,)


def test_is_black_below_the_horizon():
    brdf = granada.BRDF("ward")
    below = upper_directions(10, 10, 0.1) * [1, 1, -1]
    above = upper_directions(10, 11, 0.1)
    assert not brdf.eval(below, above).any()
    assert not brdf.eval(above, below).any()
    assert not brdf.sample(below, np.full((10, 3), 0.5)).is_valid.any()


@pytest.mark.parametrize("scheme", ["own", "auto", "hemisphere exp=20", "diffuse", "adaptive"])
def test_samples_have_their_pdf(scheme):
    """Chi-square test over cells of equal solid angle, with the pdf integrated over each cell."""
    count, rings, sectors, inner = 200_000, 8, 16, 16
    brdf = granada.BRDF("ward sx=0.3 sy=0.5 ks=0.6 kd=0.3", scheme=scheme)
    wo = np.array([np.sin(0.6), 0, np.cos(0.6)])
    drawn = brdf.sample(wo, np.random.default_rng(12).random((count, 3)))
    wi = drawn.wi[drawn.is_valid]
    # A direction at the edge of a table's cell may be in the next one after rounding.
    assert np.isclose(drawn.pdf[drawn.is_valid], brdf.pdf(wi, wo), rtol=1e-3).mean() > 0.9999

    cosine = (np.arange(rings * inner) + 0.5) / (rings * inner)
    phi = (np.arange(sectors * inner) + 0.5) / (sectors * inner) * 2 * np.pi
    z, angle = np.meshgrid(cosine, phi, indexing="ij")
    sine = np.sqrt(1 - z**2)
    fine = brdf.pdf(np.stack([sine * np.cos(angle), sine * np.sin(angle), z], axis=-1), wo)
    cell = 2 * np.pi / (rings * sectors)
    expected = count * cell * fine.reshape(rings, inner, sectors, inner).mean(axis=(1, 3), dtype=np.float64)
    ring = np.minimum((wi[:, 2] * rings).astype(int), rings - 1)
    sector = (np.arctan2(wi[:, 1], wi[:, 0]) / (2 * np.pi) % 1 * sectors).astype(int) % sectors
    found = np.zeros((rings, sectors))
    np.add.at(found, (ring, sector), 1)
    large = expected > 20
    chi_square = ((found - expected)[large] ** 2 / expected[large]).sum()
    freedom = large.sum()
    assert freedom > 50
    # Five standard deviations of chi-square, and what the midpoint rule leaves.
    assert chi_square < freedom + 5 * np.sqrt(2 * freedom) + 0.2 * freedom


def test_mean_weight_is_the_albedo():
    brdf = granada.BRDF("phong n=20")
    theta = 0.7
    drawn = brdf.sample([np.sin(theta), 0, np.cos(theta)], np.random.default_rng(13).random((100_000, 3)))
    np.testing.assert_allclose(drawn.weight.mean(axis=0), brdf.albedo(theta), rtol=0.02)


def test_albedo_of_diffuse_is_kd():
    albedo = granada.BRDF("diffuse kd=0.7").albedo(np.linspace(0, 1.4, 5), samples=1024)
    assert albedo.shape == (5, 3)
    np.testing.assert_allclose(albedo, 0.7, rtol=1e-3)


def test_specular_part_is_apart():
    brdf = granada.BRDF("specular ks=0.9")
    wo = upper_directions(5, 14, 0.1)
    mirror = wo * [-1, -1, 1]
    assert not brdf.eval(mirror, wo).any()
    np.testing.assert_allclose(brdf.specular_weight(wo), 0.9, rtol=1e-6)
    drawn = brdf.sample(wo, np.full((5, 3), 0.3))
    assert drawn.is_specular.all()
    np.testing.assert_allclose(drawn.wi, mirror, rtol=1e-6)


def test_errors_have_a_place():
    with pytest.raises(granada.Error) as caught:
        granada.BRDF("ward sz=0.1")
    assert (caught.value.file, caught.value.line) == ("BRDF", 1)
    assert caught.value.column == 6
    assert "sz" in caught.value.message
    assert str(caught.value).startswith("BRDF:1:6: error: ")
    assert [entry.severity for entry in caught.value.diagnostics] == ["error"]
    with pytest.raises(granada.Error, match="did you mean 'ward'"):
        granada.BRDF("wrad")
    with pytest.raises(granada.Error, match="cannot sample"):
        granada.BRDF("ward", scheme="specular")


def test_wrong_arrays_are_refused():
    brdf = granada.BRDF("ward")
    with pytest.raises(ValueError, match=r"wi\[1\] is not a unit vector"):
        brdf.eval([[0, 0, 1], [0, 0, 2]], [0, 0, 1])
    with pytest.raises(ValueError, match=r"wo\[0\] is not a unit vector"):
        brdf.eval([0, 0, 1], [0, np.nan, 1])
    with pytest.raises(ValueError, match="last axis of wi"):
        brdf.eval([[0, 1]], [0, 0, 1])
    with pytest.raises(ValueError, match="broadcast"):
        brdf.eval(upper_directions(3, 1), upper_directions(4, 2))
    with pytest.raises(ValueError, match=r"u\[0\] is not in"):
        brdf.sample([0, 0, 1], [0.5, np.nan, 0.5])
    with pytest.raises(TypeError):
        brdf.eval("abc", [0, 0, 1])


def test_models_are_those_of_bpt(programs):
    run = subprocess.run([programs / "bpt", "brdf", "list", "--json"], capture_output=True, text=True, check=True)
    listed = json.loads(run.stdout)["models"]
    models = granada.models()
    assert [model["keyword"] for model in listed] == list(models)
    assert models["ward"]["parameters"]["sx"]["default"] == 0.2
    for keyword, model in models.items():
        if model["example"]:
            assert granada.BRDF(model["example"]).keyword == keyword


def test_other_threads_run_meanwhile():
    ticks = []
    has_ended = threading.Event()

    def tick():
        while not has_ended.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.monotonic()
    granada.BRDF("ggx").albedo(np.linspace(0, 1.5, 64), samples=200_000)
    end = time.monotonic()
    has_ended.set()
    thread.join()
    # With the lock held, none were between the two moments but near them.
    middle = [tick for tick in ticks if start + 0.25 * (end - start) < tick < start + 0.75 * (end - start)]
    assert end - start > 0.05 and len(middle) >= 3
