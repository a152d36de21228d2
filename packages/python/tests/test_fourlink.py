# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package against the command: every deck of data/, its columns, facts, numbers set; mistakes; documents.
FOURLINK is the command, the library that of the installed package, or FOURLINK_LIBRARY."""
import copy
import csv
import ctypes
import inspect
import io
import math
import multiprocessing
import os
import pickle
import re
import shutil
import signal
import subprocess
import threading
from pathlib import Path

import numpy as np
import pytest

import fourlink

TOP = Path(__file__).resolve().parents[3]
COMMAND = os.environ.get("FOURLINK", str(TOP / "build" / "fourlink"))
DECKS = sorted((TOP / "data").glob("*.deck"))
MATRIX = TOP / "data" / "me3491-matrix.deck"
TEXT = "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[coupler]\nlength = 66 mm\n" \
       "[rocker]\nlength = 56 mm\nmass = 0.4 kg\n[motion]\nspeed = 60 rpm\ninterval = 5 deg\n"


def run(*arguments, deck=None):
    done = subprocess.run([COMMAND, *arguments], input=deck, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


def table(*arguments, deck=None):
    """The command's columns in SI units and degrees, by branch."""
    rows = list(csv.DictReader(line for line in io.StringIO(run("-f", "csv", "--units=SI", *arguments, deck=deck)) if not line.startswith("#")))
    return rows


@pytest.mark.parametrize("deck", DECKS, ids=lambda p: p.stem)
def test_columns_of_the_command(deck):
    with fourlink.open(deck, units="SI") as r:
        names = list(r.names)
        for branch in r.branches:
            rows = table(f"--branch={branch}", "--columns=" + ",".join(names), str(deck))
            columns = r.columns(",".join(names), branch)
            for name, column in zip(names, columns):
                heads = [h for h in rows[0] if h.split(" (")[0] == name] if rows else []
                assert len(heads) == 1, (name, list(rows[0])[:5])
                printed = np.array([float(row[heads[0]] or "nan") for row in rows])
                assert len(printed) == len(column)
                assert np.array_equal(np.nan_to_num(printed, nan=0.5), np.nan_to_num(column, nan=0.5)), name


@pytest.mark.parametrize("deck", DECKS, ids=lambda p: p.stem)
def test_facts_of_the_command(deck):
    with fourlink.open(deck, units="SI") as r:
        printed = {row["name"]: row["value"] for row in
                   csv.DictReader(io.StringIO(run("-S", "-f", "csv", "--units=SI", f"--branch={r.branches[0]}", str(deck))))
                   if row.get("branch", "") in ("", r.branches[0])}
        found = 0
        for name, value in r.facts.items():
            if name in printed:
                found += 1
                assert printed[name] == value if isinstance(value, str) else math.isclose(float(printed[name]), value, rel_tol=1e-14, abs_tol=1e-300), name
        assert found > 3


def test_numbers_are_in_the_units_of_their_lines():
    r = fourlink.open(TEXT)
    assert r.line_unit("crank.length") == "mm" and r.line_unit("motion.speed") == "rpm"
    assert r["crank.length"] == 0.02
    for value in 22, "22 mm", "2.2 cm":
        r.set("crank.length", 20)
        r.set("crank.length", value)
        assert math.isclose(r["crank.length"], 0.022, rel_tol=1e-15)
        assert math.isclose(r["max(omega4)"], fourlink.open(TEXT.replace("20 mm", "22 mm"))["max(omega4)"], rel_tol=1e-15)
    r.set("motion.speed", 120)
    assert math.isclose(r["motion.speed"], 4 * math.pi, rel_tol=1e-15)
    assert "speed = 120 rpm" in r.deck()


def test_mistakes():
    with pytest.raises(fourlink.Mistake) as told:
        fourlink.open(TEXT.replace("[crank]\nlength", "[crank]\nlenght") + "[load]\n")
    m = told.value
    assert (m.line, m.hint) == (5, "length") and "unknown key 'lenght'" in str(m) and str(m).startswith("deck:5: ")
    assert [x.line for x in m.others] and str(m).splitlines()[1:] == [str(x) for x in m.others]
    r = fourlink.open(TEXT)
    before = r["mu_min"]
    with pytest.raises(fourlink.Mistake, match="the linkage cannot be assembled"):
        r.set("ground.length", "800 mm")
    with pytest.raises(fourlink.Mistake, match="expected a length"):
        r.set("crank.length", "45 kg")
    for value in 3, "3 mm":
        with pytest.raises(KeyError, match="crank.lenght.*did you mean 'crank.length'"):
            r.set("crank.lenght", value)
    with pytest.raises(KeyError, match=r"max\(Tz\).*did you mean 'max\(Ts\)'"):
        r["max(Tz)"]
    with pytest.raises(KeyError, match="did you mean 'mu_min'"):
        r["mu_mim"]
    with pytest.raises(fourlink.Mistake, match="theta4: .*100 kg.*angle"):
        r.at("theta4 = 100 kg")
    with pytest.raises(ValueError, match="open or crossed, not 'opened'"):
        r.columns(branch="opened")
    with pytest.raises(FileNotFoundError):
        fourlink.open("no-such.deck")
    assert r["mu_min"] == before


