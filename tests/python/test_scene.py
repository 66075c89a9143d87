"""Scenes and their meshes as arrays."""

import json
import os
import subprocess

import granada
import numpy as np
import pytest
from conftest import CUBE

TWO_SURFACES = """
def gold = brdf ward sx=0.1
begin
transform scale (2, 2, 2) translation (1, 0, 0) begin
  begin mesh "roof"
    brdf gold
    begin vertexs
      (0, 0, 0)
      (1, 0, 0)
      (1, 1, 0)
      (0, 1, 0)
      (0.5, 2, 0)
    end vertexs
    begin faces
      (0, 1, 2, 3)
      light rgb (1, 2, 3)
      (3, 2, 4)
    end faces
  end mesh
end
end
"""


@pytest.fixture
def cube(tmp_path):
    path = tmp_path / "cube.grf"
    path.write_text(CUBE.format(surface="brdf ward sx=0.2"))
    return path


def test_reads_a_cube(cube):
    scene = granada.read(cube)
    assert (scene.format, scene.path) == ("grf", str(cube))
    facts = scene.summary()
    assert (facts["vertices"], facts["faces"], facts["triangles"], facts["area"]) == (8, 6, 12, 24)
    np.testing.assert_array_equal(facts["bounds"], [[-1, -1, -1], [1, 1, 1]])
    (mesh,) = scene.meshes
    assert mesh.positions.shape == (8, 3) and mesh.positions.dtype == np.float32
    np.testing.assert_array_equal(mesh.faces[1], [4, 5, 6, 7])
    np.testing.assert_array_equal(mesh.face_offsets, np.arange(0, 25, 4))
    np.testing.assert_array_equal(np.bincount(mesh.face_of_triangle), np.full(6, 2))
    corners = mesh.positions[mesh.triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    assert area.sum() == pytest.approx(24)
    assert mesh.normals is None and mesh.uvs is None and mesh.colours is None
    assert [surface.text for surface in mesh.surfaces] == ["brdf ward sx=0.2"]
    assert mesh.surfaces[0].brdf == "ward sx=0.2"


def test_arrays_outlive_the_scene_and_cannot_be_written(cube):
    positions = granada.read(cube).meshes[0].positions
    assert positions.sum() == 0 and abs(positions).sum() == 24
    with pytest.raises(ValueError, match="read-only"):
        positions[0] = 0


def test_resolves_surfaces_and_transforms():
    scene = granada.read_text(TWO_SURFACES)
    (mesh,) = scene.meshes
    assert mesh.name == "roof"
    np.testing.assert_array_equal(mesh.surface_of_face, [0, 1])
    plain, lamp = mesh.surfaces
    assert (plain.text, plain.brdf, plain.emission) == ("brdf gold", "ward sx=0.1", None)
    assert lamp.emission == (1, 2, 3)
    np.testing.assert_array_equal(mesh.world_positions, 2 * mesh.positions + [1, 0, 0])
    np.testing.assert_array_equal(mesh.to_world @ [1, 1, 0, 1], [3, 2, 0, 1])
    with pytest.raises(ValueError, match="different numbers of corners"):
        mesh.faces
    np.testing.assert_array_equal(mesh.corners, [0, 1, 2, 3, 3, 2, 4])


def test_vertices_without_an_attribute_are_nan():
    text = CUBE.format(surface="brdf diffuse").replace("(-1,-1,-1)", "normal (0,0,-1) (-1,-1,-1)", 1)
    normals = granada.read_text(text).meshes[0].normals
    np.testing.assert_array_equal(normals[0], [0, 0, -1])
    assert np.isnan(normals[1:]).all()


def test_writes_what_it_read(cube, tmp_path):
    scene = granada.read(cube)
    assert scene.write(tmp_path / "copy.grf") == []
    assert granada.read(tmp_path / "copy.grf").text == scene.text
    losses = scene.write(tmp_path / "cube.stl")
    assert any("BRDF" in loss.message for loss in losses)
    assert granada.read(tmp_path / "cube.stl").summary()["area"] == 24


def test_converts_as_grfconvert_does(cube, tmp_path, programs):
    granada.convert(cube, tmp_path / "here.obj")
    subprocess.run([programs / "grfconvert", cube, "-o", tmp_path / "there.obj", "--quiet"], check=True)
    here, there = ((tmp_path / name).read_text() for name in ("here.obj", "there.obj"))
    assert here.replace("here", "there") == there
    of_program = subprocess.run(
        [programs / "grfconvert", "info", "--json", cube], check=True, capture_output=True, text=True
    )
    facts = json.loads(of_program.stdout)
    summary = granada.read(cube).summary()
    for name in set(summary) - {"bounds"}:
        assert summary[name] == facts[name], name


def test_a_broken_file_has_a_place(tmp_path):
    path = tmp_path / "broken.grf"
    path.write_text(CUBE.format(surface="brdf wrad sx=0.2"))
    with pytest.raises(granada.Error) as caught:
        granada.read(path)
    assert (caught.value.file, caught.value.line, caught.value.column) == (str(path), 3, 8)
    assert "did you mean 'ward'" in caught.value.message
    report = granada.check(path)
    assert not report and not report.valid
    assert [(entry.severity, entry.line) for entry in report.diagnostics] == [("error", 3)]


def test_a_missing_file_is_an_error(tmp_path):
    with pytest.raises(granada.Error) as caught:
        granada.read(tmp_path / "none.grf")
    assert caught.value.file == str(tmp_path / "none.grf") and caught.value.line is None


def test_paths_may_have_any_bytes(tmp_path):
    path = os.fsdecode(os.fsencode(tmp_path) + b"/\xff.grf")
    with open(path, "w") as file:
        file.write(CUBE.format(surface="brdf diffuse"))
    assert granada.read(path).path == path
    with pytest.raises(granada.Error) as caught:
        granada.read(path + "f")
    assert caught.value.file == path + "f"


def test_wrong_formats_are_refused(cube, tmp_path):
    with pytest.raises(ValueError, match="did you mean 'obj'"):
        granada.read(cube, format="obk")
    with pytest.raises(ValueError, match="unknown"):
        granada.read(cube).write(tmp_path / "cube.unknown")
    with pytest.raises(ValueError, match="cannot be written"):
        granada.convert(cube, tmp_path / "cube.3ds")
    assert not (tmp_path / "cube.3ds").exists()


def test_finds_risks(tmp_path):
    path = tmp_path / "risky.grf"
    path.write_text(CUBE.format(surface="brdf diffuse") * 2)
    assert granada.check(path).risks == []
    assert "duplicate_mesh" in [risk["kind"] for risk in granada.check(path, deep=True).risks]
