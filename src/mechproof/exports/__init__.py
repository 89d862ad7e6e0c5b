"""Exports for other programs: wheels for CAD, tables, animations and teeth.

- `export`: pitch curves in mm as DXF, SVG or CSV, the motion as CSV, GIF or HTML;
- `cut_teeth`: the law of the pair that makes the motion uneven, passed to `ncgears`.
"""

from mechproof.exports.curves import cut_teeth
from mechproof.exports.export import export

__all__ = ["cut_teeth", "export"]
