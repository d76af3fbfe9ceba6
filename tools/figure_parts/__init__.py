"""The figures of tools/figures, a module for each paper."""
