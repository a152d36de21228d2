# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinematics and kinetostatics of four-link mechanisms: results of a deck, by name.

    import fourlink
    r = fourlink.open("crusher.deck")            # or the text of a deck
    r["max(Ts)"]                                 # a fact, an extreme, an input, in the units of r.units
    theta2, Ts = r.columns("theta2, Ts")         # arrays of numpy, a number for each row
    r.at("30 deg")                               # the table's columns at a crank angle, by name
    r.at(theta4="120 deg")                       # the crank angles at which theta4 is 120 deg
    r.set("crank.length", "45 mm")               # all results are then those of the deck with this crank

Values are in the units of the results: SI and degrees, or those of the deck's [units]; r.units and r.unit(name)
tell them.  Wherever a number is given it may be text with any unit of its kind, "45 mm".  A deck with a mistake
raises Mistake, with its file and line.  The library releases the GIL while it works.  Threads may share results:
their calls take turns, and a fork waits for them.
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
import weakref
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

if TYPE_CHECKING:
    import pandas  # type: ignore[import-untyped, unused-ignore]

__all__ = ["open", "Results", "Mistake", "version"]
_OK, _BAD_DECK, _NO_MEMORY, _NO_NAME = 0, 36, 37, 41
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
                ("synthesis", c.c_ulong), ("whole_cycle", c.c_int),
                ("effort", c.c_ulong), ("near", c.c_void_p)]


class _Value(c.Structure):
    _fields_ = [("name", c.c_char_p), ("unit", c.c_char_p), ("quantity", c.c_char_p), ("meaning", c.c_char_p),
                ("source", c.c_char_p), ("words", c.c_char_p), ("value", c.c_double), ("to_si", c.c_double),
                ("has_angle", c.c_int), ("angle", c.c_double), ("branch", c.c_int), ("flags", c.c_int),
                ("handle", c.c_int), ("line_unit", c.c_char_p)]

    def get(self) -> float | str:
        words: bytes | None = self.words
        return words.decode() if words else float(self.value)


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
    and `hint`, the word that was probably meant, or None.  `others` are further mistakes of the deck.  As text it is
    FILE:LINE: MESSAGE, a line for each mistake."""

    def __init__(self, message: str, line: int = 0, file: str = "", others: list[Mistake] | None = None) -> None:
        self.message, self.line, self.file, self.others = message, line, file, others or []
        place = f"{file or 'deck'}:{line}: " if line else ""
        super().__init__("\n".join([place + message, *map(str, self.others)]))
        meant = re.search(r"did you mean '([^']*)'", message)
        self.hint = meant.group(1) if meant else None

    def __reduce__(self) -> tuple[type[Mistake], tuple[str, int, str, list[Mistake]]]:
        return Mistake, (self.message, self.line, self.file, self.others)


def version() -> str:
    """The version of the library."""
    return str(_lib.fourlink_version().decode())


def open(deck: str | os.PathLike[str], *, units: str | None = None, changes: dict[str, str | float] | None = None,
         allow_files: bool = False) -> Results:
    """Open a deck: the path of a file, or its text.

    units    of the results, such as "mm, kg, rpm", or "SI"; otherwise the deck's
    changes  as by --set: {"crank.length": "45 mm", "load P.force": "20 N at 30 deg"}; a bare number is in the
             unit of the deck's [units], SI and degrees without it
    allow_files  let the deck name files outside its folder, or for its text outside the present one
    """
    if isinstance(deck, str) and ("\n" in deck or "=" in deck):
        return Results(deck.encode(), "deck", Path(), units, changes or {}, allow_files)
    return Results(Path(deck).read_bytes(), str(deck), Path(deck).parent, units, changes or {}, allow_files)


class _Fork:
    """A fork waits until no results are in use: the child's are whole, and no thread that it does not have locks them."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._all: weakref.WeakSet[Results] = weakref.WeakSet()
        self._held: list[Results] = []
        if hasattr(os, "register_at_fork"):
            os.register_at_fork(before=self._wait, after_in_parent=self._go_on, after_in_child=self._go_on)

    def add(self, results: Results) -> None:
        with self._lock:
            self._all.add(results)

    def _wait(self) -> None:
        self._lock.acquire()
        self._held = list(self._all)
        for results in self._held:
            results._lock.acquire()

    def _go_on(self) -> None:
        for results in self._held:
            results._lock.release()
        self._held = []
        self._lock.release()


_fork = _Fork()
_Method = TypeVar("_Method", bound=Callable[..., Any])


