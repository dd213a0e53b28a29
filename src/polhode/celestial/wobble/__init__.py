"""``polhode wobble``: the Earth's pole, the Chandler wobble's period and quality, and what excites it."""
