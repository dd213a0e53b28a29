"""Sweeps: many motions of one spec, with some of its numbers varied.

It answers how the answers of a report spread when numbers of its spec do, and which of these explain the spread; what
is computed stays in a store, from which an interrupted sweep goes on. Sources: Saltelli et al. (2010) and Jansen (1999)
on sensitivities, Chan, Golub and LeVeque (1983) on running sums. From the core it takes only principal axes
(``bodies``) and trajectories (``motion``), from the application specs, kinds and reports.
"""
