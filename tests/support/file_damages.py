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
    *(
        "nan",
        "inf",
        "-inf",
        "1e308",
        "-1e308",
        "1e-300",
        "1e15",
        "-1",
        "0",
        "0.5",
        "1e9",
    ),
    *(
        "99999999999999999999",
        "9" * 400,
        "-2147483649",
        "true",
        '"word"',
        "[]",
        "[[1]]",
        "{}",
        "",
    ),
)
VALUES = (np.nan, np.inf, -np.inf, 1e308, -1e308, 1e-300, 1e15, -1.0, 0.0, 9.97e36, 1e9)
WORDS = (
    *("", "x", "null", "\u00e9" * 300, " " * 4000, "9" * 5000),
    *("\x1b[31m", "a,b", "../../x", "\t"),
)
IN_JSON = (
    None,
    0,
    -1,
    10**9,
    10**30,
    1.5,
    "",
    "x",
    [],
    {},
    [1],
    True,
    "NaN",
    "9" * 400,
)
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
    kind = one_of(
        rng, ["fifo", "/dev/zero", "/dev/null", "/dev/tty", "folder", "gone", "nowhere"]
    )
    if kind == "fifo":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind != "gone":
        # a device or nothing, or a loop
        path.symlink_to(one_of(rng, [kind, path.name]))
    return kind


def flipped(rng, raw, count):
    raw = bytearray(raw)
    for _ in range(count):
        raw[rng.integers(len(raw))] ^= 1 << int(rng.integers(8))
    return raw


BYTES = {  # of a draw, what is before a place and what is behind it
    "cut": lambda rng, before, behind: before,
    "one bit": lambda rng, before, behind: flipped(rng, before + behind, 1),
    "many bits": lambda rng, before, behind: flipped(rng, before + behind, 30),
    "zeros": lambda rng, before, behind: (
        before + bytes(len(behind[:200])) + behind[200:]
    ),
    "more": lambda rng, before, behind: (
        before + rng.bytes(int(rng.integers(1, 50))) + behind
    ),
    "repeat": lambda rng, before, behind: before + behind[:3000] + behind,
    "empty": lambda rng, before, behind: b"",
}


def bytes_changed(rng, path):
    """Cut, flip, zero, insert or repeat bytes."""
    raw, kind = path.read_bytes(), one_of(rng, [*BYTES])
    at = min(int(rng.integers(len(raw) + 1 if rng.random() < 0.6 else 200)), len(raw))
    path.write_bytes(BYTES[kind](rng, raw[:at], raw[at:]))
    return f"{kind} at {at}"


FORMS = {
    "number": (r"-?\d+(\.\d+)?(e[-+]?\d+)?", NUMBERS),
    "word": (r"[A-Za-z_]+", WORDS),
}


def text_changed(rng, path):
    """Change numbers, words, lines or the encoding of a text."""
    text, encoding = path.read_text("utf-8", "replace"), "utf-8"
    kind = said = one_of(
        rng, ["number", "number", "number", "word", "line", "long", "encoding"]
    )
    lines = text.splitlines(True)
    k, j = rng.integers(len(lines), size=2)
    if kind in FORMS:
        form, values = FORMS[kind]
        one, value = one_of(rng, list(re.finditer(form, text))), one_of(rng, values)
        lines = [text[: one.start()], value, text[one.end() :]]
        said = f"{one[0]} at {one.start()} is {value[:20]!r}"
    elif kind == "line":
        # gone, twice, exchanged
        lines[k] = one_of(rng, ["", lines[j] + lines[k], lines[j]])
    elif kind == "long":
        at = int(rng.integers(len(lines[k]) + 1))
        lines[k] = lines[k][:at] + one_of(rng, LONG) + lines[k][at:]
    else:
        encoding = one_of(rng, ["utf-16", "utf-32", "utf-8-sig", "cp037"])
    path.write_bytes("".join(lines).encode(encoding, "replace"))
    return f"{said}, line {k}, {encoding}"


# --- NetCDF: each function gives the changed data -------------------------------------------------


def with_values(data, name, values, dims=None):
    one = data[name].variable.to_base_variable()
    return data.drop_vars(name).assign({name: (dims or one.dims, values, one.attrs)})


def other_value(rng, data, name):
    """One number of a variable, or all, is another or lies far away."""
    values = np.array(data[name].variable.to_base_variable().values)
    if values.dtype.kind != "f" and rng.random() < 0.7:
        values = values.astype(float)
    place, flat = (
        slice(None) if rng.random() < 0.4 else rng.integers(values.size),
        values.ravel(),
    )
    flat[place] = flat[place] + 1e15 if rng.random() < 0.2 else one_of(rng, VALUES)
    return with_values(data, name, flat.reshape(values.shape))


