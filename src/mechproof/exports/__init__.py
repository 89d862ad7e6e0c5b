"""What leaves the package for other programs: wheels for CAD, tables, pictures that move, teeth.

- `export`: pitch curves in mm as DXF, SVG or CSV, the motion as CSV, GIF or HTML;
- `cut_teeth`: the law of the pair that makes the motion uneven, handed to `ncgears`.
"""

from mechproof.exports.curves import cut_teeth
from mechproof.exports.export import export

__all__ = ["cut_teeth", "export"]