def test_mistakes_have_file_and_line(tmp_path):
    """As the command prints them, with the folder of files; also after they are pickled."""
    (tmp_path / "torque.txt").write_text("0 1\n180 two\n360 1\n")
    deck = tmp_path / "a.deck"
    deck.write_text(TEXT.replace("20 mm", "20 parsec") + "[load T]\nlink = rocker\ntorque = file torque.txt\n")
    printed = subprocess.run([COMMAND, str(deck)], capture_output=True, text=True).stderr
    with pytest.raises(fourlink.Mistake) as told:
        fourlink.open(deck)
    m = told.value
    assert str(m) + "\n" == printed.replace(": error: ", ": ").replace("torque.txt:", f"{tmp_path}/torque.txt:") and len(m.others) == 1
    assert [(x.file, x.line) for x in (m, *m.others)] == [(f"{tmp_path}/torque.txt", 2), (str(deck), 5)]
    again = pickle.loads(pickle.dumps(m))
    assert str(again) == str(m) and (again.line, again.file, again.message, again.hint) == (m.line, m.file, m.message, m.hint)
    with pytest.raises(fourlink.Mistake, match="^'?.*20 kg"):
        fourlink.open(TEXT, changes={"crank.length": "20 kg"})


def test_mistakes_of_a_relative_path(tmp_path, monkeypatch):
    """The path as it was given, of the deck and of a file that it names; also of a number that is set."""
    (tmp_path / "decks").mkdir()
    (tmp_path / "decks" / "torque.txt").write_text("0 1\n180 two\n360 1\n")
    monkeypatch.chdir(tmp_path)
    deck = os.path.join("decks", "a.deck")
    with open(deck, "w") as f:
        f.write(TEXT.replace("20 mm", "20 parsec") + "[load T]\nlink = rocker\ntorque = file torque.txt\n")
    with pytest.raises(fourlink.Mistake) as told:
        fourlink.open(deck)
    assert [x.file for x in (told.value, *told.value.others)] == [os.path.join("decks", "torque.txt"), deck]
    with open(deck, "w") as f:
        f.write(TEXT)
    with fourlink.open(deck) as r, pytest.raises(fourlink.Mistake) as told:
        r.set("ground.length", "800 mm")
    assert told.value.file == deck and str(told.value).startswith(f"{deck}:{told.value.line}: ")


def test_version():
    assert f'version = "{fourlink.version()}"' in (TOP / "packages" / "python" / "pyproject.toml").read_text()


def test_at():
    r = fourlink.open(MATRIX)
    angles = r.at("theta4 = 120 deg")
    assert len(angles) == 2
    theta4, torque = r.at("theta4 = 2.0943951023931953 rad", "theta4, Ts")
    assert np.allclose(theta4, 120, atol=1e-9) and len(torque) == 2
    for angle, there in zip(angles, torque):
        assert math.isclose(r.value("Ts", angle), there, rel_tol=1e-9)
    for same in r.at(theta4="120 deg"), r.at(theta4=120), r.at(theta4="1/3 rev"), r.at("theta4=120"):
        assert np.allclose(same, angles, rtol=0, atol=1e-9)
    assert np.array_equal(r.at("theta4 = 120 deg", "theta4, Ts"), r.at(theta4="120 deg", names="theta4, Ts"))
    for wrong in lambda: r.at(), lambda: r.at("30 deg", theta4=120), lambda: r.at(theta4=120, theta3=40):
        with pytest.raises(TypeError, match="one crank angle, or the value of one column"):
            wrong()


