"""Motions made of rows of cases: their numbers one after the other, as tables of cases hold them."""

import polhode as ph


def free_motion(moments, momentum, attitude=None, epoch=0.0):
    return ph.FreeMotion(moments, momentum=momentum, attitude=attitude, epoch=epoch)


def lagrange_motion(moments, mgl, momentum, attitude=None, epoch=0.0):
    return ph.LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=attitude, epoch=epoch)
