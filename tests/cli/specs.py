"""A spec of few samples, for the tests of commands."""

SPEC = """
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]
[spin]
rate = "60 rpm"
about = 2
tilt = "1 deg"
[time]
samples = 20
"""
