"""Every option of every command at the ends of its range; options come from the commands, so new ones are drawn too.

What a command is given beside is the least that it does something with. Tables of numbers that commands read are
brought to the ends a column at a time.
"""

import json
import re
import shutil

import numpy as np

import polhode as ph
from registered import every_command
from spec.ends import NUMBERS, TEXTS, WHOLES
from spec.mutations import EXAMPLES

COMMANDS = every_command()
FREE = """
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]
[spin]
rate = "60 rpm"
about = 2
tilt = "1 deg"
[time]
samples = 12
"""
SWEEP = FREE + """
[sweep]
samples = 4
inputs = { "spin.tilt" = { uniform = ["1 deg", "2 deg"] } }
outputs = ["regime"]
"""
COLUMNS = ["--time", "t_s", "--gyro", "gx,gy,gz", "--unit", "rad/s"]
GIVEN = {
    "report": [["free.toml"]],
    "new": [["top"]],
    "view": [["free.toml", "--no-open"]],
    "body": [["free.toml"]],
    "certify": [["free.toml", "--at", "2 s"]],
    "levels": [["water.xyz", "--j-max", "2"]],
    "lines": [["water.xyz", "--j-max", "2", "--dipole", "0,1.8,0"]],
    "fit": [["log.csv", *COLUMNS, "--window", "0,0.89", "--no-drag", "--no-gain"]],
    "export": [["free.toml", "--to", "csv"]],
    "import": [["log.csv", *COLUMNS]],
    "compare": [["free.toml", "free.toml"]],
    "judge": [["states.json"]],
    "sweep": [["sweep.toml", "--dry-run"]],
    "tumble": [["apophis"], ["apophis", "--diameter", "340 m"]],
    "derive": [["clebsch"]],
    "learn": [["two-surfaces", "--key", "--out", "sheet.html"]],
    "wobble": [["--from", "1995-01-01", "--to", "2012-01-01"]],
}
EXAMPLE = re.compile(r"(?:[Ll]ike|default:) \"?([^\";)]*?\d[^\";)]*)\"?")
NUMBER = re.compile(r"(?<![\w.:-])[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?(?![\d-])")


def log_of(scale=(1.0, 1.0)):
    """Return a short log of a free body, its times and rates each multiplied."""
    times = np.arange(0.0, 0.9, 0.01)
    rates = ph.FreeMotion((0.4, 0.7, 1.0), angular_velocity=(2.0, 9.0, 3.0)).angular_velocity(times)
    rates = rates + 1e-3 * np.random.default_rng(1).normal(size=rates.shape)
    rows = np.column_stack([times * scale[0], rates * scale[1]])
    return "t_s,gx,gy,gz\n" + "\n".join(",".join(f"{x:.12g}" for x in row) for row in rows) + "\n"


def states_of():
    """Return the exact states of a free body, as an engine writes them."""
    motion = ph.FreeMotion((1.0, 2.0, 3.0), angular_velocity=(2.0, 9.0, 3.0))
    times = np.arange(0.0, 0.9, 0.1)
    run = {"inertia": [1.0, 2.0, 3.0], "attitude": [1.0, 0.0, 0.0, 0.0], "angular_velocity": [2.0, 9.0, 3.0],
           "times": times.tolist(), "attitudes": motion.attitude(times).tolist(),
           "momenta": motion.momentum(times).tolist()}  # fmt: skip
    return json.dumps({"format": "polhode engine states", "version": 1, "runs": [run]})


def write_given(folder):
    """Write the files that commands are given."""
    (folder / "free.toml").write_text(FREE)
    (folder / "sweep.toml").write_text(SWEEP)
    (folder / "log.csv").write_text(log_of())
    (folder / "states.json").write_text(states_of())
    shutil.copy(EXAMPLES / "water.xyz", folder)


def options_of(command):
    """Return the options of a command that take a value."""
    parameters = COMMANDS[command].params
    return [one for one in parameters if one.param_type_name == "option" and not one.is_flag and not one.count]


def values_of(option):
    """Return an option's values at the ends of its range, each as words of the command line.

    Its help gives an example of texts that hold numbers, which are replaced one by one.
    """
    many = max(option.nargs, 1)
    example = EXAMPLE.search(option.help or "")
    text = example[1].rstrip(". ") if example else "0"
    places = [found.span() for found in NUMBER.finditer(text)] or [(0, len(text))]
    found = [[text] * many for text in TEXTS]
    for end in [*NUMBERS, *map(str, WHOLES)]:
        texts = [text[:start] + end + text[stop:] for start, stop in places]
        found += [[one, *["1"] * (many - 1)] for one in texts]
        if many > 1:
            found += [[one] * many for one in texts]
    return found


def with_option(given, option, value):
    """Return arguments with an option in place of what they say of it."""
    kept = list(given)
    for name in option.opts:
        while name in kept:
            at = kept.index(name)
            del kept[at : at + 1 + max(option.nargs, 1)]
    return [*kept, option.opts[0], *value]


def all_arguments():
    """Return the arguments of every command with every option at every end."""
    return [
        [command, *with_option(given, option, value)]
        for command, bases in GIVEN.items()
        for given in bases
        for option in options_of(command)
        for value in values_of(option)
    ]
