"""What paper 1 states, and what of ours stands beside it."""

from .design import DESIGN_ROWS
from .peaks import PEAK_ROWS
from .position import POSITION_CLAIMS, POSITION_ROWS, RATIO_ROWS
from .readings import CONSEQUENCES, TABLE_CLAIMS, TYPE_A_ROWS

ROWS = (
    *RATIO_ROWS,
    *POSITION_ROWS,
    *POSITION_CLAIMS,
    *TYPE_A_ROWS,
    *TABLE_CLAIMS,
    *CONSEQUENCES,
    *PEAK_ROWS,
    *DESIGN_ROWS,
)
