"""The kind ``damped-body``: a body that loses energy inside, and how its spin becomes flat."""
