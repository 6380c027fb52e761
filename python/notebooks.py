"""Runs the notebooks and compares what they say with what they hold:

    python3 python/notebooks.py [--renew] [NOTEBOOK ...]

The cells of a notebook are executed one after the other, as Jupyter does it but without Jupyter, so that a bare machine
can test them. Texts have to be equal; a picture has to be drawn where there is one, and its bytes are those of one
version of matplotlib. `--renew` writes both into the notebooks.
"""

import ast
import base64
import contextlib
import io
import json
import os
import sys
from pathlib import Path

os.environ["MPLBACKEND"] = "Agg"
FOLDER = Path(__file__).parent


def pictures():
    """All open figures as PNG, without a date or a version."""
    if "matplotlib.pyplot" not in sys.modules:
        return []
    plt = sys.modules["matplotlib.pyplot"]
    out = []
    for number in plt.get_fignums():
        file = io.BytesIO()
        plt.figure(number).savefig(file, format="png", dpi=80, bbox_inches="tight", metadata={"Software": None})
        out.append(base64.b64encode(file.getvalue()).decode())
    plt.close("all")
    return out


def execute(source, names, count):
    """The outputs of a cell, in the format of notebooks."""
    body = ast.parse(source).body
    last = body.pop() if body and isinstance(body[-1], ast.Expr) else None
    said, outputs, value = io.StringIO(), [], None
    with contextlib.redirect_stdout(said):
        exec(compile(ast.Module(body, []), "<cell>", "exec"), names)
        if last:
            value = eval(compile(ast.Expression(last.value), "<cell>", "eval"), names)
    if said.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": said.getvalue().splitlines(True)})
    for picture in pictures():
        outputs.append({"data": {"image/png": picture}, "metadata": {}, "output_type": "display_data"})
        value = None  # what a drawing function returns says nothing
    if value is not None:
        outputs.append({"data": {"text/plain": repr(value).splitlines(True)}, "execution_count": count, "metadata": {},
                        "output_type": "execute_result"})
    return outputs


def comparable(outputs):
    """What must be equal: texts, and that there is a picture."""
    return [o.get("text") or o["data"].get("text/plain") or list(o["data"]) for o in outputs]


def run(path, renew=False):
    """Executes a notebook; returns what differs."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    names, complaints, count = {"__name__": "__main__"}, [], 0
    for cell in notebook["cells"]:
        if cell["cell_type"] != "code":
            continue
        count += 1
        outputs = execute("".join(cell["source"]), names, count)
        if comparable(outputs) != comparable(cell["outputs"]):
            complaints.append(f"{path.name}, cell {count}:\n  holds {comparable(cell['outputs'])}\n  says {comparable(outputs)}")
        cell["outputs"], cell["execution_count"] = outputs, count
    if renew:
        path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        return []
    return complaints


def main(words):
    renew = "--renew" in words
    paths = [Path(w) for w in words if w != "--renew"] or sorted(FOLDER.glob("*.ipynb"))
    complaints = [c for path in paths for c in run(path, renew)]
    print("\n".join(complaints) if complaints else f"{len(paths)} notebooks")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
