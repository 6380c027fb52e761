"""codecheck.yml, what a codechecker is asked to compare: every figure, and the table of published against reproduced.

The form is that of https://codecheck.org.uk/spec/config/1.0/. The article and the figures have one place each,
codemeta.json and figures/figures.ecsv, from which `make refresh` writes it. Codechecker, report and certificate are the
codechecker's to fill in. The paths hold after `make figures` and in the archive of `make dist` alike."""

from pathlib import Path

from . import ecsv, metadata

CLAIMS = "build/report/claims.ecsv"


def drawn(row):
    """Where a figure lies after `make figures`, without its ending."""
    return f"build/figures/{Path(row['script']).stem}"


def called(id):
    """What a reader calls a figure: that of the article by its number, ours as make does."""
    return f"Figure {id} of this edition, beyond the article" if id.startswith("x") else f"Figure {int(id)} of the article"


def text(root):
    figures = ecsv.read(Path(root) / "figures/figures.ecsv", ("id", "script", "caption")).by("id", "figures")
    article = metadata.article(metadata.read(root))
    manifest = [{"file": drawn(f) + ".pdf", "comment": f"{called(id)}: {f['caption']}"} for id, f in figures.items()]
    manifest.append({"file": CLAIMS, "comment": "Every claim of the article: printed, computed, error and verdict"})
    return "---\n" + metadata.NOTE.replace(metadata.SOURCE, f"{metadata.SOURCE} and figures/figures.ecsv") + metadata.yaml({
        "version": "https://codecheck.org.uk/spec/config/1.0/",
        "paper": {"title": article["title"],
                  "authors": [{"name": f"{one['given-names']} {one['family-names']}"} for one in article["authors"]],
                  "reference": f"https://doi.org/{article['doi']}"},
        "manifest": manifest})
