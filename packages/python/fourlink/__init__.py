# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinematics and kinetostatics of four-link mechanisms: results of a deck, by name.

    import fourlink
    r = fourlink.open("crusher.deck")            # or the text of a deck
    r["max(Ts)"]                                 # a fact, an extreme, an input, in the units of r.units
    theta2, Ts = r.columns("theta2, Ts")         # arrays of numpy, a number for each row
    r.set("crank.length", "45 mm")               # all results are then those of the deck with this crank

Values are in the units of the results: SI, or those of the deck's [units].  Lengths, forces and the like have
the unit that r.units tells for each name.  A deck with a mistake raises Mistake.  The library releases the GIL
while it works.  Threads may share results: their calls take turns.
"""
from __future__ import annotations

import ctypes as c
import difflib
import functools
import html
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

__all__ = ["open", "Results", "Mistake", "version"]
_OK, _BAD_DECK, _NO_NAME = 0, 36, 41
_BRANCHES = {"open": 1, "crossed": -1}
_LISTS = {"columns": 1, "all": 2, "inputs": 3}
_MISTAKES = 20


class _Mistake(c.Structure):
    _fields_ = [("file", c.c_char * 1024), ("line", c.c_long), ("message", c.c_char * 400)]


class _Change(c.Structure):
    _fields_ = [("origin", c.c_char_p), ("assignment", c.c_char_p)]


_Loader = c.CFUNCTYPE(c.c_void_p, c.c_void_p, c.c_char_p, c.POINTER(c.c_ulong))


class _Source(c.Structure):
    _fields_ = [("name", c.c_char_p), ("text", c.c_char_p), ("length", c.c_ulong), ("load", _Loader),
                ("host", c.c_void_p), ("changes", c.POINTER(_Change)), ("n_changes", c.c_ulong),
                ("answers_name", c.c_char_p), ("answers", c.c_char_p), ("answers_length", c.c_ulong),
                ("design", c.c_ulong), ("units", c.c_char_p), ("deck_units", c.c_int),
                ("synthesis", c.c_ulong), ("whole_cycle", c.c_int)]


class _Value(c.Structure):
    _fields_ = [("name", c.c_char_p), ("unit", c.c_char_p), ("quantity", c.c_char_p), ("meaning", c.c_char_p),
                ("source", c.c_char_p), ("words", c.c_char_p), ("value", c.c_double), ("to_si", c.c_double),
                ("has_angle", c.c_int), ("angle", c.c_double), ("branch", c.c_int), ("flags", c.c_int),
                ("handle", c.c_int), ("line_unit", c.c_char_p)]

    def get(self) -> float | str:
        return self.words.decode() if self.words else self.value


def _load() -> c.CDLL:
    name = {"darwin": "libfourlink.dylib", "win32": "fourlink.dll"}.get(sys.platform, "libfourlink.so")
    lib = c.CDLL(os.environ.get("FOURLINK_LIBRARY") or str(Path(__file__).with_name(name)))
    lib.fourlink_status_text.restype = lib.fourlink_version.restype = c.c_char_p
    lib.fourlink_results_deck.restype = c.c_void_p
    lib.fourlink_results_free.restype = None
    return lib


_lib = _load()


class Mistake(ValueError):
    """A mistake in a deck, or a name or a value that it cannot have: `message`, `line` (0: not in a file), `file`,
    and `hint`, the word that was probably meant, or None.  `others` are further mistakes of the deck."""

    def __init__(self, message: str, line: int = 0, file: str = "", others: list[Mistake] | None = None):
        place = f"{file or 'deck'}:{line}: " if line else ""
        super().__init__(place + message)
        self.message, self.line, self.file, self.others = message, line, file, others or []
        meant = re.search(r"did you mean '([^']*)'", message)
        self.hint = meant.group(1) if meant else None


def version() -> str:
    """The version of the library."""
    return _lib.fourlink_version().decode()


def _is_file(deck: str | os.PathLike) -> bool:
    return isinstance(deck, os.PathLike) or ("\n" not in deck and "=" not in deck)


def open(deck: str | os.PathLike, *, units: str | None = None, changes: dict[str, str] | None = None) -> Results:
    """Open a deck: the path of a file, or its text.

    units    of the results, such as "mm, kg, rpm", or "SI"; otherwise the deck's
    changes  as by --set: {"crank.length": "45 mm", "load P.force": "20 N at 30 deg"}
    """
    folder = Path(deck).parent if _is_file(deck) else Path()
    name = str(deck) if _is_file(deck) else "deck"
    return Results(Path(deck).read_bytes() if _is_file(deck) else deck.encode(), name, folder, units, changes or {})


def _alone(method: Callable) -> Callable:
    """A method that no other thread's call disturbs, and that tells if the results are closed."""
    @functools.wraps(method)
    def call(self: Results, *arguments, **named):
        with self._lock:
            if not self._r:
                raise ValueError(f"the results of {self.name} are closed: open the deck again")
            return method(self, *arguments, **named)
    return call


