"""Inverse functions, sums of angles and logarithms, roots: true ones are proved, twins are not."""

from __future__ import annotations

import pytest
from twins import check_twins, list_rows

from mechproof.proof.inverses import INVERSE, LOGARITHMS, ROOT, TURNS

TABLES = {
    INVERSE: (
        (
            r"\sqrt3\arctan x+\sqrt3\arctan y=\sqrt3\arctan\frac{x+y}{1-xy}+\sqrt3\pi",
            r"\sqrt3\arctan x+\sqrt3\arctan y=\sqrt3\arctan\frac{x+y}{1-xy}+\sqrt2\pi",
            "x>1, y>1",
        ),
        (r"\arcsin(\sin x)=\pi-x", r"\arcsin(\sin x)=x", r"\frac\pi2<x<\frac{3\pi}2"),
        (r"\arccos(\cos x)=2\pi-x", r"\arccos(\cos x)=x", r"\pi\le x\le2\pi"),
        (
            r"\arcsin(3x-4x^3)=3\arcsin x",
            r"\arcsin(3x-4x^3)=3\arccos x",
            r"-\frac12\le x\le\frac12",
        ),
        (
            r"\arctan x+\arctan y=\arctan\frac{x+y}{1-xy}+\pi",
            r"\arctan x+\arctan y=\arctan\frac{x+y}{1-xy}",
            "x>1, y>1",
        ),
        (
            r"2\arctan\left(\sqrt{\frac{1+k}{1-k}}\tan\frac E2\right)"
            r"=\arccos\frac{\cos E-k}{1-k\cos E}",
            r"2\arctan\left(\sqrt{\frac{1-k}{1+k}}\tan\frac E2\right)"
            r"=\arccos\frac{\cos E-k}{1-k\cos E}",
            r"0\le k<1, 0\le E<\pi",
        ),
        (
            r"2\arctan\left(\sqrt{\frac{1+k}{1-k}}\tan\frac E2\right)"
            r"=\operatorname{atan2}(\sqrt{1-k^2}\sin E,\cos E-k)",
            r"2\arctan\left(\sqrt{\frac{1+k}{1-k}}\tan\frac E2\right)"
            r"=\operatorname{atan2}(\sqrt{1-k^2}\sin E,\cos E+k)",
            r"0<k<1, -\pi<E<\pi",
        ),
        (
            r"2\arctan\left(\sqrt{\frac{1+k}{1-k}}\tan\frac E2\right)"
            r"=\arctan\frac{\sqrt{1-k^2}\sin E}{\cos E-k}",
            r"2\arctan\left(\sqrt{\frac{1+k}{1-k}}\tan\frac E2\right)"
            r"=\arctan\frac{(1-k)\sin E}{\cos E-k}",
            r"0<k<1, -\pi<E<\pi, \cos E>k",
        ),
        (
            r"\arctan\frac{\sin x}{\cos x}=x",
            r"\arctan\frac{\sin x}{\cos x}=x-\pi",
            r"\cos x>0, -\pi<x<\pi",
        ),
        (
            r"\operatorname{atan2}(1,x)=\frac\pi2-\arctan x",
            r"\operatorname{atan2}(1,x)=\arctan\frac1x",
            "",
        ),
        (
            r"\operatorname{atan2}(\sin x,\cos x)=x",
            r"\operatorname{atan2}(\sin x,\cos x)=x+2\pi",
            r"-\pi<x\le\pi",
        ),
        (
            r"\operatorname{atan2}(y,x)=\arccos\frac x{\sqrt{x^2+y^2}}",
            r"\operatorname{atan2}(y,x)=\arcsin\frac y{\sqrt{x^2+y^2}}",
            "y>0",
        ),
        (
            r"\operatorname{atan2}(-y,-x)=\operatorname{atan2}(y,x)-\pi",
            r"\operatorname{atan2}(-y,-x)=\operatorname{atan2}(y,x)+\pi",
            "y>0",
        ),
        (
            r"\operatorname{atan2}(y,x)+\operatorname{atan2}(x,y)=\frac\pi2",
            r"\operatorname{atan2}(y,x)-\operatorname{atan2}(x,y)=\frac\pi2",
            "x>0, y>0",
        ),
        (
            r"\operatorname{atan2}(y,x)=2\arctan\frac{\sqrt{x^2+y^2}-x}y",
            r"\operatorname{atan2}(y,x)=2\arctan\frac{\sqrt{x^2+y^2}+x}y",
            "y>0",
        ),
        (
            r"\arctan x+\arctan y=\pi+\arctan\frac{x+y}{1-xy}",
            r"\arctan x+\arctan y=\arctan\frac{x+y}{1-xy}",
            "x>0, xy>1",
        ),
    ),
    TURNS: (
        (
            r"2\arctan\frac{A+\sqrt{A^2+B^2-C^2}}{B+C}"
            r"=\arctan\frac AB+\arccos\frac C{\sqrt{A^2+B^2}}",
            r"2\arctan\frac{A+\sqrt{A^2+B^2-C^2}}{B+C}"
            r"=\arctan\frac AB-\arccos\frac C{\sqrt{A^2+B^2}}",
            "A>0, B>0, C>0, A^2+B^2>C^2",
        ),
    ),
    LOGARITHMS: (
        (
            r"\operatorname{arsinh}x=-\ln(\sqrt{1+x^2}-x)",
            r"\operatorname{arsinh}x=\ln(\sqrt{1+x^2}-x)",
            "",
        ),
        (
            r"\ln(x+\sqrt{x^2-1})=-\ln(x-\sqrt{x^2-1})",
            r"\ln(x+\sqrt{x^2-1})=\ln(x-\sqrt{x^2-1})",
            "x>1",
        ),
        (
            r"\ln(2+\sqrt2)-\ln(2-\sqrt2)=2\sqrt2\,\frac{\ln(1+\sqrt2)}{\sqrt2}",
            r"\sqrt2\ln(2+\sqrt2)-\ln(2-\sqrt2)=2\ln(1+\sqrt2)",
            "",
        ),
        (
            r"2\operatorname{arsinh}x=\operatorname{arcosh}(1+2x^2)",
            r"2\operatorname{arsinh}x=\operatorname{arcosh}(1+x^2)",
            "x>0",
        ),
        (r"\ln\frac1x=-\ln x", r"\ln\frac1{x^2}=-\ln x", ""),
    ),
    ROOT: (
        (
            r"\sqrt{\frac{r^2}{\cos^2a}-r^2}+\sqrt{\frac{s^2}{\cos^2b}-s^2}=r\tan a+s\tan b",
            r"\sqrt{\frac{r^2}{\cos^2a}-r^2}+\sqrt{\frac{s^2}{\cos^2b}-s^2}=r\tan a-s\tan b",
            r"r>0, s>0, 0<a<\frac\pi2, 0<b<\frac\pi2",
        ),
        (
            r"\sqrt{a+b+2\sqrt{ab}}=\sqrt a+\sqrt b",
            r"\sqrt{a+b+2\sqrt{ab}}=\sqrt a-\sqrt b",
            "a>0, b>0",
        ),
        (
            r"\cos\frac x2=-\sqrt{\frac{1+\cos x}2}",
            r"\cos\frac x2=\sqrt{\frac{1+\cos x}2}",
            r"\pi<x<3\pi",
        ),
        (r"\sqrt{\sin^2x}=\sin x", r"\sqrt{\sin^2x}=-\sin x", r"0\le x\le\pi"),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize(("rung", "printed", "twin", "where"), list_rows(TABLES))
def test_a_range_is_kept_and_its_neighbour_not_accepted(
    rung: str, printed: str, twin: str, where: str
) -> None:
    check_twins(rung, printed, twin, where)
