# SPDX-License-Identifier: GPL-3.0-or-later
#
# by_ctypes.py <DECK - the largest torque for three cranks, and the size of the table, by the functions of FORTRAN 77.
import ctypes as c
import sys
import numpy as np

lib = c.CDLL("libfourlink.so")  # or its path
handle, status, message = c.c_void_p(), c.c_int(), c.create_string_buffer(80)

def call(function, *arguments):  # the lengths of texts follow the other arguments
    lengths = [c.c_ulong(len(a)) for a in arguments if isinstance(a, bytes) or a is message]
    function(c.byref(handle), *arguments, *lengths)
    if status.value:
        raise ValueError(message.raw.decode().strip() or f"status {status.value}")

def value(name, branch=1, angle=0.0):
    x = c.c_double()
    call(lib.flval_, name.encode(), c.byref(c.c_int(branch)), c.byref(c.c_double(angle)), c.byref(x), c.byref(status))
    return x.value

def table(branch=1):
    rows, columns = c.c_int(), c.c_int()
    lib.flnrow_(c.byref(handle), c.byref(rows), c.byref(columns))
    values = np.empty((rows.value, columns.value))
    for i, row in enumerate(values):  # NaN where a column has no value
        lib.flrow_(c.byref(handle), c.byref(c.c_int(branch)), c.byref(c.c_int(i + 1)), c.byref(columns),
                   row.ctypes.data_as(c.c_void_p), c.byref(status))
    return values

deck = sys.stdin.buffer.read()
lib.flopen_(deck, c.byref(handle), c.byref(status), message, c.c_ulong(len(deck)), c.c_ulong(80))
for length in 0.018, 0.020, 0.022:
    call(lib.flset_, b"crank.length", c.byref(c.c_double(length)), c.byref(status), message)
    print(f"{length:.3f} m: max(Ts) = {value('max(Ts)'):.9f} N.m")
print(table().shape)
