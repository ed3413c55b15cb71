"""Files, folders and zips as models, and back."""

from __future__ import annotations

import contextlib
import dataclasses
import errno
import io
import os
import re
import stat
import uuid
import zipfile
import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Union

from . import _engine
from ._declared import declared
from ._errors import Diagnostic, InputError
from ._model import Model
from ._segmentation import Segmentation

StrPath = Union[str, "os.PathLike[str]"]

#: More files than any collection of point clouds has: a wrong folder was given.
MOST_FILES = 200_000
#: Zips within zips that are opened, the outermost among them.
DEPTH = 2
#: What all files of a zip may unpack to.
MOST_UNPACKED = 4 << 30

STEP = (".step", ".stp", ".p21")
_STEP_FILE = re.compile(rf"(?:{'|'.join(map(re.escape, STEP))})(?:\.gz)?$", re.IGNORECASE)


def is_step(path: str) -> bool:
    """Whether a file is called as STEP files are, packed by gzip or not."""
    return _STEP_FILE.search(path) is not None


def is_array_file(path: str) -> bool:
    """Whether a file is called as HDF5 files are, which a module of its own opens."""
    apart = (kind["endings"] for kind in declared()["fileKinds"] if kind["openedApart"])
    return path.lower().endswith(tuple(f".{ending}" for endings in apart for ending in endings))


def name_of_part(path: str) -> str:
    """The name of a STEP file without folders and endings: that of its model."""
    return _STEP_FILE.sub("", re.split(r"[/\\]", path)[-1])


@dataclass(frozen=True)
class File:
    """A file, or an entry of a zip, that is read when its turn comes; on another machine too."""

    path: str
    size: int
    chain: tuple[str, ...]
    """The file, then the entry in it, then the entry in that."""
    place: Optional[int] = None
    """Where the chain ends in an HDF5 file, the place of what is meant among the files of models in it."""

    def read(self) -> bytes:
        """Its content. Raises ``OSError`` with a reason where it cannot be had."""
        if self.place is not None:
            try:
                return self.opened().read(self.place)
            except ValueError as error:
                raise OSError(0, str(error)) from error
        file, *entries = self.chain
        try:
            if not entries:
                return Path(file).read_bytes()
            with contextlib.ExitStack() as open_ones:
                opened: Any = file
                for entry in entries:
                    stream = open_ones.enter_context(open_ones.enter_context(zipfile.ZipFile(opened)).open(entry))
                    # No more than is read at most, whatever the entry says of its size.
                    content = stream.read(declared()["limits"]["fileBytes"] + 1)
                    opened = io.BytesIO(content)
                return content
        except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError) as error:
            raise OSError(0, f"the zip is damaged: {error}") from error


    @property
    def has_parts(self) -> bool:
        """Whether the bytes between two offsets can be had without the others: of a file, or an entry of a zip."""
        return len(self.chain) <= 2 and self.place is None

    def parts(self) -> Callable[[int, int], bytes]:
        """What gives the bytes between two offsets; raises ``OSError`` as :meth:`read`."""
        if len(self.chain) > 1:
            return _Unpacked(*self.chain).part

        def part(start: int, end: int) -> bytes:
            with open(self.chain[0], "rb") as stream:
                stream.seek(start)
                return stream.read(end - start)

        return part

    def opened(self, path: str = "") -> _engine.ArrayFile:
        """The HDF5 file that the chain ends in. Raises ``ValueError`` where it cannot be opened."""
        whole = File(path, 0, self.chain)
        if len(self.chain) == 1:
            return _engine.ArrayFile(path, os.stat(self.chain[0]).st_size, whole.parts())
        content = whole.read()
        return _engine.ArrayFile(path, len(content), lambda start, end: content[start:end])


