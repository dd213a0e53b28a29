from .algebras import check_algebra as check_algebra
from .kinds import check_kind as check_kind
from .laws import LawBroken as LawBroken
from .motions import check_motion as check_motion
from .systems import check_system as check_system
