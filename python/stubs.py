"""Writes lattice/__init__.pyi and py.typed beside a compiled module, for editors and type checkers:

    stubs.py build/python

Names, parameters and defaults are those of the module itself, which has them from the commands; so the file is never
older than the module. Only what Python does not know is told here, the type of what has a plain name: one that is not in
the lists ends in a KeyError, and the build with it. numpy need not be there, since nothing is computed."""

import inspect
import sys
import types
from pathlib import Path

HEAD = '''# Written by python/stubs.py from the options that the commands declare; do not edit.
from collections.abc import Callable
from typing import Any, Literal

from numpy.typing import ArrayLike, NDArray

Number = float | str  # a text is read as on a command line: "-1/6"
Function = Callable[[NDArray[Any]], ArrayLike]
__version__: str

'''
KINDS = {"chain": "Chain | None", "mass": "ArrayLike | None", "eta": "ArrayLike | None", "y": "ArrayLike", "v": "ArrayLike",
         "damping": "ArrayLike", "energy": "Function", "force": "Function", "stiffness": "Function", "quantities": "dict[str, Estimate]",
         "arrays": "Any", "exact": "bool", "unit": "str", "meaning": "str", "reason": "str", "count": "int"}
PLAIN = ("value", "error", "rim", "opening", "exponent", "time", "period", "sample", "tolerance", "frequency")
SPECIAL = {("drive", "chain"): "Chain", ("drive", "force"): "float"}
RETURNED = {**dict.fromkeys(("evolve", "orbit", "multipliers"), "Result"), "energy_density": "NDArray[Any]", "accelerations": "NDArray[Any]", "set_threads": "None"}
ATTRIBUTES = {
    "Chain": {"sites": "int", "well": "str", "contact": "str", "ends": "str", "mass": "NDArray[Any]", "eta": "NDArray[Any]", "onsite": "str"},
    "Well": {"rim": "float", "functions": "tuple[Function, Function, Function]"},
    "Contact": {"opening": "float", "exponent": "float", "functions": "tuple[Function, Function, Function]"},
    "Estimate": {"error": "float", "unit": "str", "exact": "bool", "meaning": "str", "reason": "str"},
    "Result": {"quantities": "dict[str, Estimate]"}}


def kind_of(owner, parameter, options):
    """The type of a parameter: of an option by what it allows, of anything else by its name."""
    name = parameter.name
    if parameter.kind is parameter.KEYWORD_ONLY or name == "sites":
        allowed = options[name.replace("_", "-")]
        if allowed.startswith("["):
            return "Number" + (" | None" if parameter.default is None else "")
        named = "Literal[" + ", ".join(f'"{one}"' for one in allowed.split(", ")) + "]"
        return f"{named} | {name.capitalize()}" if name in ("well", "contact") else named
    return SPECIAL.get((owner, name)) or ("float" if name in PLAIN else KINDS[name])


def written(owner, signature, options):
    """The parameters of a call, as a stub has them."""
    parts, starred = [], False
    for p in signature.parameters.values():
        if p.name == "self" or p.name == "cls":
            parts.append(p.name)
        elif p.kind is p.VAR_KEYWORD:
            parts.append(f"**{p.name}: {kind_of(owner, p, options)}")
        else:
            if p.kind is p.KEYWORD_ONLY and not starred:
                starred = True
                parts.append("*")
            default = "" if p.default is p.empty else " = ..." if p.default == float("inf") else f" = {p.default!r}"
            parts.append(f"{p.name}: {kind_of(owner, p, options)}{default}")
    return ", ".join(parts)


def class_of(name, cls, options):
    yield f"class {name}({'float' if issubclass(cls, float) else ''}):".replace("()", "")
    told = {member for one in cls.__mro__ for member, value in vars(one).items() if not member.startswith("_")
            and (isinstance(value, property) or inspect.isdatadescriptor(value)) and one not in (float, object)}
    if lost := told - set(ATTRIBUTES[name]):
        raise KeyError(f"{name}: no type is told of {', '.join(sorted(lost))}")
    yield from (f"    {member}: {kind}" for member, kind in ATTRIBUTES[name].items())
    maker, call = ("__new__", cls.__new__) if issubclass(cls, float) else ("__init__", cls)
    first = "self, " if maker == "__init__" else ""
    yield f"    def {maker}({first}{written(name, inspect.signature(call), options)}) -> {'None' if first else name}: ..."
    for member, value in vars(cls).items():
        if inspect.isfunction(value) and not member.startswith("_"):
            yield f"    def {member}({written(f'{name}.{member}', inspect.signature(value), options)}) -> {RETURNED[member]}: ..."
    if name == "Result":
        yield "    def __getattr__(self, name: str) -> Any: ...  # quantities are Estimates, arrays of numpy the rest"


def stub(lattice):
    """The text of lattice/__init__.pyi."""
    blocks = [f"__all__ = {lattice.__all__!r}".replace("'", '"')]
    for name in lattice.__all__:
        what = getattr(lattice, name)
        options = {option: allowed for option, _, allowed, *_ in lattice._lattice.options.get(name, ())}
        if inspect.isclass(what):
            blocks.append("\n".join(class_of(name, what, options)))
        else:
            said = written(name, inspect.signature(what), options)
            blocks.append(f"def {name}({said}) -> {RETURNED.get(name, 'Result')}: ...")
    return HEAD + "\n\n".join(blocks) + "\n"


def main(folder):
    sys.path.insert(0, str(folder))
    try:
        import numpy  # noqa: F401
    except ImportError:
        sys.modules["numpy"] = types.ModuleType("numpy")
    import lattice
    (Path(folder) / "lattice/__init__.pyi").write_text(stub(lattice), encoding="utf-8")
    (Path(folder) / "lattice/py.typed").write_text("", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