class _Unpacked:
    """An entry of a zip, unpacked from its beginning as far as it is asked for. Forwards, only what was asked for last is
    held; what comes before that is unpacked anew."""

    def __init__(self, file: str, entry: str) -> None:
        self._file, self._entry = file, entry
        self._stream: Any = None
        self._start, self._held = 0, b""

    def part(self, start: int, end: int) -> bytes:
        try:
            if self._stream is None or start < self._start:
                with zipfile.ZipFile(self._file) as archive:
                    # It keeps the file open as long as it is used itself.
                    self._stream = archive.open(self._entry)
                self._start, self._held = 0, b""
            while self._start + len(self._held) < start:
                passed = self._stream.read(min(_PIECE, start - self._start - len(self._held)))
                if not passed:
                    break
                self._start, self._held = self._start + len(self._held), passed
            self._held = self._held[max(0, start - self._start) :]
            self._start = start
            self._held += self._stream.read(max(0, end - start - len(self._held)))
            return self._held[: end - start]
        except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError) as error:
            raise OSError(0, f"the zip is damaged: {error}") from error


#: Bytes read at a time of what nobody has asked for.
_PIECE = 1 << 22

#: Gets the path and the content of each file that is read, piece by piece from its beginning.
Hear = Callable[[str, bytes], None]


class _Heard:
    """A file that is heard while it is read, whole or in pieces."""

    def __init__(self, file: File, hear: Hear) -> None:
        self._file, self._hear = file, hear
        self._parts: Optional[Callable[[int, int], bytes]] = None
        self._end: Optional[int] = None
        """Up to where it was heard; ``None`` before it is read in pieces."""

    def read(self) -> bytes:
        content = self._file.read()
        self._hear(self._file.path, content[self._end or 0 :])
        self._end = None
        return content

    def part(self, start: int, end: int) -> bytes:
        self._parts = self._parts or self._file.parts()
        content = self._parts(start, end)
        heard = self._end or 0
        self._end = heard
        if start <= heard < start + len(content):
            self._hear(self._file.path, content[heard - start :])
            self._end = start + len(content)
        return content

    def finish(self) -> None:
        """Has the rest heard that was not needed."""
        while self._end is not None and self._end < self._file.size:
            before = self._end
            self.part(before, min(self._file.size, before + _PIECE))
            if self._end == before:
                return


def unusable(file: str, message: str, hint: str = "", severity: str = "error") -> Diagnostic:
    """A finding about a whole file."""
    return Diagnostic(severity, file, message, hint=hint)


_COMMON = {
    errno.ENOENT: "there is no such file or folder",
    errno.ELOOP: "it is a loop of links",
    errno.EISDIR: "it is a folder",
    errno.ENOTDIR: "a part of its path is a file, not a folder",
    errno.EEXIST: "a part of its path is a file, not a folder",
    errno.ENAMETOOLONG: "its name is too long",
    errno.EIO: "the disk failed",
}
_READING = {**_COMMON, errno.EACCES: "reading it is not permitted", errno.EPERM: "reading it is not permitted"}
_WRITING = {
    **_COMMON,
    errno.EACCES: "writing it is not permitted",
    errno.EPERM: "writing it is not permitted",
    errno.EROFS: "what is there can only be read",
    errno.ENOSPC: "the disk is full",
    getattr(errno, "EDQUOT", errno.ENOSPC): "the disk is full",
    errno.EFBIG: "it is larger than a file may be",
}


def why_unread(error: OSError) -> str:
    """Why something could not be read, in the words of the command line."""
    return _READING.get(error.errno or 0) or error.strerror or str(error)


def why_unwritten(error: OSError) -> str:
    """Why something could not be written."""
    return _WRITING.get(error.errno or 0) or error.strerror or str(error)


def collect(paths: Iterable[StrPath]) -> tuple[list[File], list[Diagnostic]]:
    """What lies behind the paths, sorted, each file once, and what could not be listed. Nothing is read but the
    directories of zips. Links to folders and hidden folders are not followed."""
    files: dict[str, File] = {}
    problems: list[Diagnostic] = []
    for path in paths:
        _visit(os.fspath(path), files, problems)
    opened = _opened(files.values(), problems)
    return sorted(opened, key=lambda file: file.path), problems


