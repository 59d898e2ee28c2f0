# Sourced by the other scripts: `prepare EXTRAS` makes or mends .venv in the project's folder and installs the project.
# POSIX sh. Stands a moved folder, spaces in its path and any number of runs.

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P) || exit 1
cd "$root" || exit 1
venv=$root/.venv

say() { printf '%s\n' "$*" >&2; }

find_python() {
  for name in ${HULLFORM_PYTHON:-} python3 python3.14 python3.13 python3.12 python3.11 python; do
    command -v "$name" >/dev/null 2>&1 || continue
    "$name" -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1 || continue
    command -v "$name"
    return 0
  done
  say 'No Python 3.11 or newer with the venv module was found.'
  say 'Install one (Debian, Ubuntu: apt install python3 python3-venv; Fedora: dnf install python3; macOS: brew install python),'
  say 'or name one in the variable HULLFORM_PYTHON, and run this again.'
  return 1
}

prepare() {
  extras=$1
  # A virtual environment knows its own path; what it was made for and from is kept beside it.
  place="$root|$(cksum <"$root/pyproject.toml")"
  made_for=$(cat "$venv/made-for" 2>/dev/null || true)
  if [ "$made_for" != "$place" ] || ! "$venv/bin/python" -c '' 2>/dev/null; then
    python=$(find_python) || exit 1
    say "Making the virtual environment .venv with $python ..."
    rm -rf "$venv"
    "$python" -m venv "$venv" || { say 'The virtual environment could not be made; see above.'; exit 1; }
    printf '%s' "$place" >"$venv/made-for"
  fi
  # Any set of extras holds the project itself.
  for have in "$venv/has-$extras"*; do
    [ -f "$have" ] && return 0
  done
  say "Installing the project${extras:+ with its '$extras' tools} into .venv ..."
  if ! "$venv/bin/python" -m pip install --quiet --disable-pip-version-check --editable "$root${extras:+[$extras]}" >&2; then
    say 'The installation failed; see above. It needs the Python package index: check the connection and run this again.'
    exit 1
  fi
  : >"$venv/has-$extras"
}
