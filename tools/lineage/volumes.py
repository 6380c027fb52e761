"""The repository has two volumes of one shape: the article, and in the folder `beyond` what is beyond it. A verb works on
the volume whose folder is its --root. The second one stands on the first, and never the first on the second; `show` and
the book know both."""

from pathlib import Path


def article(root):
    """The folder of the first volume."""
    root = Path(root)
    return root.parent if root.name == "beyond" and not (root / "paper/claims.ecsv").exists() else root


def volumes(root):
    """The folders of the volumes that are there, whichever of them `root` is."""
    first = article(root)
    return [first] + [second for second in [first / "beyond"] if (second / "src").is_dir()]


def below(root):
    """A volume and what it stands on."""
    return list(dict.fromkeys([Path(root), article(root)]))


def joined(read, folders):
    """What `read` finds in all these folders, as one dictionary."""
    return {key: value for folder in folders for key, value in read(folder).items()}
