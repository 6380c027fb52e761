"""`pip install .`: what pip asks of a project (PEP 517). Nothing is downloaded for it, since this file needs no module but
the standard library's, and CMake builds the wheel from what is installed (README, *From Python*).

A wheel is a zip file of the package with a folder that says what it is. Version, title and authors are those of
codemeta.json. The build stays in build/wheel, so that a second `pip install .` compiles what has changed."""

import base64
import hashlib
import json
import os
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NAME = "breathers_lattice"
TAG = "-".join([f"cp{sys.version_info.major}{sys.version_info.minor}"] * 2 + [sysconfig.get_platform().replace("-", "_").replace(".", "_")])


def described():
    """The folder of the wheel that says what it is, and its files but for the list of all."""
    meta = json.loads((ROOT / "codemeta.json").read_text(encoding="utf-8"))
    said = {"Metadata-Version": "2.1", "Name": NAME.replace("_", "-"), "Version": meta["version"], "Summary": meta["name"],
            "Author": ", ".join(one["name"] for one in meta["author"]), "License": meta["license"].rsplit("/", 1)[-1],
            "Keywords": ",".join(meta["keywords"]), "Requires-Python": ">=3.9", "Requires-Dist": "numpy"}
    files = {"METADATA": "".join(f"{name}: {value}\n" for name, value in said.items()) + "\n" + meta["description"] + "\n",
             "WHEEL": f"Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\nTag: {TAG}\n",
             "LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8")}
    return f"{NAME}-{meta['version']}.dist-info", files


def pack(package, wheel_directory):
    """The wheel of a compiled package; returns its name. Equal contents give equal bytes."""
    folder, files = described()
    contents = {f"lattice/{path.name}": path.read_bytes() for path in sorted(package.iterdir()) if path.is_file()}
    contents |= {f"{folder}/{name}": text.encode() for name, text in files.items()}
    sums = {name: base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode() for name, data in contents.items()}
    record = "".join(f"{name},sha256={sums[name]},{len(data)}\n" for name, data in contents.items())
    contents[f"{folder}/RECORD"] = (record + f"{folder}/RECORD,,\n").encode()
    name = f"{folder.removesuffix('.dist-info')}-{TAG}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in contents.items():
            wheel.writestr(zipfile.ZipInfo(path), data, zipfile.ZIP_DEFLATED)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = f"build/wheel/{TAG}"
    for command in (["sh", "tools/configure.sh", build, ".", "-DLATTICE_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}"],
                    ["cmake", "--build", build, "--target", "python_module", "--parallel", str(os.cpu_count() or 2)]):
        if subprocess.run(command, cwd=ROOT, check=False).returncode:
            sys.exit("lattice: CMake failed to build the Python module; see its messages above")
    return pack(ROOT / build / "python/lattice", wheel_directory)