class Results:
    """All results of a deck.  Free its memory with close(), or use it in a `with` statement; after that each use raises
    ValueError.  copy and pickle open the deck again, with the numbers set."""

    _r: c.c_void_p | None = None

    def __init__(self, text: bytes, name: str, folder: Path, units: str | None, changes: dict[str, str]):
        kept = []  # what a loader has returned, until the deck is read

        def load(host, file_name, length):
            try:
                kept.append((folder / file_name.decode()).read_bytes())
            except OSError:
                return None
            length[0] = len(kept[-1])
            return c.cast(c.c_char_p(kept[-1]), c.c_void_p).value

        source = _Source(name=name.encode(), text=text, length=len(text), load=_Loader(load),
                         units=units.encode() if units else None, n_changes=len(changes),
                         changes=(_Change * len(changes))(*[(b"changes", f"{k}={v}".encode()) for k, v in changes.items()]))
        mistakes, n = (_Mistake * _MISTAKES)(), c.c_ulong()
        self.name, self._folder, self._units = name, folder, units
        self._lock = threading.RLock()
        self._r = c.c_void_p()
        status = _lib.fourlink_results_open(c.byref(source), c.c_ulong(_MISTAKES), c.byref(self._r), mistakes, c.byref(n))
        if status == _BAD_DECK:
            raise self._told(mistakes[:min(n.value, _MISTAKES)])
        self._check(status)
        self._handles: dict[str, int] = {}
        self.branches: tuple[str, ...] = self._find_branches()

    @staticmethod
    def _told(mistakes: list[_Mistake]) -> Mistake:
        first, *others = [Mistake(m.message.decode(errors="replace"), m.line, m.file.decode(errors="replace")) for m in mistakes]
        first.others = others
        return first

    def _check(self, status: int, what: str = "") -> None:
        if status == _OK:
            return
        words = _lib.fourlink_status_text(status).decode()
        if status == _NO_NAME:
            raise KeyError(f"{what}: {words}{self._meant(what)}")
        raise MemoryError(words) if status == 37 else ValueError(f"{what}: {words}" if what else words)

    def _meant(self, name: str) -> str:
        """The similar name of this deck, in words; of max(Tz) that with the similar column."""
        statistic = re.fullmatch(r"(max|min|mean|rms)\((.*)\)", name)
        known = list(self.names) if statistic else [*self.names, *self.facts, *self.inputs]
        near = difflib.get_close_matches(statistic[2] if statistic else name, known, 1, 0.5)
        return f"; did you mean '{statistic[1]}({near[0]})'?" if near and statistic else f"; did you mean '{near[0]}'?" if near else ""

    def close(self) -> None:
        """Free the memory."""
        if not self._r:
            return
        with self._lock:
            _lib.fourlink_results_free(self._r)
            self._r = c.c_void_p()

    __del__ = close

    @_alone
    def __reduce__(self) -> tuple:
        return Results, (self._text(), self.name, self._folder, self._units, {})

    @_alone
    def __enter__(self) -> Results:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _facts(self, branch: int, groups: int) -> list[_Value]:
        facts, n = c.POINTER(_Value)(), c.c_ulong()
        self._check(_lib.fourlink_results_facts(self._r, branch, groups, c.byref(facts), c.byref(n)))
        return facts[:n.value]

    def _find_branches(self) -> tuple[str, ...]:
        found = {v.branch for v in self._facts(0, 1)}
        return tuple(name for name, number in _BRANCHES.items() if number in found) or ("open",)

    def _branch(self, branch: str | None) -> int:
        return _BRANCHES[branch or self.branches[0]]

    def _find(self, name: str) -> _Value:
        found = _Value()
        self._check(_lib.fourlink_results_find(self._r, name.encode(), c.byref(found)), name)
        return found

    def _list(self, which: str) -> list[_Value]:
        found, n = c.POINTER(_Value)(), c.c_ulong()
        self._check(_lib.fourlink_results_list(self._r, _LISTS[which], c.byref(found), c.byref(n)))
        return found[:n.value]

    @_alone
    def __getitem__(self, name: str) -> float | str:
        """A fact ("mu_min"), an extreme ("max(Ts)"), a mean, a column at an angle ("Ts at 30 deg"), an input ("crank.length"), on
        the deck's first branch, in the unit of the results; "type" and the like are words."""
        return self.value(name)

    @_alone
    def value(self, name: str, angle: float = 0.0, branch: str | None = None) -> float | str:
        """Any number by its name; a column at a crank angle, in the unit of the results."""
        if name not in self._handles:
            self._handles[name] = self._find(name).handle
        v = _Value()
        status = _lib.fourlink_results_get(self._r, self._handles[name], self._branch(branch), c.c_double(angle), c.byref(v))
        self._check(status, name)
        return v.get()

    @_alone
    def unit(self, name: str) -> str:
        """The unit of a name in the results; "1" for a plain number."""
        return self._find(name).unit.decode()

    @property
    @_alone
    def names(self) -> dict[str, str]:
        """All columns that the deck has, with their meanings."""
        return {v.name.decode(): v.meaning.decode() for v in self._list("all")}

    @property
    @_alone
    def units(self) -> dict[str, str]:
        """The units of all columns."""
        return {v.name.decode(): v.unit.decode() for v in self._list("all")}

    @property
    @_alone
    def inputs(self) -> dict[str, float | str]:
        """What the deck gives, as the library understood it, in the units of the results."""
        return {v.name.decode(): v.get() for v in self._list("inputs")}

    @property
    @_alone
    def facts(self) -> dict[str, float | str]:
        """Type, reach, limits, masses, extremes, turning moment of the deck's first branch."""
        return {v.name.decode(): v.get() for v in self._facts(self._branch(None), 15)}

    def _asked(self, names: str | None) -> list[str]:
        return [n for n in re.split(r"[,\s]+", names) if n] if names else [v.name.decode() for v in self._list("columns")]

    @_alone
    def columns(self, names: str | None = None, branch: str | None = None) -> np.ndarray:
        """Columns such as "theta2, Ts", one array for each, with a number for each row; without names the table's.
        NaN where the linkage cannot be assembled."""
        handles = [self._find(name).handle for name in self._asked(names)]
        rows, n = c.c_int(), c.c_int()
        _lib.flnrow_(c.byref(self._r), c.byref(rows), c.byref(n))
        values = np.empty((rows.value, len(handles)))
        self._check(_lib.fourlink_results_rows(self._r, self._branch(branch), c.c_ulong(0), c.c_ulong(rows.value),
                                               c.c_ulong(len(handles)), (c.c_int * len(handles))(*handles),
                                               values.ctypes.data_as(c.POINTER(c.c_double))), names or "columns")
        return values.T

    @_alone
    def frame(self, names: str | None = None, branch: str | None = None):
        """The same columns as a pandas.DataFrame; its attrs["units"] has their units."""
        import pandas
        asked = self._asked(names)
        frame = pandas.DataFrame(dict(zip(asked, self.columns(",".join(asked), branch))))
        frame.attrs["units"] = {name: self.unit(name) for name in asked}
        return frame

    @_alone
    def set(self, name: str, value: float | str) -> None:
        """Set a number: as text with a unit, "45 mm", or a number in the unit that its line has in the deck, line_unit().
        All results are then those of the deck with this number; a mistake leaves them as they were."""
        m = _Mistake()
        if isinstance(value, str):
            status = _lib.fourlink_results_set_text(self._r, f"{name} = {value}".encode(), c.byref(m))
        else:
            status = _lib.fourlink_results_set(self._r, name.encode(), c.c_double(value), c.byref(m))
        if m.message and status != _NO_NAME:
            raise self._told([m])
        self._check(status, name)

    @_alone
    def line_unit(self, name: str) -> str:
        """The unit in which a number of the deck is set."""
        v = _Value()
        self._check(_lib.fourlink_results_input(self._r, name.encode(), c.byref(v)), name)
        return v.unit.decode()

    _FACTORS = {"deg": np.pi / 180, "rad": 1, "m": 1, "cm": 1e-2, "mm": 1e-3, "rpm": np.pi / 30, "rad/s": 1}

    @_alone
    def at(self, question: str, names: str = "theta2", branch: str | None = None) -> np.ndarray:
        """Columns where one of them has a value: r.at("theta4 = 120 deg") has the crank angles, r.at("theta4 = 120 deg",
        "Ts, omega4") these columns there, one array for each.  A bare number is in the unit of the results."""
        asked = re.fullmatch(r"\s*(\S+)\s*=\s*([-+.\deE]+)\s*(\S*)\s*", question)
        if not asked:
            raise ValueError(f"expected 'NAME = VALUE UNIT', not '{question}'")
        name, value, unit = asked[1], float(asked[2]), asked[3]
        own = self._find(name)
        if unit and unit != own.unit.decode():
            if unit not in self._FACTORS or own.unit.decode() not in self._FACTORS:
                raise ValueError(f"give {name} in {own.unit.decode()}")
            value *= self._FACTORS[unit] / own.to_si
        angles, n = (c.c_double * 1000)(), c.c_ulong()
        self._check(_lib.fourlink_results_crossings(self._r, name.encode(), self._branch(branch), c.c_double(value),
                                                    c.c_ulong(1000), angles, c.byref(n)), name)
        found = angles[:min(n.value, 1000)]
        columns = np.array([[self.value(x, angle, branch) for angle in found] for x in self._asked(names)])
        return columns[0] if len(columns) == 1 else columns

    @_alone
    def deck(self) -> str:
        """The text of the deck with the numbers set."""
        return self._text().decode()

    def _text(self) -> bytes:
        deck, n = c.c_void_p(_lib.fourlink_results_deck(self._r)), c.c_ulong()
        _lib.fourlink_deck_write(deck, None, c.c_ulong(0), c.byref(n))
        out = c.create_string_buffer(n.value + 1)
        _lib.fourlink_deck_write(deck, out, c.c_ulong(n.value + 1), c.byref(n))
        return out.raw[:n.value]

    def _lines(self) -> Iterator[str]:
        for v in self._facts(self._branch(None), 3):
            number = v.words.decode() if v.words else f"{v.value:.6g} {'' if v.unit == b'1' else v.unit.decode()}"
            yield f"<tr><th style='text-align:left'>{html.escape(v.name.decode())}</th><td>{html.escape(number)}</td>" \
                  f"<td style='text-align:left'>{html.escape(v.meaning.decode())}</td></tr>"

    @_alone
    def _repr_html_(self) -> str:
        """Drawing, if the command is installed, and facts, for notebooks."""
        drawing = ""
        command = shutil.which("fourlink")
        if command:
            with tempfile.TemporaryDirectory() as folder:
                picture, deck = Path(folder) / "mechanism.svg", Path(folder) / (Path(self.name).name or "deck")
                deck.write_text(self.deck())
                asked = [os.path.abspath(command), f"--plot={picture}", "--plot-kind=mechanism", f"--branch={self.branches[0]}"]
                done = subprocess.run([*asked, deck.name], cwd=folder, capture_output=True)
                drawing = picture.read_text() if done.returncode == 0 and picture.exists() else ""
        return f"{drawing}<table>{''.join(self._lines())}</table>"
