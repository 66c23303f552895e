"""The pictures of a diagram: true to its wiring, legible, the same every time."""

import re
from itertools import combinations, pairwise
from xml.etree import ElementTree

import control
import matplotlib
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.plots.drawing import draw, mermaid
from clpt_control.plots.drawing.figure import equation_numbers, layout, lines_of

PAPER = clpt.paper_scenario()


def first_order(name, inputs, outputs):
    n, inputs, outputs = len(outputs.split()), inputs.split(), outputs.split()
    matrices = -np.eye(n), np.ones((n, len(inputs))), np.eye(n), 0
    return control.ss(*matrices, name=name, inputs=inputs, outputs=outputs)


def nested():
    inside = [first_order("plant", "u", "y"), first_order("actuator", "v", "u")]
    inner = control.interconnect(inside, inputs="v", outputs="y", name="inner")
    around = [first_order("controller", "r m", "v"), first_order("sensor", "y", "m")]
    return control.interconnect([inner, *around], inputs="r", outputs="y", name="outer")


def negative():
    """The textbook loop u = r - y, with a block that feeds itself."""
    wires = [["P.u", "C.u"], ["C.e", "-P.y"], ["P.u", ("P", "y", 0.5)]]
    ends = {"inplist": ["C.e"], "outlist": ["P.y"], "inputs": ["r"], "outputs": ["y"]}
    return control.interconnect(
        [first_order("P", "u", "y"), first_order("C", "e", "u")], wires, **ends
    )


def random_diagram(seed):
    random, systems = np.random.default_rng(seed), []
    for k in range(int(random.integers(3, 11))):
        m, r = random.integers(1, 4), random.integers(1, 3)
        ports = (
            " ".join(f"{of}{j}" for j in range(n)) for of, n in (("u", m), ("y", r))
        )
        systems.append(first_order(f"s{k}", *ports))
    connections = []
    for system in systems:
        for label in system.input_labels:
            other = systems[random.integers(len(systems))]
            source = other.output_labels[random.integers(other.noutputs)]
            connections.append([f"{system.name}.{label}", f"{other.name}.{source}"])
    ends = {"inplist": ["s0.u0", "s2.u0"], "inputs": ["r", "d"], "outlist": ["s1.y0"]}
    return control.interconnect(
        systems, connections, outputs=["out"], check_unused=False, **ends
    )


DIAGRAMS = {
    "closed loop": lambda: clpt.closed_loop(PAPER),
    "zc from outside": lambda: clpt.closed_loop(PAPER, ("zc",)),
    "x from outside": lambda: clpt.closed_loop(PAPER, ("x",)),
    "error loop": lambda: clpt.closed_loop(PAPER, errors=True),
    "nested": nested,
    "negative": negative,
    **{f"random {seed}": (lambda seed=seed: random_diagram(seed)) for seed in range(8)},
}


@pytest.fixture(params=DIAGRAMS, scope="module")
def drawn(request):
    diagram = DIAGRAMS[request.param]()
    return diagram, *layout(diagram)


def flat_names(system, before=""):
    for part in system.syslist:
        if isinstance(part, control.InterconnectedSystem):
            yield from flat_names(part, f"{before}{part.name}.")
        else:
            yield before + part.name


def mermaid_arrows(text):
    nodes = dict(re.findall(r'^    (\w+)\(?\["(.*?)(?:<br/>.*)?"\]\)?$', text, re.M))
    arrows = {}
    for a, label, b in re.findall(r'^    (\w+) -->\|"(.*)"\| (\w+)$', text, re.M):
        arrows.setdefault((nodes[a], nodes[b]), set()).update(label.split(", "))
    return arrows


# --- Mermaid ----------------------------------------------------------------------------


def test_mermaid_arrows_are_those_of_the_connection_map():
    loop = clpt.closed_loop(PAPER, ("zc",))
    outputs = [
        (s.name, label.split("[")[0]) for s in loop.syslist for label in s.output_labels
    ]
    inputs = [s.name for s in loop.syslist for _ in s.input_labels]
    expected = {}
    for to, source in np.argwhere(loop.connect_map):
        expected.setdefault((outputs[source][0], inputs[to]), set()).add(
            outputs[source][1]
        )
    for to in np.argwhere(loop.input_map)[:, 0]:
        expected[("zc", inputs[to])] = {"zc"}
    assert mermaid_arrows(mermaid(loop)) == expected


def test_mermaid_shows_gains_nested_diagrams_and_parts_of_a_port():
    arrows = {
        ("C", "P"): {"u"},
        ("P", "C"): {"-1 y"},
        ("P", "P"): {"0.5 y"},
        ("r", "C"): {"r"},
    }
    assert mermaid_arrows(mermaid(negative())) == arrows
    inner = mermaid(nested())
    assert '(["r"])' in inner  # an input is round
    assert mermaid_arrows(inner)["inner.plant", "sensor"] == {"y"}
    assert mermaid_arrows(inner)["controller", "inner.actuator"] == {"v"}
    blocks = [first_order("two", "u", "y[0] y[1]"), first_order("one", "u", "y")]
    links = {
        "connections": [["one.u", "two.y[1]"]],
        "inplist": ["two.u"],
        "outlist": ["one.y"],
    }
    part = control.interconnect(blocks, check_unused=False, **links)
    assert mermaid_arrows(mermaid(part))["two", "one"] == {"y[1]"}


# --- the layout -------------------------------------------------------------------------