def _opened(files: Iterable[File], problems: list[Diagnostic]) -> Iterator[File]:
    """The files with every HDF5 file replaced by what it holds; of all of which the same is to be said, it is said once."""
    notes: dict[str, list[str]] = {}
    for file in files:
        if not is_array_file(file.path):
            yield file
            continue
        try:
            opened = dataclasses.replace(file, place=0).opened(file.path)
        except (ValueError, OSError) as error:
            reason = why_unread(error) if isinstance(error, OSError) else str(error)
            problems.append(unusable(file.path, reason))
            continue
        for note in opened.notes():
            notes.setdefault(note, []).append(file.path)
        for place, (path, size) in enumerate(opened.entries()):
            yield File(path, size, file.chain, place)
    for note, (first, *more) in notes.items():
        told = f"{note}. So it is with {len(more)} more of the files" if more else note
        problems.append(unusable(first, told, severity="note"))


def _visit(path: str, files: dict[str, File], problems: list[Diagnostic]) -> None:
    try:
        about = os.stat(path)
        if stat.S_ISDIR(about.st_mode):
            with os.scandir(path) as entries:
                for entry in sorted(entries, key=lambda entry: entry.name):
                    folder = entry.is_dir()
                    if not (folder and (entry.name.startswith(".") or entry.is_symlink())):
                        _visit(os.path.join(path, entry.name), files, problems)
            return
        if not stat.S_ISREG(about.st_mode):
            raise OSError(0, "it is neither a file nor a folder")
        if len(files) >= MOST_FILES:
            raise OSError(0, f"there are more than {MOST_FILES} files")
        key = os.path.realpath(path)
        if path.lower().endswith(".zip"):
            with zipfile.ZipFile(path) as archive:
                _list_zip(archive, path, (key,), files, problems)
        else:
            files.setdefault(key, File(path, about.st_size, (path,)))
    except OSError as error:
        problems.append(unusable(path, why_unread(error)))
    except (zipfile.BadZipFile, ValueError) as error:
        problems.append(unusable(path, f"the zip is damaged: {error}", "Pack it again"))


def _list_zip(
    archive: zipfile.ZipFile, path: str, chain: tuple[str, ...], files: dict[str, File], problems: list[Diagnostic]
) -> None:
    most = declared()["limits"]["fileBytes"]
    unpacked = 0
    for entry in archive.infolist():
        where, own = f"{path}/{entry.filename}", (*chain, entry.filename)
        if entry.is_dir():
            continue
        unpacked += entry.file_size
        if unpacked > MOST_UNPACKED or len(files) >= MOST_FILES:
            problems.append(unusable(path, "there is more in the zip than is unpacked; the rest was left", "Split it"))
            return
        file = File(where, entry.file_size, own)
        if entry.flag_bits & 1:
            problems.append(unusable(where, "it is encrypted", "Pack it without a password", "warning"))
        elif entry.filename.lower().endswith(".zip") and len(chain) < DEPTH and entry.file_size <= most:
            try:
                with zipfile.ZipFile(io.BytesIO(file.read())) as within:
                    _list_zip(within, where, own, files, problems)
            except (zipfile.BadZipFile, OSError, ValueError) as error:
                problems.append(unusable(where, f"the zip is damaged: {error}", "Pack it again"))
        else:
            files["\0".join(own)] = file


@dataclass(frozen=True)
class Placed:
    """A file of a model: what it holds, and whose it is."""

    file: File
    role: str
    method: Optional[str]
    first: Optional[int]


@dataclass(frozen=True)
class Group:
    """The files of one model, not yet read; a STEP file is a model by itself."""

    name: str
    files: tuple[Placed, ...]
    step: Optional[File] = None

    def read(
        self,
        wanted: Callable[[Placed], bool] = lambda _: True,
        hear: Optional[Hear] = None,
        **options: Any,
    ) -> Model:
        """Reads the model; what is wrong with it is among its diagnostics. ``hear`` gets the path and content of
        each file that is read, piece by piece from its beginning. The options are those of an import."""
        tell: Hear = hear or (lambda path, content: None)
        if self.step is not None:
            return _imported(self.name, self.step, _Heard(self.step, tell).read, options)
        files = [(placed, _Heard(placed.file, tell)) for placed in self.files if wanted(placed)]
        given = [
            (placed.file.path, placed.role, placed.method, placed.first, placed.file.size, heard.read, heard.part)
            if placed.file.has_parts
            else (placed.file.path, placed.role, placed.method, placed.first, placed.file.size, heard.read, None)
            for placed, heard in files
        ]
        found = _engine.read(self.name, given)
        if hear is not None:
            for _, heard in files:
                heard.finish()
        cloud = found["cloud"]
        truth = None if found["truth"] is None else Segmentation(found["truth"], cloud)
        submissions = {method: Segmentation(native, cloud) for method, native in found["submissions"]}
        model = Model(cloud, truth, submissions, self.name)
        model._findings, model.fitted = found["findings"], set(found["fitted"])
        return model


