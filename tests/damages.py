"""How a file, or a folder of files, is damaged: by bytes, as text, as NetCDF, as Zarr.

Each function draws a damage, makes it in place and returns in words what it was.
"""

import json
import os
import re
import shutil

import numpy as np
import xarray

NUMBERS = (
    *("nan", "inf", "-inf", "1e308", "-1e308", "1e-300", "1e15", "-1", "0", "0.5", "1e9"),
    *("99999999999999999999", "9" * 400, "-2147483649", "true", '"word"', "[]", "[[1]]", "{}", ""),
)
VALUES = (np.nan, np.inf, -np.inf, 1e308, -1e308, 1e-300, 1e15, -1.0, 0.0, 9.97e36, 1e9)
WORDS = (
    *("", "x", "null", "\u00e9" * 300, " " * 4000, "9" * 5000),
    *("\x1b[31m", "a,b", "../../x", "\t"),
)
IN_JSON = (None, 0, -1, 10**9, 10**30, 1.5, "", "x", [], {}, [1], True, "NaN", "9" * 400)
LONG = ("#" + "x" * 10**5, " " * 10**5, "# " + "a = " * 30000, "(" * 5000, "\t" * 4000)


def one_of(rng, things):
    return things[rng.integers(len(things))]


def damaged(rng, path):
    """Damage a file or a folder."""
    chance = rng.random()
    if chance < 0.06:
        return as_no_file(rng, path)
    if path.is_dir():
        return zarr_changed(rng, path)
    if chance < 0.3 or path.suffix == ".gz":
        return bytes_changed(rng, path)
    return (netcdf_changed if path.suffix == ".nc" else text_changed)(rng, path)


def as_no_file(rng, path):
    """Put something else in its place, or nothing."""
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink()
    kind = one_of(rng, ["fifo", "/dev/zero", "/dev/null", "/dev/tty", "folder", "gone", "nowhere"])
    if kind == "fifo":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind != "gone":
        path.symlink_to(one_of(rng, [kind, path.name]))  # a device or nothing, or a loop
    return kind


def bytes_changed(rng, path):
    """Cut, flip, zero, insert or repeat bytes."""
    raw = bytearray(path.read_bytes())
    kind = one_of(rng, ["cut", "flip one", "flip many", "zeros", "insert", "repeat", "empty"])
    at = min(int(rng.integers(len(raw) + 1 if rng.random() < 0.6 else 200)), len(raw))
    if kind == "cut":
        del raw[at:]
    elif kind.startswith("flip"):
        for _ in range(1 if kind == "flip one" else 30):
            raw[rng.integers(len(raw))] ^= 1 << int(rng.integers(8))
    elif kind == "zeros":
        raw[at : at + 200] = bytes(len(raw[at : at + 200]))
    elif kind == "insert":
        raw[at:at] = rng.bytes(int(rng.integers(1, 50)))
    elif kind == "repeat":
        raw[at:at] = raw[at : at + 3000]
    else:
        raw.clear()
    path.write_bytes(raw)
    return f"{kind} at {at}"


def text_changed(rng, path):
    """Change numbers, words, lines or the encoding of a text."""
    text = path.read_text("utf-8", "replace")
    kind = one_of(rng, ["number", "number", "number", "word", "line", "long", "encoding"])
    if kind == "encoding":
        name = one_of(rng, ["utf-16", "utf-32", "utf-8-sig", "cp037"])
        path.write_bytes(text.encode(name, "replace"))
        return f"encoding {name}"
    lines = text.splitlines(True)
    k, j = rng.integers(len(lines), size=2)
    if kind == "line":
        how = one_of(rng, ["gone", "twice", "exchanged"])
        lines[k] = {"gone": "", "twice": lines[j] + lines[k], "exchanged": lines[j]}[how]
        path.write_text("".join(lines))
        return f"line {k} {how}"
    if kind == "long":
        at = int(rng.integers(len(lines[k]) + 1))
        more = one_of(rng, LONG)
        lines[k] = lines[k][:at] + more + lines[k][at:]
        path.write_text("".join(lines), "utf-8")
        return f"long line {k}: {more[:4]}"
    form, values = {
        "number": (r"-?\d+(\.\d+)?(e[-+]?\d+)?", NUMBERS),
        "word": (r"[A-Za-z_]+", WORDS),
    }[kind]
    one, value = one_of(rng, list(re.finditer(form, text))), one_of(rng, values)
    path.write_text(text[: one.start()] + value + text[one.end() :], "utf-8")
    return f"{one[0]} at {one.start()} is {value[:20]!r}"


# --- NetCDF: each function gives the changed data -------------------------------------------------


def other_value(rng, data, name):
    """One number of a variable, or all, is another."""
    one = data[name].variable.to_base_variable()
    values = np.array(one.values)
    if values.dtype.kind != "f" and rng.random() < 0.7:
        values = values.astype(float)
    place = slice(None) if rng.random() < 0.4 else rng.integers(values.size)
    values.reshape(-1)[place] = one_of(rng, VALUES)
    return data.drop_vars(name).assign({name: (one.dims, values, one.attrs)})


def later(rng, data, name):
    """A time lies far away."""
    name = one_of(rng, [n for n in data.variables if "time" in str(n).lower()])
    one = data[name].variable.to_base_variable()
    return data.drop_vars(name).assign({name: (one.dims, one.values + 1e15, one.attrs)})


