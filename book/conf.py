"""Sphinx's settings for the book. `make weave` calls it:

    sphinx-build -n -W --keep-going -E -c book build/pages build/book

The extension `literate` beside this file writes the pages into the folder that Sphinx reads."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[1] / "tools")]

project = "Breathers with Hertzian contacts"
author = "the authors of CITATION.cff"
extensions = ["myst_parser", "literate"]
language = "en"
highlight_language = "none"
pygments_style, pygments_dark_style = "friendly", "github-dark"

myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_dmath_double_inline = True  # a displayed formula within a paragraph
myst_url_schemes = ["http", "https", "mailto", "cell", "statement", "finding"]

html_theme = "furo"
html_title = project
html_static_path = ["static"]
html_css_files = ["katex.css", "style.css"]
html_math_renderer = "katex"
html_use_index = html_copy_source = html_show_sourcelink = html_show_copyright = html_show_search_summary = False
html_theme_options = {"light_css_variables": {"color-brand-primary": "#1d4e89", "color-brand-content": "#1d4e89"},
                      "dark_css_variables": {"color-brand-primary": "#8ab8f0", "color-brand-content": "#8ab8f0"}}
