"""Renders to arrays."""

import os
import signal
import threading
import time

import granada
import numpy as np
import pytest


def test_a_white_furnace_is_one(furnace):
    render = granada.render(furnace)
    assert render.image.shape == (16, 24, 3) and render.image.dtype == np.float32
    np.testing.assert_allclose(render.image, 1, atol=0.02)
    assert (render.end, render.samples_per_pixel, render.layers) == ("samples", 4, {})
    assert render.rejected_samples == 0 and render.rays > 24 * 16


def test_options_override_the_file(furnace):
    render = granada.render(furnace, samples=2, size=(8, 6), background=(0, 0, 0), threads=1)
    assert render.image.shape == (6, 8, 3) and render.samples_per_pixel == 2
    assert not render.image.any()
    assert granada.render(furnace, background=[0.25, 0.5, 1]).image[0, 0].tolist() == [0.25, 0.5, 1]


def test_layers_are_arrays(furnace):
    layers = granada.render(furnace, layers=["albedo", "normal", "depth", "variance", "samples"]).layers
    assert {name: layer.shape[2:] for name, layer in layers.items()} == {
        "albedo": (3,),
        "normal": (3,),
        "depth": (),
        "variance": (3,),
        "samples": (),
    }
    # The corner pixel shows the background, the middle one the cube.
    assert np.isinf(layers["depth"][0, 0])
    distance = np.linalg.norm([3, 2, 4])
    assert distance - np.sqrt(3) < layers["depth"][8, 12] < distance
    np.testing.assert_allclose(layers["albedo"][8, 12], 1, atol=0.01)
    assert (layers["samples"] == 4).all()
    assert (layers["variance"] < 1e-3).all()


def test_the_error_is_stated(furnace):
    # A lamp's penumbra is noisy.
    render = granada.render(furnace, samples=16, without="background", layers="error")
    assert not render.image.any()
    render = granada.render(furnace, samples=16)
    low, high = render.error_interval
    assert low <= render.error <= high


def test_the_same_seed_gives_the_same_image(furnace):
    first, second, other = (granada.render(furnace, seed=seed, samples=2).image for seed in (1, 1, 2))
    np.testing.assert_array_equal(first, second)
    assert first.shape == other.shape


def test_progress_is_told(furnace):
    told = []
    granada.render(furnace, size=(200, 200), samples=64, progress=lambda state: told.append((state.done, state.image())))
    done = [state for state, _ in told]
    assert done == sorted(done) and done[-1] == 1 and len(done) >= 2
    assert told[-1][1].shape == (200, 200, 3)
    np.testing.assert_allclose(told[-1][1], 1, atol=0.02)


def test_a_callback_stops(furnace):
    render = granada.render(furnace, samples=10_000_000, time=60, progress=lambda state: state.done < 0)
    assert render.end == "stopped" and render.image.shape == (16, 24, 3)


def test_an_exception_passes_through(furnace):
    def fail(state):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        granada.render(furnace, samples=10_000_000, time=60, progress=fail)


def test_control_c_ends_a_render(furnace):
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    start = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        granada.render(furnace, samples=10_000_000, time=60)
    timer.join()
    assert time.monotonic() - start < 50


def test_a_time_limit_ends_a_render(furnace):
    assert granada.render(furnace, samples=10_000_000, time=0.2).end == "time"


def test_wrong_options_are_refused(furnace):
    with pytest.raises(TypeError, match="did you mean 'samples'"):
        granada.render(furnace, sampels=3)
    with pytest.raises(ValueError, match="samples: "):
        granada.render(furnace, samples=0)
    with pytest.raises(ValueError, match="size: "):
        granada.render(furnace, size=3)
    with pytest.raises(TypeError, match="no option 'output'"):
        granada.render(furnace, output="x.png")
    with pytest.raises(ValueError, match="frame=1"):
        granada.render(furnace, frames=3)


def test_a_broken_option_file_has_a_place(tmp_path):
    path = tmp_path / "broken.op"
    path.write_text("BPT_Scene broken.grf\nBPT_Samples many\n")
    with pytest.raises(granada.Error) as caught:
        granada.render(path)
    assert (caught.value.file, caught.value.line) == (str(path), 2)


def test_images_are_written_and_read(tmp_path):
    image = np.random.default_rng(1).uniform(0, 4, (5, 7, 3)).astype(np.float32)
    granada.write_image(tmp_path / "image.pfm", image)
    np.testing.assert_array_equal(granada.read_image(tmp_path / "image.pfm"), image)
    granada.write_image(tmp_path / "grey.png", np.full((2, 2, 3), 0.5))
    # IEC 61966-2-1: 0.5 is 187.5 of 255.
    np.testing.assert_allclose(granada.read_image(tmp_path / "grey.png"), 0.5, atol=0.01)
    with pytest.raises(ValueError, match="shape"):
        granada.write_image(tmp_path / "image.pfm", image[0])
    with pytest.raises(granada.Error):
        granada.read_image(tmp_path / "none.png")