def other_type(rng, data, name):
    one = data[name].variable.to_base_variable()
    values = one.values.astype(one_of(rng, ["i1", "S1", "U3", "f4", "i8", "u1"]))
    return data.drop_vars(name).assign({name: (one.dims, values, one.attrs)})


def other_dims(rng, data, name):
    """Dimensions have other names, are turned, or are gone."""
    one = data[name]
    if rng.random() < 0.3:
        return data.drop_vars(name).assign({name: ((), one.values.ravel()[0])})
    if rng.random() < 0.3:
        return data.assign({name: one.T})
    dims = [f"{dim}_" if rng.random() < 0.5 else dim for dim in one.dims]
    return data.drop_vars(name).assign({name: (dims, one.values, one.attrs)})


def fewer(rng, data, name):
    return data.isel({one_of(rng, data[name].dims): slice(int(rng.integers(0, 3)))})


def other_units(rng, data, name):
    data[name].attrs["units"] = one_of(rng, WORDS)
    return data


def other_attribute(rng, data, name):
    """An attribute of the file is another; a team's may be that of a scenario."""
    key = one_of(rng, [*data.attrs, "team"])
    said = str(data.attrs.get(key, ""))
    others = [one_of(rng, WORDS), 3.5, np.array([1, 2]), -1, said.replace("0", "9" * 30, 1)]
    if key == "team":
        others.append(data.attrs.get("scenario", ""))
    return data.assign_attrs({key: one_of(rng, others)})


def other_equations(rng, data, name):
    made = json.loads(data.attrs["equations"])
    json_changed(rng, made)
    return data.assign_attrs(equations=json.dumps(made))


NETCDF = {
    "another value": other_value,
    "far times": later,
    "another type": other_type,
    "other dimensions": other_dims,
    "fewer": fewer,
    "other units": other_units,
    "another attribute": other_attribute,
    "other equations": other_equations,
    "gone": lambda rng, data, name: data.drop_vars(name),
    "renamed": lambda rng, data, name: data.rename({name: f"{name}_"}),
    "no attributes": lambda rng, data, name: data.drop_attrs(deep=False),
}


def netcdf_changed(rng, path):
    """Change shapes, types, numbers, names or attributes of a NetCDF file."""
    with xarray.open_dataset(path, decode_cf=False, engine="netcdf4") as found:
        data = found.load()
    kind, name = one_of(rng, [*NETCDF]), one_of(rng, [*data.variables])
    said = f"{name}: {kind}"
    try:
        with np.errstate(all="ignore"):
            data = NETCDF[kind](rng, data, name)
        filled = [n for n in data.variables if "_FillValue" not in data[n].attrs]
        path.unlink()
        data.to_netcdf(path, engine="netcdf4", encoding={n: {"_FillValue": None} for n in filled})
    except Exception:  # what cannot be made, or NetCDF cannot hold
        path.unlink(missing_ok=True)
        xarray.Dataset({"a": ("n", np.zeros(3))}).to_netcdf(path)
        said = "other variables"
    return said


# --- Zarr and JSON --------------------------------------------------------------------------------


def zarr_changed(rng, path):
    """Change one file of a folder, or what its JSON says, or put an array of another beside."""
    files = sorted(file for file in path.rglob("*") if file.is_file())
    kind = one_of(rng, ["no file", "bytes", "json", "json", "json", "foreign", "moved", "gone"])
    one = one_of(rng, [f for f in files if f.name == "zarr.json"] if kind == "json" else files)
    said = kind
    if kind == "no file":
        said = as_no_file(rng, one)
    elif kind == "bytes":
        said = bytes_changed(rng, one)
    elif kind == "json":
        made = json.loads(one.read_text())
        said = json_changed(rng, made)
        one.write_text(json.dumps(made))
    elif kind == "foreign":
        import zarr

        shape = one_of(rng, [(3,), (4, 7), (), (0,), (2, 2, 2, 2)])
        dims = [f"d{k}" if rng.random() < 0.5 else "member" for k in range(len(shape))]
        group = zarr.open_group(path, mode="r+")
        group.create_array("foreign", shape=shape, dtype="f8", dimension_names=dims)
        return f"foreign {shape} {dims}"
    elif kind == "moved" and one.parent != path:
        shutil.rmtree(one.parent)
    else:
        one.unlink()
    return f"{one.relative_to(path)}: {said}"


def json_changed(rng, made):
    """Change one place of what JSON says, or of a JSON in it."""
    inner, key = made, None
    while True:
        key = one_of(rng, list(inner) if isinstance(inner, dict) else range(len(inner)))
        if not (isinstance(inner[key], dict | list) and inner[key]) or rng.random() < 0.2:
            break
        inner = inner[key]
    if isinstance(inner[key], str) and inner[key].startswith("{"):
        inside = json.loads(inner[key])
        said = json_changed(rng, inside)
        inner[key] = json.dumps(inside)
        return f"{key}: {said}"
    if rng.random() < 0.2:
        del inner[key]
        return f"{key} is gone"
    value = one_of(rng, IN_JSON)
    if type(inner[key]) is int and rng.random() < 0.6:  # a place beside its own
        value = inner[key] + one_of(rng, [-1, 1, 3])
    inner[key] = value
    return f"{key} is {str(value)[-30:]}"