def _imported(name: str, file: File, read: Callable[[], bytes], options: dict[str, Any]) -> Model:
    try:
        cloud, truth, report = _engine.import_step(name, read(), **options)
    except (ValueError, OSError) as error:
        reason = why_unread(error) if isinstance(error, OSError) else str(error)
        raise InputError(unusable(file.path, reason)) from error
    model = Model(cloud, None if truth is None else Segmentation(truth, cloud), name=name)
    model.imported = report
    return model


Overrides = Mapping[str, Mapping[str, Any]]


def grouped(
    files: list[File], overrides: Optional[Overrides] = None, *, imports: bool = True
) -> tuple[list[Group], list[Diagnostic]]:
    """The models among the files, in the order people count, and what belongs to none; as that counts a STEP file
    that is not to be imported."""
    known = {
        path: (it.get("role"), it.get("model"), it.get("method"), it.get("first"))
        for path, it in (overrides or {}).items()
    }
    steps = [file for file in files if imports and is_step(file.path)]
    own = {file.path: file for file in files if not (imports and is_step(file.path))}
    grouping = _engine.group(list(own), known)
    groups = [
        Group(name, tuple(Placed(own[path], role, method, first) for path, role, method, first in placed))
        for name, placed in grouping["models"]
    ]
    groups += [Group(name_of_part(file.path), (), file) for file in steps]
    told = [unusable(path, reason, severity="warning") for path, reason in grouping["unplaced"]]
    return groups, told


def read_all(*paths: StrPath, overrides: Optional[Overrides] = None, **options: Any) -> Iterator[Model]:
    """Reads every model among files, folders and zips, one at a time, in the order people count.

    A broken file keeps no other from being read: what is wrong is among the ``diagnostics`` of its model, or warned
    of where it belongs to none. ``overrides`` say, by path, what is known better about a file than its name tells:
    its ``role``, ``model``, ``method`` (empty for the truth) and what its indices count from (``first``: 0 or 1).
    Options are those of :func:`read`.
    """
    import warnings

    files, problems = collect(paths)
    groups, unplaced = grouped(files, overrides)
    for problem in [*problems, *unplaced]:
        warnings.warn(str(problem), stacklevel=2)
    for group in groups:
        try:
            yield group.read(**options)
        except InputError as error:
            warnings.warn(str(error), stacklevel=2)


def read(
    *paths: StrPath,
    strict: bool = True,
    name: Optional[str] = None,
    overrides: Optional[Overrides] = None,
    **options: Any,
) -> Model:
    """Reads one model from its files: a cloud of any kind, with its truth and what methods found, if they are there.

    Files are told by their content, and by their names which is whose. Kinds that are read, packed by gzip or in a
    folder or zip too:

    KINDS

    Of STEP (``.step .stp .p21``) the points are made here: ``points`` or ``spacing`` (mm), ``spread``
    (``even``, ``random``, or ``scan`` from so many ``views``), ``least``, ``seed``, ``named``, ``outer`` and ``separate`` are
    then those of the command line, and ``bodies`` are the numbers of those that are wanted (``declared()["importOptions"]``).

    Among several models ``name`` chooses one. Segments that come without surfaces get them by least squares
    (``Model.fitted``). Raises :class:`InputError` with file, line and what to do where something that was needed
    cannot be used; with ``strict=False`` that is told in ``Model.diagnostics`` and the rest is read.
    """
    files, problems = collect(paths)
    groups, unplaced = grouped(files, overrides)
    if name is not None:
        groups = [group for group in groups if group.name == name]
    if len(groups) != 1:
        where = ", ".join(os.fspath(path) for path in paths)
        wrong = [problem for problem in problems if problem.severity == "error"]
        if not groups:
            message = "there is no model among the files" if name is None else f"there is no model `{name}`"
            raise InputError(*wrong, *unplaced, unusable(where, message, "A model needs at least a cloud"))
        found = ", ".join(group.name for group in groups[:8]) + (", …" if len(groups) > 8 else "")
        raise InputError(unusable(where, f"there are {len(groups)} models: {found}", "Choose one by name=…, or use read_all"))
    model = groups[0].read(**options)
    if strict:
        wrong = [each for each in [*problems, *model.diagnostics] if each.severity == "error"]
        if wrong:
            raise InputError(*wrong)
    return model


