"""Mistakes of users that type checkers find: one in each line that says so, and none in the others."""

import polhode as ph

m = (1.0, 2.0, 3.0)
v = (0.3, 1.8, 1.5)
motion = ph.FreeMotion(m, momentum=v)
trajectory = motion.sample()

ph.FreeMotion(m, momentum=v, attitud=(1.0, 0.0, 0.0, 0.0))  # wrong: the keyword
ph.FreeMotion(m, v)  # wrong: momentum and angular velocity are named
ph.LagrangeMotion(m, momentum=v)  # wrong: a top needs mgl
print(ph.report("examples/t_handle.toml").trajectory.times)  # wrong: a report may be without a motion
print(trajectory.tims)  # wrong: the name
print(trajectory.momentum.shape)  # wrong: a trajectory may be without a momentum
print(trajectory.times.shap)  # wrong: the name
print(motion.stat(1.0))  # wrong: the name
trajectory.save()  # wrong: where to
motion.show(heigth=300)  # wrong: the keyword
ph.simulate(ph.systems.FreeRigidBody(m), v, [0.0, 1.0], stepsize=0.1)  # wrong: the keyword
