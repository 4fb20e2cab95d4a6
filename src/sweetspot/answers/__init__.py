"""What people ask: for each question one file with its typed question and answer, and the function between them.

Command line, page, notebook and Python ask here and show what comes back. No words, no options, no files.
"""
