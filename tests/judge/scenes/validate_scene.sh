# validate_scene.sh LANCER SCENE: checks that POV-Ray agrees. Skipped (77) with a message when there
# is no POV-Ray.
if ! command -v "${LANCER_POVRAY:-povray}" >/dev/null; then
    echo "NOT TESTED: $2 needs POV-Ray"
    exit 77
fi
exec "$1" validate "$2"
