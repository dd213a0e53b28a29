from .rational import RationalCertificate as RationalCertificate
from .rational import find_certificate as find_certificate
