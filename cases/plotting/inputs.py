"""Readers of the tables that a case writes; every fault names the file, the line and the column."""
import csv
import json

import numpy as np


class InputError(Exception):
    """A file of the run is missing or broken; the text names it."""


class MissingInput(InputError):
    """It is not there, or lacks an array or a result; whatever it holds is whole."""


def read_text(path):
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except FileNotFoundError:
        raise MissingInput(f"{path}: missing") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text file") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None


def number(text):
    """Empty means undefined: no contact has no ends."""
    return float(text) if text.strip() else np.nan


def convert(path, column, cells, lines):
    """Numbers of one column; lines: the line of the file that each cell comes from."""
    values = np.empty(len(cells))
    for i, text in enumerate(cells):
        try:
            values[i] = number(text)
        except ValueError:
            raise InputError(f"{path}: line {lines[i]}, column {column}: not a number: {text!r}") from None
    return values


def read_table(path, numbers, texts=(), rows=1):
    """CSV as {column: array}. numbers, texts: columns that must be there; others are left out. rows: least number."""
    reader = csv.reader(read_text(path).splitlines())
    header = [name.strip() for name in next(reader, [])]
    missing = [name for name in (*numbers, *texts) if name not in header]
    if missing:
        raise InputError(f"{path}: no column {', '.join(missing)} in the header")
    lines, cells = [], []
    for row in reader:
        if len(row) != len(header) and row:
            raise InputError(f"{path}: line {reader.line_num}: {len(row)} fields, expected {len(header)}")
        if row:
            lines.append(reader.line_num)
            cells.append(row)
    if len(cells) < rows:
        raise InputError(f"{path}: {len(cells)} lines of data, expected at least {rows}")
    column = {name: [row[header.index(name)] for row in cells] for name in (*numbers, *texts)}
    table = {name: convert(path, name, column[name], lines) for name in numbers}
    table.update({name: np.array([text.strip() for text in column[name]], dtype=str) for name in texts})
    return table


def read_whole_table(path, texts=(), rows=1):
    """The same with all columns: those in texts as words, the others as numbers."""
    return read_table(path, [name for name in header_of(path) if name not in texts], texts, rows)


def header_of(path):
    return [name.strip() for name in next(csv.reader(read_text(path).splitlines()[:1]), [])]


def read_summary(path):
    """JSON object as dict."""
    try:
        summary = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise InputError(f"{path}: line {error.lineno}: not valid JSON: {error.msg}") from None
    if not isinstance(summary, dict):
        raise InputError(f"{path}: expected a JSON object, got {type(summary).__name__}")
    return summary


def option(summary, *names):
    """The first of the named options that is a finite number, otherwise None."""
    options = summary.get("options")
    for name in names if isinstance(options, dict) else ():
        try:
            value = float(options[name])
        except (KeyError, TypeError, ValueError):
            continue
        if np.isfinite(value):
            return value
    return None
