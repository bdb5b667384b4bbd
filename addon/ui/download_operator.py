"""Download MOLA: a public grid of Mars, for whoever has none; only its files are asked for."""

from __future__ import annotations

import bpy
from proxygraph import CancelledError

from ..package import OwnFolder, own_folder
from ..terrain.byte_size import in_bytes
from ..terrain.download import DownloadError, check_address
from ..terrain.megdr import ADDRESS, PRODUCTS, Megdr, MegdrJob
from ..terrain.progress import progress
from ..terrain.work import Tell
from .job_operator import JobOperator
from .operator_status import OperatorStatus
from .preferences import preferences

OFFLINE = (
    "Blender is offline: allow online access in Preferences > System > Network, or get the files elsewhere"
)


def items_of_products() -> list[tuple[str, str, str]]:
    """The resolutions, as an enumeration has them."""
    return [
        (
            str(product.pixels_per_degree),
            f"{product.pixels_per_degree} px/deg",
            f"{product.columns:,} x {product.rows:,} samples, {in_bytes(product.image_bytes)}",
        )
        for product in PRODUCTS
    ]


class HAPTIC_TERRAIN_OT_download_mola(JobOperator, bpy.types.Operator):
    """Fetch the public topography of Mars that the laser altimeter MOLA measured, and import it"""

    bl_idname = "haptic_terrain.download_mola"
    bl_label = "Download Mars (MOLA)"
    bl_options = {"REGISTER"}  # noqa: RUF012  # the import that follows is what can be undone

    resolution: bpy.props.EnumProperty(
        name="Resolution",
        description="How fine the grid is; one pixel per degree is 59 km at the equator",
        items=items_of_products(),
    )
    address: bpy.props.StringProperty(
        name="From",
        description="The folder on the web that has the folders meg004, meg016 and meg032",
        default=ADDRESS,
        options={"SKIP_SAVE"},
    )
    answered: bpy.props.BoolProperty(
        description="A person has seen the address: download now, with progress, and let them cancel",
        default=False,
        options={"SKIP_SAVE", "HIDDEN"},
    )

    _asking = False
    """Whether the dialog is open, whose answer will be ``execute``."""

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only where the person lets Blender use the network."""
        if not bpy.app.online_access:
            cls.poll_message_set(OFFLINE)
            return False
        return True

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Show what will be fetched, and from where; then fetch it."""
        if self.answered:
            return self.begin(context, self._new_job())
        chosen = preferences(context)
        if chosen is not None and not self.properties.is_property_set("address"):
            self.address = chosen.mola_address
        self._asking = True
        context.window_manager.invoke_props_dialog(
            self, width=560, title=self.bl_label, confirm_text="Download"
        )
        return {"RUNNING_MODAL"}

    def draw(self, context: bpy.types.Context) -> None:
        """The choices, and what they mean."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(self, "resolution")
        layout.prop(self, "address")
        column = layout.box().column(align=True)
        for line in self._described():
            column.label(text=line)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Fetch: at once for scripts; for a person who was asked, beside their work."""
        if self._asking and not bpy.app.background:
            bpy.ops.haptic_terrain.download_mola(
                "INVOKE_DEFAULT", resolution=self.resolution, address=self.address, answered=True
            )
            return {"CANCELLED"}  # the other call finishes
        with progress(context) as tell:
            job = self._new_job(tell)
            job.run()
        return self.end(context, job)

    def end(self, context: bpy.types.Context, job: MegdrJob) -> OperatorStatus:
        """Import what was fetched, or tell why there is nothing."""
        try:
            job.check()
        except CancelledError:
            self.report({"INFO"}, "Download cancelled: the next one goes on from where this one was")
            return {"CANCELLED"}
        except (DownloadError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        label = job.label
        self.report({"INFO"}, f"{label.name} and its samples are in the extension's own folder")
        if bpy.app.background:
            return _imported(bpy.ops.haptic_terrain.import_grid(filepath=str(label)))
        bpy.ops.haptic_terrain.import_grid("INVOKE_DEFAULT", filepath=str(label), answered=True)
        return {"FINISHED"}

    def _product(self) -> Megdr:
        return next(product for product in PRODUCTS if str(product.pixels_per_degree) == self.resolution)

    def _new_job(self, tell: Tell | None = None) -> MegdrJob:
        return MegdrJob(self._product(), self.address, own_folder(OwnFolder.MOLA), tell)

    def _described(self) -> list[str]:
        product, folder = self._product(), own_folder(OwnFolder.MOLA)
        try:
            check_address(product.address(self.address, ".img"))
        except DownloadError as error:
            return [str(error)]
        image = product.image_in(folder)
        there = image.is_file() and product.label_in(folder).is_file()
        return [
            product.address(self.address, ".lbl"),
            product.address(self.address, ".img"),
            "Both are there already: nothing is fetched"
            if there
            else f"{in_bytes(product.image_bytes)} to fetch",
            "checked by size and checksum" if product.sha256 else "checked by size and label",
        ]


def _imported(status: set[str]) -> OperatorStatus:
    return {"FINISHED"} if "FINISHED" in status else {"CANCELLED"}
