"""What tests of the Python module share: directions, and scenes whose image is known."""

import os
import pathlib
import sys

import numpy as np
import pytest

# The folder of the sources stays as it is.
sys.dont_write_bytecode = True


def upper_directions(count, seed, lowest=0.0):
    """Returns unit vectors that are uniform on the hemisphere above a cosine, (count, 3), in float32."""
    random = np.random.default_rng(seed)
    cosine = random.uniform(lowest, 1, count)
    phi = random.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine**2)
    return np.stack([sine * np.cos(phi), sine * np.sin(phi), cosine], axis=-1).astype(np.float32)


# A cube about the origin, from -1 to 1.
CUBE = """
begin mesh
  {surface}
  begin vertexs
    (-1,-1,-1) (1,-1,-1) (1,1,-1) (-1,1,-1) (-1,-1,1) (1,-1,1) (1,1,1) (-1,1,1)
  end vertexs
  begin faces
    (0,3,2,1) (4,5,6,7) (0,1,5,4) (2,3,7,6) (1,2,6,5) (0,4,7,3)
  end faces
end mesh
"""


@pytest.fixture
def furnace(tmp_path):
    """An OP file of a white cube before a background of radiance 1: each pixel is 1."""
    (tmp_path / "furnace.grf").write_text(CUBE.format(surface="brdf diffuse kd=1"))
    path = tmp_path / "furnace.op"
    path.write_text(
        "BPT_Scene furnace.grf\nBPT_Viewer 3 2 4\nBPT_VLook 0 0 0\nBPT_Background 1 1 1\n"
        "BPT_Image_Resolution 24 16\nBPT_Samples 4\n"
    )
    return path


@pytest.fixture
def programs():
    """The folder of bpt and grfconvert."""
    return pathlib.Path(os.environ["GRANADA_PROGRAMS"])