def test_at_a_crank_angle():
    """The rows of --at, from text with a unit, a number, and text that is a number."""
    for deck in MATRIX, TOP / "data" / "khurmi-16.11.deck":
        r = fourlink.open(deck, units="SI")
        branch = r.branches[0]
        for angle, words in (30, "30 deg"), (30, "pi/6"), (120, "1/3 rev"), (77.3, "77.3"):
            printed, = table(f"--at={words}", "--columns=" + ",".join(r.names), f"--branch={branch}", str(deck))
            printed = {head.split(" (")[0]: float(x or "nan") for head, x in printed.items() if head != "branch"
                       and head.split(" (")[0] in r.names}
            for place in words, angle, np.float64(angle):
                there = r.at(place)
                assert len(there) == len(r.columns()) and there["theta2"] == pytest.approx(angle, rel=1e-15)
                assert np.allclose(r.at(place, ", ".join(printed)), list(printed.values()), rtol=1e-9, atol=1e-9, equal_nan=True)
                assert all(math.isclose(value, printed[name], rel_tol=1e-9, abs_tol=1e-9) for name, value in there.items())
                assert r.at(place, "theta2") == there["theta2"] == r.value("theta2", place)
    with pytest.raises(fourlink.Mistake, match="theta2: .*30 kg"):
        r.at("30 kg")


def test_units_in_words():
    """Of each unit its own number: 3.7 of the unit that a column has is 3.7."""
    r = fourlink.open(MATRIX, units="mm, rpm, N, g, J")
    for name, unit in r.units.items():
        words = "3.7" if unit == "1" else f"3.7 {unit}"
        found = r._find(name)
        assert r._number(found.quantity, words, name) == 3.7, (name, unit)


def test_branches_and_words():
    r = fourlink.open(MATRIX)
    assert r["type"] == "crank-rocker" and set(r.branches) <= {"open", "crossed"}
    assert r.value("theta4", 40, "open") != r.value("theta4", 40, "crossed")
    assert r.unit("Ts") == "N.m" and r.units["theta4"] == "deg" and "crank.length" in r.inputs


def test_a_file_that_the_deck_names(tmp_path):
    (tmp_path / "torque.txt").write_text("0 1\n180 2\n360 1\n")
    (tmp_path / "a.deck").write_text(TEXT + "[load T]\nlink = rocker\ntorque = file torque.txt\n")
    assert fourlink.open(tmp_path / "a.deck")["max(Ts)"] > 0
    with pytest.raises(fourlink.Mistake, match="cannot read the file"):
        (tmp_path / "torque.txt").unlink()
        fourlink.open(tmp_path / "a.deck")


def test_files_of_other_folders(tmp_path):
    """Not those outside the deck's folder, nor links that lead there, unless they are allowed; also in a copy."""
    (tmp_path / "decks").mkdir()
    (tmp_path / "torque.txt").write_text("0 1\n180 2\n360 1\n")
    (tmp_path / "decks" / "link.txt").symlink_to(tmp_path / "torque.txt")
    deck = tmp_path / "decks" / "a.deck"
    for name in "../torque.txt", str(tmp_path / "torque.txt"), "link.txt":
        deck.write_text(TEXT + f"[load T]\nlink = rocker\ntorque = file {name}\n")
        with pytest.raises(fourlink.Mistake, match="cannot read the file"):
            fourlink.open(deck)
        assert copy.copy(fourlink.open(deck, allow_files=True))["max(Ts)"] > 0


def test_frame():
    pytest.importorskip("pandas")
    frame = fourlink.open(MATRIX).frame("theta2, Ts")
    assert list(frame.columns) == ["theta2", "Ts"] and frame.attrs["units"]["Ts"] == "N.m"


def test_html(monkeypatch, tmp_path):
    """With a drawing if there is the command; also of a deck that names a file."""
    (tmp_path / "torque.txt").write_text("0 1\n180 2\n360 1\n")
    (tmp_path / "a.deck").write_text(TEXT + "[load T]\nlink = rocker\ntorque = file torque.txt\n")
    monkeypatch.setenv("PATH", str(Path(COMMAND).parent) + os.pathsep + os.environ["PATH"])
    for deck in MATRIX, tmp_path / "a.deck":
        r = fourlink.open(deck)
        drawing, page = r._repr_svg_(), r._repr_html_()
        assert drawing.lstrip().startswith(("<?xml", "<svg")) and drawing.rstrip().endswith("</svg>")
        assert page.startswith(drawing) and "mu_min" in page
    monkeypatch.setenv("PATH", "")
    assert r._repr_svg_() is None and "<svg" not in r._repr_html_()


def test_repr():
    with fourlink.open(MATRIX) as r:
        assert repr(r) == f"<fourlink.Results of {MATRIX}: crank-rocker; open and crossed, {len(r.columns()[0])} rows>"
    assert repr(r) == f"<fourlink.Results of {MATRIX}, closed>"


