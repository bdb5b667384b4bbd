"""Which haptic devices the system knows of: for bug reports and hints; nothing is opened or claimed."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

MAKERS = {
    0x0403: "FTDI (in the Novint Falcon)",
    0x046D: "Logitech (3Dconnexion before 2013)",
    0x1451: "Force Dimension",
    0x256F: "3Dconnexion",
    0x2988: "3D Systems (Touch)",
}
"""By USB vendor number. What else is plugged in is nobody's business, so it is not listed."""

FALCON = (0x0403, 0xCB48)


@dataclass(frozen=True)
class Attached:
    """A device of a maker of haptic devices."""

    through: str
    """The library that found it."""
    vendor: int
    product: int
    name: str

    def __str__(self) -> str:
        return f"{self.vendor:04x}:{self.product:04x} {self.name} ({self.through})"


def attached() -> list[Attached]:
    """Every device of a known maker, once for each library that sees it."""
    return [device for find in (_through_hid, _through_usb) for device in find()]


def problems() -> list[str]:
    """Why devices of a kind cannot be found, in words."""
    found = []
    for name, find in (("hidapi", _hid_module), ("pyusb", _usb_devices)):
        try:
            find()
        except Exception as error:  # libraries of the system's: each fails in its own way
            found.append(f"{name}: {type(error).__name__}: {error}")
    return found


def _through_hid() -> Iterator[Attached]:
    try:
        devices = _hid_module().enumerate()
    except Exception:
        return  # ``problems`` tells
    seen = set()
    for device in devices:
        numbers = device["vendor_id"], device["product_id"]
        if numbers[0] in MAKERS and numbers not in seen:
            seen.add(numbers)
            yield Attached("hidapi", *numbers, device["product_string"] or MAKERS[numbers[0]])


def _through_usb() -> Iterator[Attached]:
    try:
        devices = _usb_devices()
    except Exception:
        return
    for device in devices:
        numbers = device.idVendor, device.idProduct
        if numbers[0] in MAKERS:
            # Its name would have to be asked for, which needs rights and may disturb who uses it.
            name = "Novint Falcon" if numbers == FALCON else MAKERS[numbers[0]]
            yield Attached("pyusb", *numbers, name)


def _hid_module() -> Any:
    """hidapi's module that leaves the kernel's driver alone, where there is a choice."""
    try:
        return importlib.import_module("hidraw")  # Linux only
    except ImportError:
        return importlib.import_module("hid")


def _usb_devices() -> list[Any]:
    """All USB devices, by the libusb that is bundled."""
    import libusb_package
    import usb.core

    return list(usb.core.find(find_all=True, backend=libusb_package.get_libusb1_backend()))
