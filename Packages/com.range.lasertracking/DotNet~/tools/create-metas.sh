#!/usr/bin/env bash
# Gives every file and folder that Unity sees and that has no .meta yet one, the samples' too, which it sees once imported. The GUID
# is derived from the path at birth and never changes afterwards: scenes refer to scripts through it, so move a file together with
# its .meta.
set -euo pipefail
root=$(cd "$(dirname "$0")/../../../.." && pwd)
cd "$root"
find Packages/com.range.lasertracking 'Packages/com.range.lasertracking/Samples~' Assets -mindepth 1 \( -name '.*' -o -name '*~' \) -prune -o -print 2>/dev/null | LC_ALL=C sort | while read -r path; do
  case "$path" in *.meta) continue ;; esac
  meta="$path.meta"
  [ -e "$meta" ] && continue
  guid=$(printf 'com.range.lasertracking:%s' "$path" | md5sum | cut -c1-32)
  {
    printf 'fileFormatVersion: 2\nguid: %s\n' "$guid"
    if [ -d "$path" ]; then printf 'folderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n'
    else case "$path" in
      *.cs) printf 'MonoImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n  icon: {instanceID: 0}\n' ;;
      *.asmdef) printf 'AssemblyDefinitionImporter:\n  externalObjects: {}\n' ;;
      */package.json) printf 'PackageManifestImporter:\n  externalObjects: {}\n' ;;
      *.asset | *.mat) printf 'NativeFormatImporter:\n  externalObjects: {}\n  mainObjectFileID: %s\n' "$(case "$path" in *.mat) echo 2100000 ;; *) echo 11400000 ;; esac)" ;;
      *.md | *.json | *.txt) printf 'TextScriptImporter:\n  externalObjects: {}\n' ;;
      *.prefab) printf 'PrefabImporter:\n  externalObjects: {}\n' ;;
      *.tss) printf 'ScriptedImporter:\n  internalIDToNameTable: []\n  externalObjects: {}\n  serializedVersion: 2\n' ;;
      *) printf 'DefaultImporter:\n  externalObjects: {}\n' ;;
    esac; fi
    printf '  userData: \n  assetBundleName: \n  assetBundleVariant: \n'
    case "$path" in *.tss) printf '  script: {fileID: 12388, guid: 0000000000000000e000000000000000, type: 0}\n  disableValidation: 0\n' ;; esac
  } > "$meta"
  echo "$meta"
done