def test_hints_and_docstrings():
    """Each public function has a docstring and the types of all that it takes and returns, and the package says so."""
    assert Path(fourlink.__file__).with_name("py.typed").exists()
    functions = [fourlink.open, fourlink.version, *(getattr(x, "fget", x) for name, x in vars(fourlink.Results).items()
                                                  if callable(getattr(x, "fget", x)) and not name.startswith("_"))]
    assert len(functions) == 15
    for f in functions:
        assert f.__doc__ and "return" in f.__annotations__, f
        assert set(inspect.signature(f).parameters) <= {*f.__annotations__, "self"}, f


def test_threads_release_the_lock():
    """Four threads with results of their own have the results of one."""
    expected = [fourlink.open(TEXT, changes={"crank.length": f"{20 + i} mm"})["max(omega4)"] for i in range(4)]
    found = [None] * 4

    def work(i):
        r = fourlink.open(TEXT)
        for _ in range(200):
            r.set("crank.length", f"{20 + i} mm")
            found[i] = r["max(omega4)"]

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert np.allclose(found, expected, rtol=1e-15)


def together(*works):
    """Run functions in threads of their own; what they raise is raised here."""
    raised = []

    def run_one(work):
        try:
            work()
        except BaseException as e:
            raised.append(e)

    threads = [threading.Thread(target=run_one, args=(work,)) for work in works]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    if raised:
        raise raised[0]


def test_threads_share_results():
    """Each number is that of one of the cranks that the threads set, and all columns of a call are of the same one."""
    lengths = [15 + k for k in range(9)]
    apart = [fourlink.open(TEXT, changes={"crank.length": f"{length} mm"}) for length in lengths]
    largest = {one["max(omega4)"] for one in apart}
    columns = {one.columns("theta4, omega4, B.x").tobytes() for one in apart}
    words = {one.deck() for one in apart}
    r = fourlink.open(TEXT)

    def work():
        for k in range(300):
            r.set("crank.length", f"{lengths[k % 9]} mm")
            assert r["max(omega4)"] in largest
            assert r.columns("theta4, omega4, B.x").tobytes() in columns
            assert r.facts["type"] == "crank-rocker" and r.inputs["crank.length"] < 0.024
            if k % 10 == 0:
                assert r.deck() in words and len(r.at("theta4 = 2 rad")) == 2
                assert copy.copy(r)["max(omega4)"] in largest

    together(work, work, work, work)


def test_threads_while_results_are_closed():
    for _ in range(30):
        r = fourlink.open(TEXT)

        def work():
            with pytest.raises(ValueError, match="closed"):
                while True:
                    assert len(r.columns("theta2, omega4")[0]) == 73

        together(work, work, r.close, r.close)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_forks_while_threads_work():
    """A child's results are whole and free to use whatever the parent's threads did with them."""
    lengths = [15 + k for k in range(9)]
    largest = {fourlink.open(TEXT, changes={"crank.length": f"{length} mm"})["max(omega4)"] for length in lengths}
    r, other = fourlink.open(TEXT), fourlink.open(MATRIX)
    torque, ended = other["max(Ts)"], threading.Event()

    def work():
        k = 0
        while not ended.is_set():
            k += 1
            r.set("crank.length", f"{lengths[k % 9]} mm")
            other.columns("Ts")
            assert r["max(omega4)"] in largest

    def child():
        signal.alarm(20)
        right = r["max(omega4)"] in largest and other["max(Ts)"] == torque
        r.set("crank.length", "15 mm")
        copy.copy(r).close()
        r.close()
        return right

    def fork():
        try:
            for _ in range(30):
                pid = os.fork()
                if pid == 0:
                    status = 1
                    try:
                        status = 0 if child() else 2
                    finally:
                        os._exit(status)
                assert os.waitpid(pid, 0)[1] == 0
        finally:
            ended.set()

    together(work, work, fork)


def work_in_a_pool(r):
    r.set("crank.length", "18 mm")
    return r["max(Ts)"]


