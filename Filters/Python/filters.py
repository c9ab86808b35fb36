# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's filters run from Python: on all processors, their messages as Python's."""

from __future__ import annotations

import os
import re
import sys
import warnings
from typing import Any

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkSMPTools


def use_all_processors() -> None:
    """Unless the user has chosen a backend, VTK's parallel loops shall not run sequentially."""
    if vtkSMPTools.GetBackend() == "Sequential" and "VTK_SMP_BACKEND_IN_USE" not in os.environ:
        vtkSMPTools.SetBackend("STDThread")


def _level_of_user() -> int:
    """The stacklevel, for warnings issued by the caller, of the first frame outside this package."""
    package = __name__.rpartition(".")[0] + "."
    level, frame = 1, sys._getframe(1)
    while frame.f_back is not None and str(frame.f_globals.get("__name__")).startswith(package):
        level, frame = level + 1, frame.f_back
    return level


class Messages:
    """Warnings and errors of VTK objects, recorded until raise_them() makes them Python's.

    ports are what users know the inputs of a filter as, names what stands for words of its messages."""

    def __init__(self, ports: tuple[str, ...], names: dict[str, str]) -> None:
        self._ports = ports
        self._names = names
        self._recorded: list[tuple[bool, str]] = []

    def hear(self, source: Any) -> Any:
        """The given VTK object, its warnings and errors recorded from now on."""

        @calldata_type(VTK_STRING)
        def record(_caller: Any, event: str, text: str) -> None:
            self._recorded.append((event == "ErrorEvent", self._in_python(text)))

        source.AddObserver("WarningEvent", record)
        source.AddObserver("ErrorEvent", record)
        if hasattr(source, "GetExecutive"):
            source.GetExecutive().AddObserver("ErrorEvent", record)
        return source

    def raise_them(self) -> None:
        """Raises recorded errors, and issues recorded warnings."""
        messages = list(self._recorded)
        self._recorded.clear()
        for is_error, text in messages:
            if is_error:
                raise RuntimeError(text)
            warnings.warn(text, RuntimeWarning, stacklevel=_level_of_user())

    def _in_python(self, text: str) -> str:
        """A message of VTK without what it says of its objects, the meshes called what they are here."""
        said = re.sub(r"^.*?\(0x\w+\): ", "", text, flags=re.S).strip()
        said = re.sub(r"; see Skd\w+", "", said)
        for port, name in enumerate(self._ports):
            said = said.replace("Input port %d:" % port, f"Of {name},")
        for word, name in self._names.items():
            at_start = name[0].upper() + name[1:] if " " in name else name
            said = re.sub(rf"\b{word}\b", name, re.sub(rf"^{word}\b", at_start, said))
        return said


class Filter:
    """A filter whose messages are Python's. names are those of its inputs and of what its messages name."""

    def __init__(self, made: Any, names: dict[str, str]) -> None:
        use_all_processors()
        self._messages = Messages(tuple(names.values()), names)
        self.filter = self._messages.hear(made)

    def take(self, mesh: Any, source: Any = None) -> None:
        """The Input and the Source. Arrays of Python whose memory they share are kept with them."""
        self._taken = (mesh, source)
        self.filter.SetInputData(mesh)
        if source is not None:
            self.filter.SetSourceData(source)

    def output(self, port: int = 0) -> Any:
        """An output, which later ones do not change."""
        self.filter.Update()
        self._messages.raise_them()
        output = self.filter.GetOutputDataObject(port)
        kept = output.NewInstance()
        kept.ShallowCopy(output)
        return kept
