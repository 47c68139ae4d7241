"""Compiles HLSL with DXC: dxc.py LIBRARY FILE PROFILE ENTRY. Includes are looked up in the current folder.

Prints what the compiler says and fails where it finds errors. DXC is a library of COM objects: the first word of an
object points at its methods, which are called here by their places (dxcapi.h, of the release of July 2022).
"""

import ctypes
import sys
import uuid

library, file, profile, entry = sys.argv[1:]
dxc = ctypes.CDLL(library)


def guid(text):
    return ctypes.create_string_buffer(uuid.UUID(text).bytes_le, 16)


def call(thing, place, *arguments, result=ctypes.c_int32):
    table = ctypes.cast(thing, ctypes.POINTER(ctypes.POINTER(ctypes.c_void_p)))[0]
    # Outside Windows IUnknown has a destructor, which takes two places: methods start at 5.
    method = ctypes.CFUNCTYPE(result, ctypes.c_void_p, *map(type, arguments))(table[5 + place])
    return method(thing, *arguments)


def create(kind, interface):
    thing = ctypes.c_void_p()
    code = dxc.DxcCreateInstance(guid(kind), guid(interface), ctypes.byref(thing))
    assert code == 0, f"DxcCreateInstance: {code & 0xFFFFFFFF:#x}"
    return thing


class Buffer(ctypes.Structure):
    _fields_ = [("text", ctypes.c_char_p), ("size", ctypes.c_size_t), ("encoding", ctypes.c_uint32)]


def pointer(thing):
    return ctypes.cast(ctypes.pointer(thing), ctypes.c_void_p)


utils = create("6245d6af-66e0-48fd-80b4-4d271796748c", "4605c4cb-2019-492a-ada4-65f20bb7d67f")
handler = ctypes.c_void_p()
assert call(utils, 6, pointer(handler)) == 0, "CreateDefaultIncludeHandler failed"
compiler = create("73e22d93-e6ce-47f3-b5bf-f0664f39c1b0", "228b4687-5a6a-4730-900c-9702b2203f54")
with open(file, "rb") as source:
    text = source.read()
words = ["-T", profile, "-E", entry, "-I", "."]
outcome = ctypes.c_void_p()
interface = guid("58346cda-dde7-4497-9461-6f87af5e0659")
code = call(
    compiler,
    0,
    pointer(Buffer(text, len(text), 65001)),
    ctypes.cast((ctypes.c_wchar_p * len(words))(*words), ctypes.c_void_p),
    ctypes.c_uint32(len(words)),
    handler,
    ctypes.cast(interface, ctypes.c_void_p),
    pointer(outcome),
)
assert code == 0, f"Compile: {code & 0xFFFFFFFF:#x}"
status, messages = ctypes.c_int32(-1), ctypes.c_void_p()
assert call(outcome, 0, pointer(status)) == 0, "GetStatus failed"
assert call(outcome, 2, pointer(messages)) == 0, "GetErrorBuffer failed"
if messages:
    start = call(messages, 0, result=ctypes.c_void_p)
    size = call(messages, 1, result=ctypes.c_size_t)
    lines = ctypes.string_at(start, size).decode(errors="replace").rstrip("\0\n ").splitlines()
    print("\n".join(line for line in lines if "DXIL.dll not found" not in line))
sys.exit(0 if status.value == 0 else 1)