@pytest.mark.parametrize("way", multiprocessing.get_all_start_methods())
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_pools(way):
    r = fourlink.open(MATRIX)
    with multiprocessing.get_context(way).Pool(2) as pool:
        found = pool.map(work_in_a_pool, [r] * 4)
    assert found == [fourlink.open(MATRIX, changes={"crank.length": "18 mm"})["max(Ts)"]] * 4 and r["crank.length"] == 0.02


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda r: pickle.loads(pickle.dumps(r))], ids=["copy", "deepcopy", "pickle"])
def test_copies_are_opened_again(again, tmp_path):
    """A copy has the numbers set, the files and the units; it does not know of what happens to the other."""
    (tmp_path / "torque.txt").write_text("0 1\n180 2\n360 1\n")
    (tmp_path / "a.deck").write_text(TEXT + "[load T]\nlink = rocker\ntorque = file torque.txt\n")
    with fourlink.open(tmp_path / "a.deck", units="mm, rpm", changes={"coupler.length": "68.5 mm"}) as r:
        r.set("crank.length", 22.3)
        other = again(r)
        expected = r.columns().copy(), r.facts, r.inputs, r.units, r.deck(), r.name, r.branches
        r.set("crank.length", 18)
    found = other.columns(), other.facts, other.inputs, other.units, other.deck(), other.name, other.branches
    assert np.array_equal(expected[0], found[0]) and expected[1:] == found[1:]
    assert other["crank.length"] == 22.3 and other["coupler.length"] == 68.5
    (tmp_path / "torque.txt").unlink()
    with pytest.raises(fourlink.Mistake, match="cannot read the file"):
        again(other)


@pytest.mark.parametrize("deck", DECKS[::7], ids=lambda p: p.stem)
def test_copies_of_decks(deck):
    r = fourlink.open(deck)
    with pickle.loads(pickle.dumps(r)) as other:
        assert r.columns().tobytes() == other.columns().tobytes() and r.deck() == other.deck()


def test_closed_results_say_so():
    with fourlink.open(MATRIX) as r:
        assert r["max(Ts)"] > 0
    r.close()
    uses = [lambda: r["max(Ts)"], lambda: r.value("Ts", 40), lambda: r.unit("Ts"), lambda: r.names, lambda: r.units,
            lambda: r.inputs, lambda: r.facts, lambda: r.columns(), lambda: r.frame(), lambda: r.set("crank.length", 20),
            lambda: r.line_unit("crank.length"), lambda: r.at("theta4 = 120 deg"), lambda: r.at("30 deg"), lambda: r.deck(), r._repr_svg_,
            r._repr_html_,
            lambda: copy.copy(r), lambda: copy.deepcopy(r), lambda: pickle.dumps(r), r.__enter__]
    for use in uses:
        with pytest.raises(ValueError, match="me3491-matrix.deck are closed: open the deck again"):
            use()
    public = {name for name in vars(fourlink.Results) if not name.startswith("_")}
    assert public == {"close", "value", "unit", "names", "units", "inputs", "facts", "columns", "frame", "set", "line_unit",
                      "at", "deck"}, "a new one belongs into `uses`, too"


def test_random_numbers_against_the_command():
    """Numbers set at random, against decks with these numbers in their text."""
    rng = np.random.default_rng(49)
    r = fourlink.open(MATRIX)
    numbers = [name for name in r.inputs if re.match(r"(crank|coupler|rocker|ground)\.(length|mass|inertia)$", name)]
    set_, refused = 0, 0
    for _ in range(300):
        name = str(rng.choice(numbers))
        r = fourlink.open(MATRIX)
        value = fourlink.open(MATRIX)[name] * rng.uniform(0.5, 1.6)
        text = f"{value!r} {r.unit(name)}"
        try:
            expected = fourlink.open(MATRIX, changes={name: text})["max(Ts)"]
        except fourlink.Mistake:
            with pytest.raises(fourlink.Mistake):
                r.set(name, text)
            refused += 1
            continue
        r.set(name, text)
        assert math.isclose(r["max(Ts)"], expected, rel_tol=1e-12), (name, text)
        set_ += 1
    assert set_ > 200 and set_ + refused == 300


def test_structures(tmp_path):
    """The structures that are passed to the library have the sizes of its header."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if not compiler:
        pytest.skip("there is no compiler of C")
    subprocess.run([compiler, "-I", TOP / "include", TOP / "tests/consumers/sizes.c", "-o", tmp_path / "sizes"], check=True)
    printed = subprocess.run([tmp_path / "sizes"], check=True, capture_output=True, text=True).stdout
    sizes = {name: int(size) for name, size in (line.split() for line in printed.splitlines())}
    for name in "Mistake", "Change", "Source", "Value":
        assert ctypes.sizeof(getattr(fourlink, "_" + name)) == sizes["fourlink_" + name.lower()], name


def test_documents(monkeypatch):
    """The examples of doc/library.md run as they stand, from the folder of the sources."""
    examples = re.findall(r"```python\n(.*?)```", (TOP / "doc" / "library.md").read_text(), re.S)
    assert examples
    monkeypatch.chdir(TOP)
    for example in examples:
        exec(example, {})
