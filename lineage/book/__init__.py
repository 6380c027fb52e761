"""The weaver: chapters and library headers become the pages of the book.

    source   a source as prose and code in turn
    prose    prose to HTML, by pandoc and KaTeX
    code     colours, line numbers and links of code, by Pygments
    origin   the lines that recorded a number
    record   what is known of numbers and figures
    bind     what prose mentions, bound to what made it
    pages    the pages, by the templates in book/templates
    check    whether a finished book is whole
    weave    all of it
    browse   the book in a headless Chromium, by Selenium
"""