def _kinds() -> str:
    """The kinds of files that are declared, one a line."""
    kinds = (f"* {kind['title']} (``.{' .'.join(kind['endings'])}``): {kind['meaning']}" for kind in declared()["fileKinds"])
    return "\n    ".join(kinds)


read.__doc__ = (read.__doc__ or "").replace("KINDS", _kinds())


@contextlib.contextmanager
def whole(path: StrPath) -> Iterator[Any]:
    """A file that is under its name only once it is complete."""
    target = Path(path)
    target.parent.mkdir(parents=True, exist_ok=True)
    part = target.with_name(f".fit4cad-{uuid.uuid4().hex}.part")
    try:
        # Made as any other file is: who may read it is the user's own affair.
        with open(part, "xb") as stream:
            yield stream
        os.replace(part, target)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(part)
        raise


def write_whole(path: StrPath, content: Union[str, bytes]) -> Path:
    """Writes a file whole or not at all, and makes its folder if missing."""
    with whole(path) as stream:
        stream.write(content.encode() if isinstance(content, str) else content)
    return Path(path)


def texts_of(model: Model, method: Optional[str] = None) -> dict[str, str]:
    """The texts of the benchmark's files by role: without a method cloud and truth, else the method's three."""
    bare = method is None and model.truth is None
    texts = _engine.write(model._cloud, None if bare else model.segmentation(method)._native)
    return texts if method is None else {role: text for role, text in texts.items() if role != "cloud"}


def export(model: Model, form: str, method: Optional[str] = None) -> bytes:
    """A method's result, or the truth, in a form of ``declared()["exports"]`` or as ``step``."""
    from ._palette import SEGMENTS, TYPES

    found = model.segmentation(method)
    if form == "step":
        text, _ = _engine.export_step(model.name, model._cloud, found._native, TYPES())
        return text.encode()
    name = "truth" if method is None else method
    return _engine.export(form, model._cloud, found._native, model.name, name, method in model.fitted, SEGMENTS)


def write(
    model: Model, path: StrPath, method: Optional[str] = None, *, form: Optional[str] = None, layout: str = "beside"
) -> list[Path]:
    """Writes the truth, or what a method found; gives the paths written, each whole or not at all.

    A path without an ending is a folder, which gets the benchmark's own files in the layout ``beside`` or
    ``test-set``; otherwise the ending tells the form (``declared()["exports"]``: ``.ply``, ``.npz``, ``.vg``,
    ``.xyzc``, ``.csv``, ``.json``, ``.obj``, ``.stl``, ``.glb``; and ``.step``), unless ``form`` names it.
    """
    target = Path(path)
    if form is None and target.suffix == "":
        texts = texts_of(model, method)
        paths = {role: target / _engine.path_of(layout, model.name, role, method) for role in texts}
        return [write_whole(paths[role], text) for role, text in texts.items()]
    if form is None:
        ending = target.suffix.lower()
        forms = [each["name"] for each in declared()["exports"] if each["ending"].lower().endswith(ending)]
        form = "step" if ending in STEP else next(iter(forms), None)
    if form is None:
        endings = sorted({"." + each["ending"].rsplit(".", 1)[-1] for each in declared()["exports"]} | {".step"})
        raise ValueError(f"{target}: no form has this ending; there are {', '.join(endings)}")
    return [write_whole(target, export(model, form, method))]