def test_arrows_go_around_boxes_and_join_the_right_ones(drawn):
    diagram, routed, nets, nodes = drawn
    made = {name: box for name, box in routed.boxes.items() if name in nodes}
    boxes = {
        name: (box.x, box.y - box.height / 2, box.x + box.width, box.y + box.height / 2)
        for name, box in made.items()
    }
    assert set(boxes) == set(flat_names(diagram))
    for a, b in combinations(boxes.values(), 2):
        assert a[2] < b[0] or b[2] < a[0] or a[3] < b[1] or b[3] < a[1]
    pieces = []
    for (k, target), path in routed.paths.items():
        for name, side, (x, y) in ((target, 0, path[-1]), (nets[k].source, 2, path[0])):
            if name in boxes:
                _, top, _, bottom = boxes[name]
                assert x == pytest.approx(boxes[name][side])
                assert top < y < bottom
        assert not target or target in boxes
        for (x0, y0), (x1, y1) in pairwise(path):
            assert x0 == x1 or y0 == y1
            pieces.append((k, sorted(((x0, y0), (x1, y1)))))
            for left, top, right, bottom in boxes.values():
                beside = max(x0, x1) < left + 0.1 or min(x0, x1) > right - 0.1
                assert beside or max(y0, y1) <= top or min(y0, y1) >= bottom
    after = {name: set() for name in nodes}
    for net in nets:
        after.setdefault(net.source, set()).update(net.onward)
    while after:
        last = [name for name, targets in after.items() if not targets & set(after)]
        assert last, "arrows drawn as not feedback close a circle"
        after = {name: own for name, own in after.items() if name not in last}
    for (k, (a, b)), (m, (c, d)) in combinations(pieces, 2):
        for along, across in ((0, 1), (1, 0)) if k != m else ():
            # none on top of another
            if a[across] == b[across] == c[across] == d[across]:
                assert min(b[along], d[along]) <= max(a[along], c[along])


BACK = {
    "vehicle": {"basis_x", "true_flow", "vehicle_controller"},
    "learning_model": {"basis_z", "learning_controller"},
    "adaptation": {"injection", "learning_controller"},
}


def test_the_picture_of_the_paper_is_what_an_engineer_would_draw():
    _, nets, nodes = layout(clpt.closed_loop(PAPER))
    back = {source: set() for source in BACK} | {
        net.source: set() for net in nets if net.back
    }
    for net in nets:
        back.get(net.source, set()).update(net.back)
    assert back == BACK
    numbers = {name: equation_numbers(node.system) for name, node in nodes.items()}
    assert (numbers["clpe"], numbers["adaptation"]) == ("Eq. (10)", "Eqs. (21)-(23)")


# --- the file ---------------------------------------------------------------------------


def test_svg_holds_every_block_arrow_and_equation(drawn, tmp_path):
    diagram, routed, nets, nodes = drawn
    draw(diagram, tmp_path / "loop.svg")
    root = ElementTree.parse(tmp_path / "loop.svg").getroot()
    ids = {element.get("id") for element in root.iter()}
    words = {element.text for element in root.iter() if element.text}
    for name, node in nodes.items():
        assert f"block:{name}" in ids
        assert set(lines_of(name)) <= words
        numbers = equation_numbers(node.system)
        assert not numbers or any(numbers in w for w in words)
    assert sum(str(key).startswith("arrow:") for key in ids) == len(routed.paths)
    for net in nets:
        assert set(net.targets.values()) <= words


OTHERS = {
    "font.size": 30,
    "lines.linewidth": 9,
    "savefig.bbox": "tight",
    "svg.fonttype": "path",
}


@pytest.mark.parametrize("suffix", [".svg", ".png", ".pdf", ".mmd"])
def test_files_are_the_same_every_time_whatever_a_users_settings(tmp_path, suffix):
    starts = {
        ".svg": b"<?xml",
        ".png": b"\x89PNG",
        ".pdf": b"%PDF",
        ".mmd": b"flowchart LR",
    }
    for name, settings in (("a", {}), ("b", OTHERS | {"font.family": "serif"})):
        with matplotlib.rc_context(settings):
            draw(nested(), tmp_path / (name + suffix))
    first = (tmp_path / ("a" + suffix)).read_bytes()
    assert first == (tmp_path / ("b" + suffix)).read_bytes()
    assert first.startswith(starts[suffix])
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a" + suffix, "b" + suffix]


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("loop.jpg", r"\.svg, \.png, \.pdf, \.mmd, not '\.jpg'"),
        ("missing/loop.svg", "folder .* does not exist"),
    ],
)
def test_mistakes_are_one_sentence(tmp_path, name, said):
    with pytest.raises(clpt.ClptError, match=said):
        draw(nested(), tmp_path / name)
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize(
    "name", ["\u2028", " ", "\u00a0", "\u200b", "\ud800", "$x", "<b>"]
)
@pytest.mark.parametrize("suffix", [".svg", ".mmd", ".png"])
def test_a_name_of_any_characters_is_drawn(tmp_path, name, suffix):
    lag = control.ss(
        [[-1.0]],
        [[1.0]],
        [[1.0]],
        0,
        name=name,
        inputs=[name + "u"],
        outputs=[name + "y"],
    )
    draw(clpt.connect([lag], [name + "u"]), tmp_path / f"d{suffix}")
    assert (tmp_path / f"d{suffix}").stat().st_size > 50
