"""Letters of paper 3, and the symbols that its proofs need besides.

Conventions: lengths in mm, angles in rad. The tooth's axis points from the wheel's centre to the
tip. Heights grow from the tip towards the centre, deviations of thickness are positive for a
thicker tooth. Letters that the paper uses twice are kept apart: `Delta h_c` and `Delta S_c` are the
gauge's errors of the flow chart; `K` is T/sigma and `K_m` the influence of the height.
"""

from pathlib import Path

from sympy import Interval, Symbol, oo, symbols

from mechproof.document.transcription import Transcription

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
m, z, s_c, sigma, K, K_m, E_cs, T_c = PRINT.symbols("m z s_c sigma K K_m E_cs T_c")
dh, dh_gauge, ds_gauge, ds_height = PRINT.symbols("Delta_h Delta_hc Delta_Sc Delta_Sca")
e_tip, E_true, E_measured, f_true, f_measured = PRINT.symbols("e_dau E_csu E_cs0 f_u f_0")
alpha, psi, place, width, degree = symbols("alpha psi p w degree", positive=True)
incline, gauge_um, millimetre = symbols("tan_alpha sigma_gauge mm", positive=True)
sigma_tip, sigma_height, sigma_thickness = symbols("sigma_d sigma_h sigma_S", positive=True)
tip_tolerance, interval = symbols("IT_d U", positive=True)
clearance = Symbol("j_n", nonnegative=True)
delta, tilt, turn, thinning = symbols("delta tilt turn Delta_s", real=True)
r_b, t_c, y_c, above, below = symbols("r_b t_c y_c q_1 q_2", real=True)
mate, centre_change, micrometre = symbols("E_mate Delta_a um", real=True)
rightly_accepted, wrongly_accepted, rightly_rejected, wrongly_rejected = symbols(
    "rightly_accepted wrongly_accepted rightly_rejected wrongly_rejected", real=True
)
POSITIVE = Interval.open(0, oo)