def other_type(rng, data, name):
    values = data[name].variable.to_base_variable().values
    return with_values(
        data, name, values.astype(one_of(rng, ["i1", "S1", "U3", "f4", "i8", "u1"]))
    )


def other_dims(rng, data, name):
    """Dimensions have other names, are turned, or are gone."""
    one, chance = data[name], rng.random()
    if chance < 0.3:
        return data.drop_vars(name).assign({name: ((), one.values.ravel()[0])})
    if chance < 0.5:
        return data.assign({name: one.T})
    dims = [f"{dim}_" if rng.random() < 0.5 else dim for dim in one.dims]
    return with_values(data, name, one.values, dims)


def other_attribute(rng, data, name):
    """An attribute of the file or of a variable is another; a team's may be a scenario's."""
    attrs = data.attrs if rng.random() < 0.7 else data[name].attrs
    key = one_of(rng, [*attrs, "team", "units"])
    said = str(attrs.get(key, ""))
    others = [
        one_of(rng, WORDS),
        3.5,
        np.array([1, 2]),
        -1,
        said.replace("0", "9" * 30, 1),
    ]
    attrs[key] = one_of(rng, [*others, data.attrs.get("scenario", "")])
    if said.startswith("{") and rng.random() < 0.6:
        json_changed(rng, made := json.loads(said))
        attrs[key] = json.dumps(made)
    return data


NETCDF = {
    "another value": other_value,
    "another type": other_type,
    "other dimensions": other_dims,
    "fewer": lambda rng, data, name: data.isel(
        {one_of(rng, data[name].dims): slice(int(rng.integers(0, 3)))}
    ),
    "another attribute": other_attribute,
    "gone": lambda rng, data, name: data.drop_vars(name),
    "renamed": lambda rng, data, name: data.rename({name: f"{name}_"}),
    "no attributes": lambda rng, data, name: data.drop_attrs(deep=False),
}


def netcdf_changed(rng, path):
    """Change shapes, types, numbers, names or attributes of a NetCDF file."""
    with xarray.open_dataset(path, decode_cf=False, engine="netcdf4") as found:
        data = found.load()
    name = one_of(rng, [*data.variables])
    kind = one_of(rng, [*NETCDF, "another value", "another attribute"])
    path.unlink()
    try:
        with np.errstate(all="ignore"):
            data = NETCDF[kind](rng, data, name)
        filled = [n for n in data.variables if "_FillValue" not in data[n].attrs]
        data.to_netcdf(
            path, engine="netcdf4", encoding={n: {"_FillValue": None} for n in filled}
        )
    except Exception:  # what cannot be made, or NetCDF cannot hold
        path.unlink(missing_ok=True)
        xarray.Dataset({"a": ("n", np.zeros(3))}).to_netcdf(path)
        kind = "other variables"
    return f"{name}: {kind}"


# --- Zarr and JSON --------------------------------------------------------------------------------


def foreign(rng, path):
    """Put an array of another beside those of a folder."""
    import zarr

    shape = one_of(rng, [(3,), (4, 7), (), (0,), (2, 2, 2, 2)])
    dims = [f"d{k}" if rng.random() < 0.5 else "member" for k in range(len(shape))]
    group = zarr.open_group(path, mode="r+")
    group.create_array("foreign", shape=shape, dtype="f8", dimension_names=dims)
    return f"foreign {shape} {dims}"


def zarr_changed(rng, path):
    """Change one file of a folder, or what its JSON says, or put an array of another beside."""
    files = sorted(file for file in path.rglob("*") if file.is_file())
    kind = one_of(
        rng, ["no file", "bytes", "json", "json", "json", "foreign", "moved", "gone"]
    )
    one = one_of(
        rng, [f for f in files if f.name == "zarr.json"] if kind == "json" else files
    )
    said = kind
    if kind == "foreign":
        return foreign(rng, path)
    if kind == "no file":
        said = as_no_file(rng, one)
    elif kind == "bytes":
        said = bytes_changed(rng, one)
    elif kind == "json":
        said = json_changed(rng, made := json.loads(one.read_text()))
        one.write_text(json.dumps(made))
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
        if (
            not (isinstance(inner[key], dict | list) and inner[key])
            or rng.random() < 0.2
        ):
            break
        inner = inner[key]
    if isinstance(inner[key], str) and inner[key].startswith("{"):
        said = json_changed(rng, inside := json.loads(inner[key]))
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