def _alone(method: _Method) -> _Method:
    """A method that no other thread's call disturbs, and that tells if the results are closed."""
    @functools.wraps(method)
    def call(self: Results, *arguments: Any, **named: Any) -> Any:
        with self._lock:
            if not self._r:
                raise ValueError(f"the results of {self.name} are closed: open the deck again")
            return method(self, *arguments, **named)
    return call  # type: ignore[return-value]


class Results:
    """All results of a deck.  Free its memory with close(), or use it in a `with` statement; after that each use raises
    ValueError.  copy and pickle open the deck again, with the numbers set."""

    _r = c.c_void_p()

    def __init__(self, text: bytes, name: str, folder: Path, units: str | None, changes: dict[str, str | float],
                 allow_files: bool) -> None:
        self.name, self._folder, self._units, self._allow_files = name, folder, units, allow_files
        self._lock = threading.RLock()
        self._r = c.c_void_p()
        _fork.add(self)
        kept: list[bytes] = []  # what a loader has returned, until the deck is read

        def load(host: object, file_name: bytes, length: Any) -> int | None:
            path = folder / os.fsdecode(file_name)
            try:
                if not allow_files and not path.resolve().is_relative_to(folder.resolve()):
                    return None
                kept.append(path.read_bytes())
            except OSError:
                return None
            length[0] = len(kept[-1])
            return c.cast(c.c_char_p(kept[-1]), c.c_void_p).value

        source = _Source(name=name.encode(), text=text, length=len(text), load=_Loader(load),
                         units=units.encode() if units else None, n_changes=len(changes),
                         changes=(_Change * len(changes))(*[_Change(b"changes", f"{k}={v}".encode()) for k, v in changes.items()]))
        mistakes, n = (_Mistake * _MISTAKES)(), c.c_ulong()
        status = _lib.fourlink_results_open(c.byref(source), c.c_ulong(_MISTAKES), c.byref(self._r), mistakes, c.byref(n))
        if status == _BAD_DECK:
            raise self._told(mistakes[:min(n.value, _MISTAKES)])
        self._check(status)
        self._handles: dict[str, int] = {}
        self.branches: tuple[str, ...] = self._find_branches()

    def _told(self, mistakes: list[_Mistake]) -> Mistake:
        def told(m: _Mistake, others: list[Mistake]) -> Mistake:
            file = os.fsdecode(m.file)
            place = str(self._folder / file) if file not in ("", self.name) else self.name
            return Mistake(m.message.decode(errors="replace"), m.line, place if m.line else file, others)

        return told(mistakes[0], [told(m, []) for m in mistakes[1:]])

    def _check(self, status: int, what: str = "") -> None:
        if status == _OK:
            return
        words = str(_lib.fourlink_status_text(status).decode())
        if status == _NO_NAME:
            raise KeyError(f"{what}: {words}{self._meant(what)}")
        raise MemoryError(words) if status == _NO_MEMORY else ValueError(f"{what}: {words}" if what else words)

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

    def __repr__(self) -> str:
        with self._lock:
            if not self._r:
                return f"<fourlink.Results of {self.name}, closed>"
            return f"<fourlink.Results of {self.name}: {self['type']}; {' and '.join(self.branches)}, {self._n_rows()} rows>"

    @_alone
    def __reduce__(self) -> tuple[type[Results], tuple[bytes, str, Path, str | None, dict[str, str | float], bool]]:
        return Results, (self._text(), self.name, self._folder, self._units, {}, self._allow_files)

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
        if branch is not None and branch not in _BRANCHES:
            raise ValueError(f"expected the branch open or crossed, not {branch!r}")
        return _BRANCHES[branch or self.branches[0]]

    def _n_rows(self) -> int:
        rows, columns = c.c_int(), c.c_int()
        _lib.flnrow_(c.byref(self._r), c.byref(rows), c.byref(columns))
        return rows.value

    def _number(self, quantity: bytes, number: str | float, what: str) -> float:
        """A number, or text with a unit, in the unit of the results."""
        if not isinstance(number, str):
            return float(number)
        value, m = c.c_double(), _Mistake()
        deck = c.c_void_p(_lib.fourlink_results_deck(self._r))
        if _lib.fourlink_deck_quantity(deck, quantity, number.encode(), c.byref(value), c.byref(m)) == _BAD_DECK:
            raise Mistake(f"{what}: {m.message.decode(errors='replace')}")
        return value.value

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
        the deck's first branch, in the unit of the results, which unit(name) tells; "type" and the like are words."""
        return self.value(name)

    @_alone
    def value(self, name: str, angle: str | float = 0.0, branch: str | None = None) -> float | str:
        """Any number by its name, in the unit that unit(name) tells; a column at a crank angle: "30 deg", or a number in
        the results' unit of angles.  `branch` is "open" or "crossed"; without it, the deck's first."""
        if name not in self._handles:
            self._handles[name] = self._find(name).handle
        v, place = _Value(), c.c_double(self._number(b"angle", angle, "angle"))
        status = _lib.fourlink_results_get(self._r, self._handles[name], self._branch(branch), place, c.byref(v))
        self._check(status, name)
        return v.get()

    @_alone
    def unit(self, name: str) -> str:
        """The unit of a name in the results, such as "N.m"; "1" for a plain number."""
        return str(self._find(name).unit.decode())

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
        """Type, reach, limits, masses, extremes, turning moment of the deck's first branch, in the units that unit(name)
        tells."""
        return {v.name.decode(): v.get() for v in self._facts(self._branch(None), 15)}

    def _asked(self, names: str | None) -> list[str]:
        return [n for n in re.split(r"[,\s]+", names) if n] if names else [v.name.decode() for v in self._list("columns")]

    @_alone
    def columns(self, names: str | None = None, branch: str | None = None) -> np.ndarray:
        """Columns such as "theta2, Ts", one array for each, with a number for each row; without names the table's.
        They are in the units that `units` tells; NaN where the linkage cannot be assembled."""
        handles = [self._find(name).handle for name in self._asked(names)]
        n_rows = self._n_rows()
        values = np.empty((n_rows, len(handles)))
        self._check(_lib.fourlink_results_rows(self._r, self._branch(branch), c.c_ulong(0), c.c_ulong(n_rows),
                                               c.c_ulong(len(handles)), (c.c_int * len(handles))(*handles),
                                               values.ctypes.data_as(c.POINTER(c.c_double))), names or "columns")
        return values.T

    @_alone
    def frame(self, names: str | None = None, branch: str | None = None) -> pandas.DataFrame:
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
        return str(v.unit.decode())

    @_alone
    def at(self, place: str | float | None = None, names: str | None = None, branch: str | None = None,
           **value: str | float) -> Any:
        """Columns at a crank angle, or where a column has a value.

        r.at("30 deg")                     the table's columns at this crank angle: a dictionary
        r.at("30 deg", "Ts, omega4")       these, one number for each
        r.at(theta4="120 deg")             the crank angles at which theta4 is 120 deg: an array
        r.at("theta4 = 120 deg")           the same; for names such as B.x, too
        r.at(theta4="120 deg", names="Ts, omega4")  these columns there, one array for each

        A bare number is in the unit of the results, as all that is returned.
        """
        if len(value) + (place is not None) != 1:
            raise TypeError("at() takes one crank angle, or the value of one column")
        column, wanted = value.popitem() if value else ("theta2", place or 0.0)
        if isinstance(place, str) and "=" in place:
            column, wanted = (part.strip() for part in place.split("=", 1))
        if column == "theta2":
            return self._at_angle(self._number(b"angle", wanted, column), names, branch)
        own = self._find(column)
        angles = self._crossings(own.name, self._number(own.quantity, wanted, column), branch)
        asked = self._asked(names or "theta2")
        found = np.array([[self.value(x, angle, branch) for angle in angles] for x in asked])
        return found[0] if len(asked) == 1 else found

    def _crossings(self, name: bytes, value: float, branch: str | None) -> list[float]:
        room, n = 0, c.c_ulong(16)
        while n.value > room:
            room = n.value
            angles = (c.c_double * room)()
            self._check(_lib.fourlink_results_crossings(self._r, name, self._branch(branch), c.c_double(value),
                                                        c.c_ulong(room), angles, c.byref(n)), name.decode())
        return angles[:n.value]

    def _at_angle(self, angle: float, names: str | None, branch: str | None) -> Any:
        asked = self._asked(names)
        found = [self.value(name, angle, branch) for name in asked]
        return dict(zip(asked, found)) if names is None else found[0] if len(asked) == 1 else np.array(found)

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
    def _repr_svg_(self) -> str | None:
        """Drawing of the mechanism, if the command is installed, for notebooks."""
        command = shutil.which("fourlink")
        if not command:
            return None
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder) / "mechanism.svg"
            asked = [os.path.abspath(command), f"--plot={picture}", "--plot-kind=mechanism", f"--branch={self.branches[0]}"]
            done = subprocess.run(asked, cwd=self._folder, input=self._text(), capture_output=True)
            return picture.read_text(encoding="utf-8") if done.returncode == 0 and picture.exists() else None

    @_alone
    def _repr_html_(self) -> str:
        """The drawing and facts, for notebooks."""
        return f"{self._repr_svg_() or ''}<table>{''.join(self._lines())}</table>"
