#!/usr/bin/env bash
# The same steps, events and numbers on 1, 2 and 3 processes: plane, implicit and event, space.
. tests/support/mpi.sh
PYTHONPATH=tests/support exec "$PYTHON" -B tests/mpi/same_numbers.py "$SCRATCH"
