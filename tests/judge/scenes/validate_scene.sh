# validate_scene.sh LANCER SCENE: does POV-Ray agree? Skipped (77), and says so, where there is none.
if ! command -v "${LANCER_POVRAY:-povray}" >/dev/null; then
    echo "NOT TESTED: $2 needs POV-Ray"
    exit 77
fi
exec "$1" validate "$2"
