# A temporary folder, `$folder`, and pinned public packages in it: every script of this folder sources this file.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Installs packages of Python into an environment, whose interpreter is `$folder/env/bin/python`.
python_packages() {
    "${PYTHON:-python3.11}" -m venv "$folder/env"
    "$folder/env/bin/pip" install --quiet --no-compile "$@"
}

# Installs packages of npm into the folder, and goes there.
npm_packages() {
    cd "$folder"
    npm install --silent --no-audit --no-fund "$@" >npm.log
}

# Starts a crate in the folder, and goes there: its name, then a line of `Cargo.toml` for each dependency.
crate() {
    cd "$folder"
    mkdir src
    printf '[package]\nname = "%s"\nversion = "0.0.0"\nedition = "2024"\n\n[dependencies]\n' "$1" >Cargo.toml
    printf '%s\n' "${@:2}" >>Cargo.toml
}
