from ._rocq import write_proof as write_proof
from ._smt import check_by_z3 as check_by_z3
from .rational import RationalCertificate as RationalCertificate
from .rational import find_certificate as find_certificate
