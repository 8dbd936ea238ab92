#!/usr/bin/env python3
"""clean_root.py ROOT [--with PACKAGE]... DEB...: makes the folder ROOT a small Debian of its own, into which dpkg can
install the DEBs: Debian's essential packages, what the DEBs depend on and all PACKAGEs, and nothing else.

It is made of the files of this machine's packages, so that it needs no network and a few seconds. Exit code 1, with
the reason, where something that is depended on is not installed here.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys

DATABASE = "/var/lib/dpkg"


def paragraphs(text):
    """Of a control file, each as a dictionary with the text itself under ''."""
    for paragraph in text.strip().split("\n\n"):
        fields = {"": paragraph}
        for name, value in re.findall(r"^([A-Za-z-]+): *(.*(?:\n[ \t].*)*)", paragraph, re.M):
            fields[name] = value
        yield fields


def names_in(relation):
    """`a (>= 1) | b:any` -> ['a', 'b']"""
    return [re.split(r"[\s(:\[]", name.strip())[0] for name in relation.split("|")]


def relations(fields):
    for field in ("Pre-Depends", "Depends"):
        for relation in fields.get(field, "").split(","):
            if relation.strip():
                yield names_in(relation)


def closure(installed, providers, wanted, brought):
    """All that the packages `wanted` need, by the relations of each; `brought` comes later."""
    found, open_ones = {}, list(wanted)
    while open_ones:
        for relation in relations(open_ones.pop()):
            if any(name in brought for name in relation):
                continue
            candidates = [name for name in relation if name in installed]
            candidates += [provider for name in relation for provider in providers.get(name, [])]
            if not candidates:
                sys.exit(f"clean_root.py: not installed here: {' | '.join(relation)}")
            if not any(candidate in found for candidate in candidates):
                found[candidates[0]] = installed[candidates[0]]
                open_ones.append(installed[candidates[0]])
    return found


def files_of(name, fields):
    for stem in (name, f"{name}:{fields['Architecture']}"):
        listing = f"{DATABASE}/info/{stem}.list"
        if os.path.exists(listing):
            with open(listing) as file:
                return stem, file.read().splitlines()
    sys.exit(f"clean_root.py: {name} has no list of files")


def copy_files(root, packages):
    for folder in ("bin", "sbin", "lib", "lib64"):   # as Debian has them since 12
        os.makedirs(f"{root}/usr/{folder}", exist_ok=True)
        os.symlink(f"usr/{folder}", f"{root}/{folder}")
    names = ["/etc/passwd", "/etc/group", "/etc/ld.so.conf", "/etc/alternatives", "/etc/debian_version"]
    names += [f"/etc/alternatives/{name}" for name in os.listdir("/etc/alternatives")]
    for name, fields in packages.items():
        stem, files = files_of(name, fields)
        names += files
        information = f"{DATABASE}/info/"
        names += [information + file for file in os.listdir(information) if file.startswith(stem + ".")]
    spared = tuple(f"/usr/share/{folder}/" for folder in ("doc", "info", "locale", "man"))
    names = sorted({name for name in names
                    if os.path.lexists(name) and name != "/." and not name.startswith(spared)})
    # Large files are libraries, which are never changed: a hard link is enough where the folder
    # allows it.
    copied = [name for name in names if not link_large(name, root + name)]
    pack = subprocess.Popen(["tar", "-C", "/", "--no-recursion", "-cf", "-", "-T", "-"], stdin=subprocess.PIPE,
                            stdout=subprocess.PIPE)
    unpack = subprocess.Popen(["tar", "-C", root, "--keep-directory-symlink", "-xpf", "-"], stdin=pack.stdout)
    pack.stdin.write("".join("." + name + "\n" for name in copied).encode())
    pack.stdin.close()
    if pack.wait() or unpack.wait():
        sys.exit("clean_root.py: copying failed")


def link_large(name, other_name):
    if not name.startswith(("/usr/lib/", "/lib/")) or os.path.islink(name) or not os.path.isfile(name):
        return False
    if os.path.getsize(name) < 100_000:
        return False
    try:
        os.makedirs(os.path.dirname(other_name), exist_ok=True)
        os.link(name, other_name)
    except OSError:
        return False
    return True


def link_alternatives(root):
    """The links of alternatives whose files are there; no package has them in its list."""
    folder = "/var/lib/dpkg/alternatives"
    os.makedirs(root + folder, exist_ok=True)
    for name in os.listdir(folder):
        with open(f"{folder}/{name}") as file:
            link = file.read().splitlines()[1]
        if os.path.islink(link) and os.path.lexists(root + os.path.realpath(link)):
            os.makedirs(os.path.dirname(root + link), exist_ok=True)
            if not os.path.lexists(root + link):
                os.symlink(os.readlink(link), root + link)
            shutil.copy(f"{folder}/{name}", root + folder)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root")
    parser.add_argument("--with", dest="also", action="append", default=[])
    parser.add_argument("debs", nargs="+")
    arguments = parser.parse_args()
    with open(f"{DATABASE}/status") as file:
        installed = {fields["Package"]: fields for fields in paragraphs(file.read())
                     if fields["Status"].endswith(" installed")}
    providers = {}
    for name, fields in installed.items():
        for provided in fields.get("Provides", "").split(","):
            providers.setdefault(names_in(provided)[0], []).append(name)
    debs = [next(paragraphs(subprocess.run(["dpkg-deb", "-f", deb], check=True, capture_output=True,
                                           text=True).stdout)) for deb in arguments.debs]
    essential = [name for name, fields in installed.items() if fields.get("Essential") == "yes"]
    wish = {"": "", "Depends": ", ".join(essential + arguments.also)}
    packages = closure(installed, providers, [wish] + debs, {deb["Package"] for deb in debs})
    copy_files(arguments.root, packages)
    link_alternatives(arguments.root)
    with open(f"{arguments.root}{DATABASE}/status", "w") as file:
        file.write("".join(fields[""] + "\n\n" for fields in packages.values()))
    for folder in ("updates", "triggers"):
        os.makedirs(f"{arguments.root}{DATABASE}/{folder}", exist_ok=True)
    for folder in ("dev", "proc", "tmp", "var/log", "var/cache/ldconfig"):
        os.makedirs(f"{arguments.root}/{folder}", exist_ok=True)
    os.chmod(f"{arguments.root}/tmp", 0o1777)
    print(f"{len(packages)} packages")


main()
