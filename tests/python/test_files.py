# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls in files: exact round trips, every kind of bad file, nothing left behind by a failure."""

import locale
import os
import pathlib
import resource
import signal
import struct
import subprocess
import sys
import xml.etree.ElementTree

import numpy as np
import pytest
import vbm

import models

CENTERS = np.array([[0, 0, 0], [1 / 3, -2e-300, 1e300], [5e-324, -0.0, 123456789.123456789], [1, 2, 3]])
RADII = np.array([1, 0.1, 0, 1e-308])
TRIANGLES = np.array([[0, 1, 2], [3, 2, 1]], np.int32)
EDGES = np.array([[0, 3]], np.int32)
EXTRA = {"part": np.array([0, -1, 7, 2147483647], np.int32), "level": np.array([1, 2, 3, 4], np.int32)}


def same(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


@pytest.mark.parametrize("kind", ["ply", "csv", "ma"])
def test_round_trip(tmp_path, kind):
    path = tmp_path / f"balls.{kind}"
    faces = dict(triangles=TRIANGLES, edges=EDGES) if kind != "csv" else {}
    extra = dict(attributes=EXTRA) if kind != "ma" else {}
    vbm.write_balls(path, CENTERS, RADII, **faces, **extra)
    balls = vbm.read_balls(path)
    assert same(balls.centers, CENTERS) and same(balls.radii, RADII)
    assert same(balls.triangles, faces.get("triangles", np.empty((0, 3), np.int32)))
    sides = np.array([[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]], np.int32)  # which readers of medial meshes expect
    assert same(balls.edges, {"ply": EDGES, "csv": np.empty((0, 2), np.int32),
                              "ma": np.concatenate([EDGES, sides])}[kind])
    assert {k: v.tolist() for k, v in balls.attributes.items()} == \
        {k: v.tolist() for k, v in extra.get("attributes", {}).items()}
    first = path.read_bytes()
    vbm.write_balls(str(path), *balls[:2], *(balls[2:4] if kind != "csv" else ()),
                    **({"attributes": balls.attributes} if kind != "ma" else {}))
    assert path.read_bytes() == first
    assert os.listdir(tmp_path) == [path.name]


@pytest.mark.parametrize("kind", ["ply", "csv", "ma"])
def test_random_numbers_and_no_balls(tmp_path, kind):
    random = np.random.default_rng(0)
    bits = random.integers(0, 2**63, 4000).view(np.float64)
    numbers = bits[np.isfinite(bits)][:3996].reshape(-1, 4)
    path = tmp_path / f"b.{kind}"
    vbm.write_balls(path, numbers[:, :3], np.abs(numbers[:, 3]))
    balls = vbm.read_balls(path)
    assert same(balls.centers, numbers[:, :3].copy()) and same(balls.radii, np.abs(numbers[:, 3]))
    vbm.write_balls(path, np.empty((0, 3)), [])
    assert vbm.read_balls(path).centers.shape == (0, 3)


def test_urdf(tmp_path):
    path = tmp_path / "arm <&> \"1\".urdf"
    vbm.write_balls(path, CENTERS, RADII)
    robot = xml.etree.ElementTree.parse(path).getroot()
    assert robot.tag == "robot" and robot.get("name") == 'arm <&> "1"'
    (link,) = robot.findall("link")
    collisions = link.findall("collision")
    xyz = [[float(w) for w in c.find("origin").get("xyz").split()] for c in collisions]
    radii = [float(c.find("geometry/sphere").get("radius")) for c in collisions]
    there = RADII > 0  # a sphere of radius 0 is none
    assert np.array_equal(xyz, CENTERS[there]) and np.array_equal(radii, RADII[there])
    with pytest.raises(vbm.InputError, match="read from .ply, .csv and .ma"):
        vbm.read_balls(path)


HEADER = """ply
format {} 1.0
comment from somewhere
element vertex 2
property float x
property float y
property float z
property uchar quality
property list uchar short tags
property double radius
element face 1
property list uchar uint vertex_index
element material 1
property int shade
end_header
"""


@pytest.mark.parametrize("order", "<>")
def test_binary_ply_of_others(tmp_path, order):
    name = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    data = HEADER.format(name).encode()
    for i in range(2):
        data += struct.pack(order + "3fBB2hd", i, 2.5, -1, 200, 2, 7, 8, 0.1 + i)
    data += struct.pack(order + "B4Ii", 4, 0, 1, 0, 1, 9)
    path = tmp_path / "b.PLY"
    path.write_bytes(data)
    balls = vbm.read_balls(path)
    assert balls.centers.tolist() == [[0, 2.5, -1], [1, 2.5, -1]] and balls.radii.tolist() == [0.1, 1.1]
    assert balls.triangles.tolist() == [[0, 1, 0], [0, 0, 1]]  # a polygon's fan
    for cut in range(1, 40):
        path.write_bytes(data[:-cut])
        with pytest.raises(vbm.InputError, match=r"^b\.PLY: (byte|line) \d+: "):
            vbm.read_balls(path)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("bom", ["", "\ufeff"])
def test_text_files_of_others(tmp_path, end, bom):
    def read(name, text):
        (tmp_path / name).write_bytes((bom + text.replace("\n", end)).encode())
        return vbm.read_balls(tmp_path / name)

    if not bom:
        balls = read("a.ply", HEADER.format("ascii") + "0 1 2 9 0 .5\n\n1 +1 2e0 9 2 1 1 1.5\n3 0 1 1\n7")
        assert balls.centers.tolist() == [[0, 1, 2], [1, 1, 2]] and balls.radii.tolist() == [0.5, 1.5]
        assert balls.triangles.tolist() == [[0, 1, 1]]
    balls = read("a.csv", "# made by hand\n\n0,1,2,.5\n 3 , 4 , 5 , 6 \n")
    assert balls.centers.tolist() == [[0, 1, 2], [3, 4, 5]] and balls.radii.tolist() == [0.5, 6]
    balls = read("q.csv", '"x","y","z","radius"\n"1","2","3","4"\n')
    assert balls.centers.tolist() == [[1, 2, 3]] and balls.radii.tolist() == [4]
    balls = read("b.csv", 'Level;"R";X;Y;Z;name\n2;1;3;4;5;me\n')
    assert balls.centers.tolist() == [[3, 4, 5]] and balls.attributes["level"].tolist() == [2]
    balls = read("a.ma", "# a comment\n2 1 1\nv 0 0 0 1 # here too\nv 1 0 0 2 17\n\te 0 1\nf 0 1 0 3\n")
    assert balls.radii.tolist() == [1, 2] and balls.edges.tolist() == [[0, 1]]
    assert balls.triangles.tolist() == [[0, 1, 0]]


PLY = "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n" \
      "property double radius\nend_header\n"

BAD = {
    "empty.ply": ("", "line 1: the file is empty"),
    "empty.csv": ("", "line 1: the file is empty"),
    "empty.ma": ("\n# nothing\n", "line 1: the file is empty"),
    "not.ply": ("solid cube\n", "line 1: no PLY file"),
    "png.ply": ("\x89PNG\r\n\x1a\n123", "line 1"),
    "ended.ply": ("ply\nformat ascii 1.0\nelement vertex 3\n", "line 3: the header has no end"),
    "huge.ply": (PLY.format(10**12) + "0 0 0 1\n", "line 3: 1000000000000 elements \"vertex\" are announced"),
    "overflow.ply": (PLY.format(10**30), "line 3.*no whole number"),
    "negative.ply": (PLY.format(-4), "line 3.*\"-4\", which is no whole number"),
    "short.ply": (PLY.format(2) + "0.25 0.25 0.25 1\n", "line 9: element \"vertex\" 1 is missing"),
    "few.ply": (PLY.format(1) + "0 0 0        \n", "line 9: element \"vertex\" 0 has too few"),
    "many.ply": (PLY.format(1) + "0 0 0 1 2\n", "line 9: element \"vertex\" 0 has too many"),
    "nan.ply": (PLY.format(1) + "0 nan 0 1\n", "line 9: y is \"nan\", which is not finite"),
    "inf.ply": (PLY.format(1) + "0 0 0 inf\n", "line 9: radius is \"inf\""),
    "range.ply": (PLY.format(1) + "0 0 0 1e999\n", "line 9.*beyond the range"),
    "below.ply": (PLY.format(1) + "0 0 0 -1\n", "line 9.*negative radius"),
    "comma.ply": (PLY.format(1) + "0 1,5 0 1\n", "line 9.*decimal comma"),
    "nul.ply": (PLY.format(1) + "0 0 0 1\0\n", "line 9.*no number"),
    "radius.ply": (PLY.format(1).replace("radius", "size") + "0 0 0 1\n", "line 3: the vertices have no radius"),
    "type.ply": (PLY.format(1).replace("double z", "quad z"), "line 6: \"quad\" is no type"),
    "twice.ply": (PLY.format(0).replace("end_h", "element vertex 0\nend_h"), "line 8: this is the second element"),
    "nothing.ply": (PLY.format(0).replace("vertex", "vortex"), "line 8: there is no element \"vertex\""),
    "face.ply": (PLY.format(1).replace("end_h", "element face 1\nproperty list uchar int vertex_indices\nend_h")
                 + "0 0 0 1\n3 0 0 1\n", "line 12: element \"face\" 0 has the vertex 1, but there are 1"),
    "list.ply": (PLY.format(1).replace("end_h", "element face 1\nproperty list uint int vertex_indices\nend_h")
                 + "0 0 0 1\n4000000000 0 0\n", "line 12.*list of 4000000000 items"),
    "three.csv": ("1,2,3\n", "line 1: there are 3 columns"),
    "ragged.csv": ("x,y,z,radius\n1,2,3,4\n1,2,3\n", "line 3: there are 3 columns where the first line has 4"),
    "named.csv": ("x,y,z,size\n1,2,3,4\n", "line 1.*no column \"radius\""),
    "word.csv": ("1,2,3,4\n1,b,3,4\n", "line 2: a coordinate is \"b\", which is no number"),
    "nan.csv": ("1,2,3,nan\n", "line 1: the radius is \"nan\", which is not finite"),
    "below.csv": ("1,2,3,-4\n", "line 1.*negative"),
    "comma.csv": ("1,5;2;3;4\n", "line 1.*decimal comma"),
    "hex.csv": ("0x10,2,3,4\n", "line 1.*no number"),
    "huge.ma": ("1000000000000 0 0\nv 0 0 0 1\n", "line 1: 1000000000000 vertices are announced"),
    "faces.ma": ("1 0 4000000000\nv 0 0 0 1\n", "line 1: 4000000000 faces are announced"),
    "below.ma": ("-1 0 0\n", "line 1"),
    "fewer.ma": ("2 0 0\nv 0 0 0 1\n#.............\n", "line 1: 2 vertices are announced, but there are 1"),
    "more.ma": ("1 0 0\nv 0 0 0 1\nv 0 0 0 1\n", "line 1: 1 vertices are announced, but there are 2"),
    "edge.ma": ("1 1 0\nv 0 0 0 1\ne 0 1\n", "line 3: a vertex of the edge is 1, but there are 1"),
    "face.ma": ("1 0 1\nv 0 0 0 1\nf 0 0\n....", "line 3: a face needs three"),
    "line.ma": ("1 0 0\nv 0 0 0 1\nw 1\n", "line 3: \"w\" begins no line"),
    "cut.ma": ("1 0 0\nv 0 0 0\n....", "line 2: a vertex needs"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_files(tmp_path, name):
    text, message = BAD[name]
    (tmp_path / name).write_bytes(text.encode("latin-1"))
    with pytest.raises(vbm.InputError, match=message) as error:
        vbm.read_balls(tmp_path / name)
    assert str(error.value).startswith(name + ": ") and "\n" not in str(error.value)


@pytest.mark.parametrize("name, head", [
    ("a.ply", PLY.format(10**12)), ("b.ply", PLY.format(1).replace("radius", "size")), ("c.ply", "solid cube\n"),
    ("d.ma", "1000000000000 0 0\n"), ("e.csv", "x,y,z,size\n"), ("f.csv", "0,0,0,1\n\n0,0,1\n"), ("g.csv", "")])
def test_bad_headers_of_huge_files_are_told_at_once(tmp_path, name, head):
    """A file of 8 TB, without any blocks on the disk: reading it is out of the question."""
    with open(tmp_path / name, "wb") as file:
        file.write(head.encode())
        file.truncate(2**43)
    with pytest.raises(vbm.InputError, match="line [13]: "):
        vbm.read_balls(tmp_path / name)


def test_no_file(tmp_path):
    with pytest.raises(FileNotFoundError):
        vbm.read_balls(tmp_path / "no.ply")
    (tmp_path / "d.ply").mkdir()
    for call in (vbm.read_balls, lambda path: vbm.write_balls(path, CENTERS, RADII)):
        with pytest.raises(IsADirectoryError):
            call(tmp_path / "d.ply")
    with pytest.raises(FileNotFoundError) as error:
        vbm.write_balls(tmp_path / "no" / "b.ply", CENTERS, RADII)
    assert error.value.filename == tmp_path / "no" / "b.ply"
    for call in (vbm.read_balls, lambda path: vbm.write_balls(path, CENTERS, RADII)):
        with pytest.raises(vbm.InputError, match="by the name's extension"):
            call(tmp_path / "b.obj")
    with pytest.raises(TypeError):
        vbm.read_balls(3.5)


def test_what_cannot_be_written(tmp_path):
    path = tmp_path / "b.ply"
    path.write_text("mine")
    for arguments, message in [
        (dict(radii=[1, 1, -1, 1]), "ball 2 has a radius that is negative"),
        (dict(radii=[1, np.nan, 1, 1]), "ball 1 has a radius that is not finite"),
        (dict(centers=CENTERS + [0, 0, np.inf]), "ball 0 has a centre"),
        (dict(triangles=[[0, 1, 4]]), "triangle 0 names ball 4, but there are 4"),
        (dict(edges=[[0, 1], [-1, 0]]), "edge 1 names ball -1"),
        (dict(attributes={"part": [1]}), "attribute part has 1 values for 4"),
        (dict(attributes={"size": [1] * 4}), "no attribute \"size\""),
    ]:
        given = {"centers": CENTERS, "radii": RADII, **arguments}
        with pytest.raises(vbm.InputError, match=message):
            vbm.write_balls(path, **given)
    for name, extra in [("b.csv", dict(edges=EDGES)), ("b.urdf", dict(triangles=TRIANGLES)),
                        ("b.ma", dict(attributes=EXTRA)), ("b.urdf", dict(attributes=EXTRA))]:
        with pytest.raises(vbm.InputError, match="holds"):
            vbm.write_balls(tmp_path / name, CENTERS, RADII, **extra)
    with pytest.raises(vbm.ArgumentError, match=r"triangles must be an \(n, 3\) array"):
        vbm.write_balls(path, CENTERS, RADII, [[0, 1]])
    assert path.read_text() == "mine" and os.listdir(tmp_path) == ["b.ply"]


def test_a_full_disk_leaves_what_was_there(tmp_path):
    path = tmp_path / "b.ply"
    path.write_text("mine")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (5000, before[1]))
        with pytest.raises(OSError):
            vbm.write_balls(path, np.zeros((1000, 3)), np.ones(1000))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)
    assert path.read_text() == "mine" and os.listdir(tmp_path) == ["b.ply"]
    vbm.write_balls(path, np.zeros((1000, 3)), np.ones(1000))
    assert len(vbm.read_balls(path).radii) == 1000


@pytest.mark.parametrize("name", ["a b", "umlaut_äöüß", "升密封盒", "😀", "quote's \"q\" $x;", "a" * 200])
def test_names(tmp_path, name):
    path = tmp_path / f"{name}.ma"
    vbm.write_balls(path, CENTERS, RADII)
    assert os.listdir(tmp_path) == [path.name]
    assert same(vbm.read_balls(path).centers, CENTERS)


def test_a_link_stays_a_link(tmp_path):
    (tmp_path / "real").mkdir()
    target, link = tmp_path / "real" / "b.csv", tmp_path / "b.csv"
    target.write_text("old")
    link.symlink_to(target)
    vbm.write_balls(link, CENTERS, RADII)
    assert link.is_symlink() and same(vbm.read_balls(target).centers, CENTERS)


def test_modes_are_kept_and_heeded(tmp_path):
    path = tmp_path / "b.csv"
    path.write_text("mine")
    path.chmod(0o600)
    vbm.write_balls(path, CENTERS, RADII)
    assert path.stat().st_mode & 0o777 == 0o600 and len(vbm.read_balls(path).radii) == 4
    path.write_text("mine")
    path.chmod(0o444)
    tmp_path.chmod(0o777)
    child = os.fork()
    if child == 0: # as a user who is not root
        code = 1
        try:
            os.chdir(tmp_path)
            if os.geteuid() == 0:
                os.setresgid(65534, 65534, 65534)
                os.setresuid(65534, 65534, 65534)
            vbm.write_balls("b.csv", CENTERS, RADII)
        except PermissionError:
            code = 0
        finally:
            os._exit(code)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    assert path.read_text() == "mine" and os.listdir(tmp_path) == ["b.csv"]


def test_what_is_no_file_is_not_replaced(tmp_path):
    os.mkfifo(tmp_path / "b.csv")
    (tmp_path / "c.csv").symlink_to(tmp_path / "b.csv")
    for name in ("b.csv", "c.csv"):
        with pytest.raises(vbm.InputError, match=f"{name}: a device, pipe or socket"):
            vbm.write_balls(tmp_path / name, CENTERS, RADII)
    assert (tmp_path / "b.csv").is_fifo() and sorted(os.listdir(tmp_path)) == ["b.csv", "c.csv"]


def test_decimal_commas_of_the_locale(tmp_path):
    """The same bytes in and out where numbers are written with commas."""
    script = """
import locale, sys
import numpy as np, vbm
locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
assert locale.localeconv()["decimal_point"] == ","
for kind in ("ply", "csv", "ma"):
    balls = vbm.read_balls(f"{sys.argv[1]}/a.{kind}")
    vbm.write_balls(f"{sys.argv[1]}/b.{kind}", balls.centers, balls.radii)
"""
    for kind in ("ply", "csv", "ma"):
        vbm.write_balls(tmp_path / f"a.{kind}", CENTERS, RADII)
    environment = dict(os.environ)
    locpath = pathlib.Path(vbm.__file__).resolve().parents[1] / "tests" / "locale"
    if not (locpath / "de_DE.UTF-8").exists():
        pytest.skip(f"no locale de_DE.UTF-8 in {locpath}")
    environment["LOCPATH"] = str(locpath)
    subprocess.run([sys.executable, "-c", script, str(tmp_path)], check=True, env=environment)
    for kind in ("ply", "csv", "ma"):
        assert (tmp_path / f"a.{kind}").read_bytes() == (tmp_path / f"b.{kind}").read_bytes()
    assert locale.localeconv()["decimal_point"] == "."


def test_long_lines_cost_little(tmp_path):
    path = tmp_path / "b.csv"
    path.write_text("#" + "x" * 20_000_000 + "\n1,2,3,4\n")
    assert vbm.read_balls(path).radii.tolist() == [4]


def test_the_nasty_files(tmp_path):
    """Files that are broken in ways of other formats are refused under every name."""
    script = models.ROOT.parent / "shared" / "nasty" / "make_nasty.py"
    script = pathlib.Path(os.environ["VBM_SHARED"]) / "nasty" / script.name if "VBM_SHARED" in os.environ else script
    if not script.exists():
        pytest.skip(f"{script} is not there; VBM_SHARED names the folder with test data")
    subprocess.run([sys.executable, str(script), str(tmp_path)], check=True, stdout=subprocess.DEVNULL)
    count = 0
    for file in sorted((tmp_path / "file").iterdir()):
        for kind in ("ply", "csv", "ma"):
            path = tmp_path / f"x.{kind}"
            path.write_bytes(file.read_bytes())
            with pytest.raises(vbm.InputError, match="^x."):
                vbm.read_balls(path)
            count += 1
    assert count > 60
