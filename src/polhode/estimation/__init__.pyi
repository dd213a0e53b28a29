from ._estimate import Estimate as Estimate
